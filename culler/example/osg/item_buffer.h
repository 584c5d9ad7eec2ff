// SPDX-License-Identifier: MIT
// What shows: each thing is drawn in a colour of its own, without culling, light or antialiasing.
#pragma once

#include <cstddef>
#include <memory>
#include <osg/GraphicsContext>
#include <osg/Matrixd>
#include <span>
#include <vector>

#include "renderer.h"
#include "town.h"

namespace occlude::example {

class ItemBuffer {
 public:
  ItemBuffer(osg::GraphicsContext& context, std::span<const Thing> things);

  /// Whether each thing has a pixel. What is opaque is seen through glass; glass behind glass may be missed.
  std::vector<bool> visible(double time, const osg::Matrixd& view);

 private:
  void draw(Renderer& renderer, double time, const osg::Matrixd& view, std::vector<bool>& visible);

  std::size_t things_;
  std::unique_ptr<Renderer> opaque_, with_glass_;
  unsigned int frame_ = 0;
};

}  // namespace occlude::example
