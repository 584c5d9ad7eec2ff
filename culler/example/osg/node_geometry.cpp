// SPDX-License-Identifier: MIT
#include "node_geometry.h"

#include <array>
#include <cstdint>
#include <map>
#include <osg/AutoTransform>
#include <osg/Billboard>
#include <osg/Camera>
#include <osg/ClipNode>
#include <osg/Geometry>
#include <osg/LOD>
#include <osg/LightSource>
#include <osg/MatrixTransform>
#include <osg/PagedLOD>
#include <osg/PositionAttitudeTransform>
#include <osg/Projection>
#include <osg/ProxyNode>
#include <osg/Sequence>
#include <osg/StateSet>
#include <osg/Switch>
#include <osg/TexGenNode>
#include <osg/TriangleFunctor>
#include <utility>
#include <vector>

namespace occlude::example {
namespace {

/// Whether what is drawn with this state covers each pixel of its triangles, from both sides and to a depth of their own.
bool is_opaque(const osg::StateSet* state) {
  if (state == nullptr) return true;
  if (state->getRenderingHint() == osg::StateSet::TRANSPARENT_BIN) return false;
  const auto is_on = [&](int mode) {
    return (state->getMode(static_cast<osg::StateAttribute::GLMode>(mode)) & osg::StateAttribute::ON) != 0;
  };
  for (const int mode : {GL_BLEND, GL_ALPHA_TEST, GL_CULL_FACE, GL_POLYGON_STIPPLE, GL_STENCIL_TEST}) {
    if (is_on(mode)) return false;
  }
  for (const auto type : {osg::StateAttribute::PROGRAM, osg::StateAttribute::POLYGONMODE, osg::StateAttribute::COLORMASK,
                          osg::StateAttribute::DEPTH, osg::StateAttribute::POLYGONOFFSET}) {
    if (state->getAttribute(type) != nullptr) return false;
  }
  return true;
}

/// Gives each triangle to `soup`, placed by `place`.
struct AddTriangles {
  using Corner = std::array<double, 3>;

  void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c) {
    soup->add_polygon(std::array{vertex(a), vertex(b), vertex(c)});
  }
  std::uint32_t vertex(const osg::Vec3& corner) {
    const osg::Vec3d at = osg::Vec3d(corner) * place;
    const auto [found, is_new] = known->try_emplace({at.x(), at.y(), at.z()}, 0);
    if (is_new) found->second = soup->add_vertex({at.x(), at.y(), at.z()});
    return found->second;
  }

  osg::Matrixd place;
  culler::PolygonSoup* soup = nullptr;
  std::map<Corner, std::uint32_t>* known = nullptr;
};

class Gather : public osg::NodeVisitor {
 public:
  explicit Gather(osg::Node& top) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), top_(&top) {
    setNodeMaskOverride(~osg::Node::NodeMask{0});  // what is masked now may be drawn later
  }

  NodeGeometry& found() { return found_; }

  void apply(osg::Drawable& drawable) override {
    const osg::BoundingBox& box = drawable.getBoundingBox();  // of single precision, as the vertices: exact
    if (!box.valid()) return;
    if (may_change(drawable)) found_.is_bounded = false;
    for (unsigned int i = 0; i < 8; ++i) found_.bounds.expandBy(osg::Vec3d(box.corner(i)) * place_.back());
    if (osg::Geometry* const geometry = drawable.asGeometry(); geometry != nullptr && hides(*geometry)) {
      osg::TriangleFunctor<AddTriangles> add;
      add.place = place_.back();
      add.soup = &found_.opaque;
      add.known = &known_;
      geometry->accept(add);
    }
  }
  void apply(osg::Geometry& geometry) override { apply(static_cast<osg::Drawable&>(geometry)); }

  void apply(osg::Node& node) override { descend(node, true); }
  // What these show depends on the frame.
  void apply(osg::Switch& node) override { descend(node, false); }
  void apply(osg::LOD& node) override { descend(node, false); }
  void apply(osg::Sequence& node) override { descend(node, false); }

  void apply(osg::MatrixTransform& node) override { descend_transform(node); }
  void apply(osg::PositionAttitudeTransform& node) override { descend_transform(node); }
  // These stand elsewhere for each camera, or load what they draw later.
  void apply(osg::Transform&) override { found_.is_bounded = false; }
  void apply(osg::AutoTransform&) override { found_.is_bounded = false; }
  void apply(osg::Camera&) override { found_.is_bounded = false; }
  void apply(osg::Projection&) override { found_.is_bounded = false; }
  void apply(osg::Billboard&) override { found_.is_bounded = false; }
  void apply(osg::ProxyNode&) override { found_.is_bounded = false; }
  void apply(osg::PagedLOD&) override { found_.is_bounded = false; }
  // These change how others are drawn, so they must be there in each frame.
  void apply(osg::ClipNode&) override { found_.is_bounded = false; }
  void apply(osg::LightSource&) override { found_.is_bounded = false; }
  void apply(osg::TexGenNode&) override { found_.is_bounded = false; }

 private:
  void descend(osg::Node& node, bool is_all_drawn) {
    const bool outside = is_hiding_;
    is_hiding_ = outside && is_all_drawn && is_opaque(node.getStateSet()) && node.getCullCallback() == nullptr &&
                 node.getNodeMask() == ~osg::Node::NodeMask{0};
    traverse(node);
    is_hiding_ = outside;
  }

  void descend_transform(osg::Transform& node) {
    if (node.getReferenceFrame() != osg::Transform::RELATIVE_RF) {
      found_.is_bounded = false;
      return;
    }
    osg::Matrixd place = place_.back();
    if (&node != top_) {
      node.computeLocalToWorldMatrix(place, this);
      // What moves within the subtree is not where it was found.
      if (may_change(node)) found_.is_bounded = false;
    }
    place_.push_back(place);
    descend(node, &node == top_ || !may_change(node));
    place_.pop_back();
  }

  [[nodiscard]] bool hides(const osg::Geometry& geometry) const {
    return is_hiding_ && is_opaque(geometry.getStateSet()) && geometry.getCullCallback() == nullptr &&
           geometry.getDrawCallback() == nullptr && geometry.getNodeMask() == ~osg::Node::NodeMask{0} &&
           !may_change(geometry);
  }

  osg::Node* top_;
  NodeGeometry found_;
  std::map<AddTriangles::Corner, std::uint32_t> known_;
  std::vector<osg::Matrixd> place_ = {osg::Matrixd::identity()};
  bool is_hiding_ = true;
};

}  // namespace

bool may_change(const osg::Node& node) {
  return node.getDataVariance() == osg::Object::DYNAMIC || node.getUpdateCallback() != nullptr;
}

NodeGeometry geometry_of(osg::Node& node) {
  Gather gather(node);
  node.accept(gather);
  return std::move(gather.found());
}

}  // namespace occlude::example
