// SPDX-License-Identifier: MIT
// OpenSceneGraph: the tree as a scene graph, with occluder nodes for the largest convex regions of the model.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <osg/CollectOccludersVisitor>
#include <osg/Drawable>
#include <osg/Group>
#include <osg/OccluderNode>
#include <osg/Viewport>
#include <osgUtil/CullVisitor>
#include <osgUtil/RenderStage>
#include <osgUtil/StateGraph>

#include "frusta/potential_occluders.h"
#include "rivals.h"

namespace occlude::experiments {
namespace {

using culler::Camera;
using culler::Hierarchy;
using culler::PotentialOccluders;

/// Occluder nodes in the graph. It was made for a few that are placed by hand; each frame it looks at all of them.
constexpr std::size_t kNodes = 1024;
/// The planes of an occluder are bits of a word of 32, one of which is for the plane of the polygon.
constexpr std::size_t kMostSides = 31;
/// Occluders that a frame uses at most: none, the default, and many.
constexpr unsigned int kActive[] = {0, 10, 64};

class Leaf : public osg::Drawable {
 public:
  Leaf(std::uint32_t node, const osg::BoundingBox& box) : node_(node), box_(box) {}
  [[nodiscard]] std::uint32_t node() const { return node_; }
  osg::BoundingBox computeBoundingBox() const override { return box_; }

 private:
  std::uint32_t node_;
  osg::BoundingBox box_;
};

/// Bounded by the sphere around its box, which is smaller than that around its children's.
class Inner : public osg::Group {
 public:
  explicit Inner(const osg::BoundingBox& box) : sphere_(box) {}
  osg::BoundingSphere computeBound() const override { return sphere_; }

 private:
  osg::BoundingSphere sphere_;
};

class OccluderNodes : public VisibilityWay {
 public:
  OccluderNodes(const Hierarchy& tree, unsigned int active)
      : tree_(tree),
        has_occluders_(active > 0),
        centre_(middle(tree.nodes()[0].box)),
        radius_(osg::BoundingSphere(box_of(0)).radius()),
        root_(new osg::Group),
        collect_(new osg::CollectOccludersVisitor),
        cull_(osgUtil::CullVisitor::create()),
        graph_(new osgUtil::StateGraph),
        stage_(new osgUtil::RenderStage),
        viewport_(new osg::Viewport(0, 0, 1, 1)) {
    if (has_occluders_) add_occluders();
    root_->addChild(subgraph(0));
    root_->getBound();  // computes all
    collect_->setMaximumNumberOfActiveOccluders(active);
    for (osg::CullSettings* const settings :
         {static_cast<osg::CullSettings*>(collect_), static_cast<osg::CullSettings*>(cull_)}) {
      // Not of small features, which it leaves out though they show.
      settings->setCullingMode(osg::CullSettings::VIEW_FRUSTUM_CULLING | osg::CullSettings::SHADOW_OCCLUSION_CULLING);
      settings->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    }
  }

  void cull(const Camera& camera) override {
    const osg::ref_ptr<osg::RefMatrix> view = new osg::RefMatrix(view_of(camera));
    const osg::ref_ptr<osg::RefMatrix> projection = new osg::RefMatrix(projection_of(camera));
    cull_->reset();
    cull_->setStateGraph(graph_);
    cull_->setRenderStage(stage_);
    stage_->reset();
    graph_->clean();
    if (has_occluders_) choose_occluders(view, projection);
    traverse(*cull_, view, projection);
    stage_->sort();
  }

  [[nodiscard]] std::vector<culler::PolygonRange> drawn() const override {
    std::vector<culler::PolygonRange> ranges;
    for (const auto& leaf : graph_->_leaves) {
      const culler::HierarchyNode& node = tree_.nodes()[static_cast<const Leaf*>(leaf->getDrawable())->node()];
      ranges.push_back({node.first, node.count});
    }
    std::ranges::sort(ranges, {}, &culler::PolygonRange::first);
    return ranges;
  }

 private:
  static osg::Vec3d middle(const kernel::Aabb& box) {
    return osg::Vec3d(box.min.x + box.max.x, box.min.y + box.max.y, box.min.z + box.max.z) / 2;
  }
  /// Relative to the middle of the model, where the single precision of boxes and occluders is finest.
  [[nodiscard]] osg::Vec3d local(double x, double y, double z) const { return osg::Vec3d(x, y, z) - centre_; }
  [[nodiscard]] osg::Vec3d local(const glm::dvec3& v) const { return local(v.x, v.y, v.z); }

  [[nodiscard]] osg::BoundingBox box_of(std::uint32_t node) const {
    const auto& [min, max] = tree_.nodes()[node].box;
    return {local(min.x, min.y, min.z), local(max.x, max.y, max.z)};
  }

  osg::ref_ptr<osg::Node> subgraph(std::uint32_t node) const {
    const culler::HierarchyNode& here = tree_.nodes()[node];
    if (here.is_leaf()) return new Leaf(node, box_of(node));
    osg::ref_ptr<osg::Group> group = new Inner(box_of(node));
    group->addChild(subgraph(node + 1));
    group->addChild(subgraph(here.right));
    return group;
  }

  void add_occluders() {
    const PotentialOccluders all = PotentialOccluders::find(tree_.shared_soup(), {.shells = false});
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (all.container(i) == i && all.loop(i).size() <= kMostSides) order.push_back(i);
    }
    std::ranges::sort(order, std::greater{}, [&](std::uint32_t i) { return all[i].area(); });
    std::size_t added = 0;
    for (std::size_t k = 0; k < order.size() && added < kNodes; ++k) {
      if (!is_convex(all, order[k])) continue;
      root_->addChild(occluder(all, order[k]));
      ++added;
    }
  }

  /// Whether it has a shadow when it is seen from straight before it.
  static bool is_convex(const PotentialOccluders& all, std::uint32_t i) {
    const glm::dvec3& normal = all[i].area_normal;
    const auto shadow = all.shadow(i, kernel::Viewpoint::direction({normal.x, normal.y, normal.z}), kernel::Near::surface);
    return shadow.frustum.has_value();
  }

  osg::ref_ptr<osg::OccluderNode> occluder(const PotentialOccluders& all, std::uint32_t i) const {
    osg::ConvexPlanarPolygon polygon;
    for (const std::uint32_t vertex : all.loop(i)) polygon.add(osg::Vec3(local(all.soup().vertices[vertex])));
    osg::ref_ptr<osg::ConvexPlanarOccluder> planar = new osg::ConvexPlanarOccluder;
    planar->setOccluder(polygon);
    osg::ref_ptr<osg::OccluderNode> node = new osg::OccluderNode;
    node->setOccluder(planar);
    return node;
  }

  [[nodiscard]] osg::Matrixd view_of(const Camera& camera) const {
    return osg::Matrixd::lookAt(local(camera.eye), local(camera.target), {camera.up.x, camera.up.y, camera.up.z});
  }

  /// Without a far plane of the camera's there is one behind the model.
  [[nodiscard]] osg::Matrixd projection_of(const Camera& camera) const {
    const double behind = local(camera.eye).length() + 2 * radius_ + camera.near_plane;
    const double far = std::isinf(camera.far_plane) ? behind : camera.far_plane;
    if (camera.projection == culler::Projection::perspective) {
      return osg::Matrixd::perspective(camera.fov_y_deg, camera.aspect, camera.near_plane, far);
    }
    const double up = camera.height / 2, right = up * camera.aspect;
    return osg::Matrixd::ortho(-right, right, -up, up, camera.near_plane, far);
  }

  void choose_occluders(osg::RefMatrix* view, osg::RefMatrix* projection) {
    collect_->reset();
    traverse(*collect_, view, projection);
    collect_->removeOccludedOccluders();
    const auto& chosen = collect_->getCollectedOccluderSet();
    cull_->getOccluderList().assign(chosen.begin(), chosen.end());
  }

  template <class Visitor>
  void traverse(Visitor& visitor, osg::RefMatrix* view, osg::RefMatrix* projection) {
    visitor.pushViewport(viewport_);
    visitor.pushProjectionMatrix(projection);
    visitor.pushModelViewMatrix(view, osg::Transform::ABSOLUTE_RF);
    root_->accept(visitor);
    visitor.popModelViewMatrix();
    visitor.popProjectionMatrix();
    visitor.popViewport();
  }

  const Hierarchy& tree_;
  bool has_occluders_;
  osg::Vec3d centre_;
  double radius_;
  osg::ref_ptr<osg::Group> root_;
  osg::ref_ptr<osg::CollectOccludersVisitor> collect_;
  osg::ref_ptr<osgUtil::CullVisitor> cull_;
  osg::ref_ptr<osgUtil::StateGraph> graph_;
  osg::ref_ptr<osgUtil::RenderStage> stage_;
  osg::ref_ptr<osg::Viewport> viewport_;
};

}  // namespace

std::vector<UnpreparedWay> osg_ways(const Hierarchy& tree) {
  std::vector<UnpreparedWay> ways;
  for (const unsigned int active : kActive) {
    const std::string what = active == 0 ? "view frustum alone" : fmt::format("the {} best occluders", active);
    ways.push_back({"OpenSceneGraph", "OpenSceneGraph, " + what,
                    [&tree, active] { return std::make_unique<OccluderNodes>(tree, active); }});
  }
  return ways;
}

}  // namespace occlude::experiments
