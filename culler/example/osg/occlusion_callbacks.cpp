// SPDX-License-Identifier: MIT
#include "occlusion_callbacks.h"

#include <osgUtil/CullVisitor>

namespace occlude::example {

void FollowCallback::operator()(osg::Node* node, osg::NodeVisitor* visitor) {
  traverse(node, visitor);
  scene_->follow();
}

void CullCallback::operator()(osg::Node* node, osg::NodeVisitor* visitor) {
  osgUtil::CullVisitor* const cull_visitor = visitor->asCullVisitor();
  if (cull_visitor == nullptr || !scene_->cull(*cull_visitor)) traverse(node, visitor);
}

osg::ref_ptr<NodeScene> cull_occluded(osg::Group& group, const NodeSceneOptions& options) {
  osg::ref_ptr<NodeScene> scene = new NodeScene(group, options);
  group.addUpdateCallback(new FollowCallback(*scene));
  group.addCullCallback(new CullCallback(*scene));
  return scene;
}

}  // namespace occlude::example
