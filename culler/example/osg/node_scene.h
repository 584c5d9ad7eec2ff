// SPDX-License-Identifier: MIT
// The nodes of a scene graph as objects and occluders of a culler's scene. Reading order: 2.
#pragma once

#include <occlude/culler/scene.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <osg/Group>
#include <osg/Matrixd>
#include <osg/Referenced>
#include <osg/ref_ptr>
#include <osgUtil/CullVisitor>
#include <vector>

namespace occlude::example {

struct NodeSceneOptions {
  /// As SceneOptions::margin, in pixels.
  double margin = culler::kPixelMargin;
  /// What is smaller does not hide: the least length of the second longest side of what a node fills. Small things hide
  /// little and cost time, most of all if they move.
  double least_occluder = 0;
  /// Moves each occluder away from what draws it, and so makes culls wrong: to see that a check of them finds it.
  osg::Vec3d misplaced = {0, 0, 0};
};

/// Mirrors what is below a group. Groups that do nothing but hold others (no state, callback or mask) are looked into, down
/// to what draws or transforms. Each such node is an object, and what is opaque of it an occluder.
///
/// Nodes that may_change() are followed: as many as do move should be, and no more. The others must stay where they are.
/// What a node draws must not change in its own coordinates while it is in the scene, unless the parts that do may_change()
/// too: such a node is drawn in each frame.
///
/// Threads, as OpenSceneGraph has its traversals: follow(), add() and remove() run while nothing is culled. cull() may run
/// on several threads at once, each with its own cull visitor.
class NodeScene : public osg::Referenced {
 public:
  explicit NodeScene(osg::Group& group, const NodeSceneOptions& options = {});

  /// For what comes and goes below the group later. Both show at the next follow(). `node` is in the coordinates of the
  /// group.
  culler::ObjectId add(osg::Node& node);
  void remove(culler::ObjectId object);

  /// Takes over where dynamic nodes are now, and updates the scene.
  void follow();

  /// Culls the scene as the visitor sees it, and lets the visitor traverse what is to be drawn, in the order in which it was
  /// added: where surfaces coincide, that which is drawn first shows, with and without culling. The visitor is at the group.
  /// Returns false, and does nothing, if its camera cannot be used: while OpenSceneGraph computes the near plane from what
  /// is drawn (CullSettings::setComputeNearFarMode()), nobody knows yet what that plane will clip, and so what can hide.
  /// What OpenSceneGraph leaves out of itself although it shows, by SMALL_FEATURE_CULLING, hides nevertheless.
  bool cull(osgUtil::CullVisitor& visitor);

  [[nodiscard]] const culler::Scene& scene() const { return scene_; }

 private:
  struct Mirrored {
    osg::ref_ptr<osg::Node> node;
    osg::BoundingBoxd bounds;
    osg::Matrixd place;  ///< when last followed
    culler::OccluderId occluder;
  };
  struct Viewing {
    culler::SceneView view;
    std::vector<std::uint32_t> slots;  ///< of what is to be drawn
  };

  void add_below(osg::Group& group);
  [[nodiscard]] culler::Box box_of(const Mirrored& mirrored) const;
  [[nodiscard]] culler::Placement placement_of(const Mirrored& mirrored) const;
  Viewing& viewing_of(const osgUtil::CullVisitor& visitor);

  NodeSceneOptions options_;
  culler::Scene scene_;
  std::vector<Mirrored> mirrored_;          ///< by slots of objects
  std::vector<culler::ObjectId> followed_;  ///< those that may move
  std::mutex viewings_mutex_;
  std::map<const osgUtil::CullVisitor*, Viewing> viewings_;  ///< a visitor is used by one thread at a time
};

}  // namespace occlude::example
