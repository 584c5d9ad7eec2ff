// SPDX-License-Identifier: MIT
// Where the culler takes part in OpenSceneGraph's traversals. Reading order: 3.
#pragma once

#include <osg/Callback>
#include <osg/Group>
#include <osg/ref_ptr>

#include "node_scene.h"

namespace occlude::example {

/// For a group, as update callback: first everything below is updated, then the scene follows what moved.
class FollowCallback : public osg::NodeCallback {
 public:
  explicit FollowCallback(NodeScene& scene) : scene_(&scene) {}
  void operator()(osg::Node* node, osg::NodeVisitor* visitor) override;

 private:
  osg::ref_ptr<NodeScene> scene_;
};

/// For the same group, as cull callback: only what is to be drawn is traversed. Other visitors, and cameras that cannot be
/// used, traverse everything.
class CullCallback : public osg::NodeCallback {
 public:
  explicit CullCallback(NodeScene& scene) : scene_(&scene) {}
  void operator()(osg::Node* node, osg::NodeVisitor* visitor) override;

 private:
  osg::ref_ptr<NodeScene> scene_;
};

/// Everything below the group is culled from now on. This is all that a program needs to call.
osg::ref_ptr<NodeScene> cull_occluded(osg::Group& group, const NodeSceneOptions& options = {});

}  // namespace occlude::example
