// SPDX-License-Identifier: MIT
// One way of drawing a graph, step by step, so that each step can be measured.
#pragma once

#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/Matrixd>
#include <osg/Node>
#include <osg/ref_ptr>
#include <osgUtil/SceneView>
#include <unordered_set>

namespace occlude::example {

struct FrameTimes {
  double update = 0, cull = 0, frame = 0;  ///< milliseconds; `frame` is all of it with drawing, until the picture is there
};

class Renderer {
 public:
  /// Frames are drawn into `context`, which must be current. `culling` are OpenSceneGraph's own means. Small features are
  /// drawn, whatever it says.
  Renderer(osg::GraphicsContext& context, osg::Node& graph, osg::CullSettings::CullingMode culling);

  /// `time` in seconds places the traffic. Numbers of frames ascend.
  FrameTimes draw(unsigned int number, double time, const osg::Matrixd& view);

  /// What the last frame has drawn.
  [[nodiscard]] std::unordered_set<const osg::Drawable*> drawn() const;
  /// The picture in `context`.
  [[nodiscard]] osg::ref_ptr<osg::Image> picture() const;
  [[nodiscard]] osgUtil::SceneView& scene_view() { return *scene_view_; }

 private:
  int width_, height_;
  osg::ref_ptr<osgUtil::SceneView> scene_view_;
};

}  // namespace occlude::example
