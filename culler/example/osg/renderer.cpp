// SPDX-License-Identifier: MIT
#include "renderer.h"

#include <chrono>
#include <osg/FrameStamp>
#include <osg/GL>
#include <osgUtil/RenderBin>
#include <osgUtil/RenderLeaf>
#include <osgUtil/RenderStage>
#include <osgUtil/StateGraph>

namespace occlude::example {
namespace {

void collect(const osgUtil::RenderBin& bin, std::unordered_set<const osg::Drawable*>& drawn) {
  // Leaves are here where the bin is sorted by depth, …
  for (const osgUtil::RenderLeaf* const leaf : bin.getRenderLeafList()) drawn.insert(leaf->getDrawable());
  // … and here where it is sorted by state.
  for (const osgUtil::StateGraph* const graph : bin.getStateGraphList()) {
    for (const auto& leaf : graph->_leaves) drawn.insert(leaf->getDrawable());
  }
  for (const auto& [number, inner] : bin.getRenderBinList()) collect(*inner, drawn);
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Renderer::Renderer(osg::GraphicsContext& context, osg::Node& graph, osg::CullSettings::CullingMode culling)
    : width_(context.getTraits()->width), height_(context.getTraits()->height), scene_view_(new osgUtil::SceneView) {
  scene_view_->setDefaults(osgUtil::SceneView::COMPILE_GLOBJECTS_AT_INIT | osgUtil::SceneView::APPLY_GLOBAL_DEFAULTS);
  scene_view_->setState(context.getState());
  scene_view_->setSceneData(&graph);
  scene_view_->setViewport(0, 0, width_, height_);
  scene_view_->getCamera()->setGraphicsContext(&context);
  scene_view_->setClearColor({0.62F, 0.74F, 0.88F, 1});
  scene_view_->setProjectionMatrixAsPerspective(60, static_cast<double>(width_) / height_, 0.2, 3000);
  // What hides must be beyond the near plane, so it must be known before the cull.
  scene_view_->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
  scene_view_->setCullingMode(culling & ~osg::CullSettings::SMALL_FEATURE_CULLING);
  scene_view_->setFrameStamp(new osg::FrameStamp);
  scene_view_->init();
}

FrameTimes Renderer::draw(unsigned int number, double time, const osg::Matrixd& view) {
  osg::FrameStamp& stamp = *scene_view_->getFrameStamp();
  stamp.setFrameNumber(number);
  stamp.setReferenceTime(time);
  stamp.setSimulationTime(time);
  scene_view_->setViewMatrix(view);
  FrameTimes times;
  const auto start = std::chrono::steady_clock::now();
  scene_view_->update();
  times.update = milliseconds_since(start);
  scene_view_->cull();
  times.cull = milliseconds_since(start) - times.update;
  scene_view_->draw();
  glFinish();
  times.frame = milliseconds_since(start);
  return times;
}

std::unordered_set<const osg::Drawable*> Renderer::drawn() const {
  std::unordered_set<const osg::Drawable*> drawn;
  collect(*scene_view_->getRenderStage(), drawn);
  return drawn;
}

osg::ref_ptr<osg::Image> Renderer::picture() const {
  osg::ref_ptr<osg::Image> image = new osg::Image;
  image->readPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, 1);
  return image;
}

}  // namespace occlude::example
