// SPDX-License-Identifier: MIT
#include "node_scene.h"

#include <algorithm>
#include <memory>
#include <osg/Transform>
#include <typeinfo>
#include <utility>

#include "node_geometry.h"

namespace occlude::example {
namespace {

using culler::Box;
using culler::MatrixCamera;
using culler::ObjectId;

kernel::Vec3 to_occlude(const osg::Vec3d& v) { return {v.x(), v.y(), v.z()}; }

/// Of the three sides of a box, the second longest.
double middle_side(const osg::BoundingBoxd& bounds) {
  const osg::Vec3d size = bounds._max - bounds._min;
  return std::max(std::min(size.x(), size.y()), std::min(std::max(size.x(), size.y()), size.z()));
}

/// Where the coordinates below a node are in those above it.
osg::Matrixd place_of(osg::Node& node) {
  osg::Matrixd place;
  if (osg::Transform* const transform = node.asTransform()) transform->computeLocalToWorldMatrix(place, nullptr);
  return place;
}

/// A group that only holds others.
osg::Group* holder(osg::Node& node) {
  const bool is_plain = typeid(node) == typeid(osg::Group) && node.getStateSet() == nullptr &&
                        node.getCullCallback() == nullptr && node.getNodeMask() == ~osg::Node::NodeMask{0};
  return is_plain ? node.asGroup() : nullptr;
}

}  // namespace

NodeScene::NodeScene(osg::Group& group, const NodeSceneOptions& options) : options_(options) {
  add_below(group);
  scene_.update();
}

void NodeScene::add_below(osg::Group& group) {
  for (unsigned int i = 0; i < group.getNumChildren(); ++i) {
    osg::Node& child = *group.getChild(i);
    if (osg::Group* const inner = holder(child)) {
      add_below(*inner);
    } else {
      add(child);
    }
  }
}

ObjectId NodeScene::add(osg::Node& node) {
  NodeGeometry geometry = geometry_of(node);
  const bool moves = may_change(node);
  Mirrored mirrored{&node, geometry.bounds, place_of(node), {}};
  const bool is_bounded = geometry.is_bounded && geometry.bounds.valid();
  const ObjectId object = scene_.add(box_of(mirrored), {.moves = moves, .is_always_drawn = !is_bounded});
  if (!geometry.opaque.empty() && middle_side(geometry.bounds) >= options_.least_occluder) {
    // Tied to the object: it hides only in frames that draw this object, or hide it.
    mirrored.occluder = scene_.add(std::make_shared<culler::OccluderMesh>(std::move(geometry.opaque)),
                                   placement_of(mirrored), {.moves = moves, .object = object});
  }
  if (mirrored_.size() <= object.slot()) mirrored_.resize(object.slot() + std::size_t{1});
  mirrored_[object.slot()] = std::move(mirrored);
  if (moves) followed_.push_back(object);
  return object;
}

void NodeScene::remove(ObjectId object) {
  Mirrored& mirrored = mirrored_[object.slot()];
  scene_.remove(object);
  if (!mirrored.occluder.is_none()) scene_.remove(mirrored.occluder);
  mirrored = {};
  std::erase(followed_, object);
}

/// The box around what the node draws, turned with the node. It is a few roundings of doubles beside the exact place, which
/// is far less than the margin.
Box NodeScene::box_of(const Mirrored& mirrored) const {
  if (!mirrored.bounds.valid()) return kernel::Aabb{};
  const osg::BoundingBoxd& bounds = mirrored.bounds;
  if (mirrored.place.isIdentity()) return kernel::Aabb{to_occlude(bounds._min), to_occlude(bounds._max)};
  const osg::Vec3d half = (bounds._max - bounds._min) / 2;
  const auto half_edge = [&](const osg::Vec3d& along) {
    return to_occlude(osg::Matrixd::transform3x3(along, mirrored.place));
  };
  return kernel::Obb{to_occlude(bounds.center() * mirrored.place),
                     {half_edge({half.x(), 0, 0}), half_edge({0, half.y(), 0}), half_edge({0, 0, half.z()})}};
}

culler::Placement NodeScene::placement_of(const Mirrored& mirrored) const {
  const auto axis = [&](const osg::Vec3d& of) { return to_occlude(osg::Matrixd::transform3x3(of, mirrored.place)); };
  return {axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1}), to_occlude(mirrored.place.getTrans() + options_.misplaced)};
}

void NodeScene::follow() {
  for (const ObjectId object : followed_) {
    Mirrored& mirrored = mirrored_[object.slot()];
    const osg::Matrixd place = place_of(*mirrored.node);
    if (place == mirrored.place) continue;
    mirrored.place = place;
    scene_.move(object, box_of(mirrored));
    if (!mirrored.occluder.is_none()) scene_.move(mirrored.occluder, placement_of(mirrored));
  }
  scene_.update();
}

bool NodeScene::cull(osgUtil::CullVisitor& visitor) {
  if (visitor.getComputeNearFarMode() != osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR) return false;
  // OpenSceneGraph multiplies rows by matrices and stores rows one after another. That is the memory of columns.
  const osg::Matrixd to_clip = *visitor.getModelViewMatrix() * *visitor.getProjectionMatrix();
  const MatrixCamera camera = MatrixCamera::from_columns(to_clip.ptr(), culler::ClipDepth::minus_w_to_w);
  if (!culler::fault(camera).empty()) return false;
  const culler::SceneOptions options{.margin = culler::margin_for(visitor.getViewport()->height(), options_.margin)};
  Viewing& viewing = viewing_of(visitor);
  viewing.slots.clear();
  for (const culler::DrawnObject& drawn : scene_.cull(camera, options, viewing.view).drawn) {
    viewing.slots.push_back(drawn.id.slot());
  }
  std::ranges::sort(viewing.slots);
  for (const std::uint32_t slot : viewing.slots) mirrored_[slot].node->accept(visitor);
  return true;
}

NodeScene::Viewing& NodeScene::viewing_of(const osgUtil::CullVisitor& visitor) {
  const std::lock_guard lock(viewings_mutex_);
  return viewings_[&visitor];
}

}  // namespace occlude::example
