// SPDX-License-Identifier: MIT
// The picture, item buffer and depth buffer that SceneRenderer draws into.
#pragma once

#include "gl_object.h"
#include "occlude/render/image.h"

namespace occlude::render {

class FrameBuffer {
 public:
  /// Throws std::runtime_error if OpenGL offers no buffers of this size.
  FrameBuffer(int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Draws into the picture from now on. Clears it to `sky` and depth 0, the farthest.
  void begin_picture(const Rgba& sky);
  /// Draws into the item buffer from now on. Clears it and sets depth 0. The picture is kept.
  void begin_items();
  /// Draws depth alone from now on. Nothing is cleared.
  void begin_nothing();
  /// Draws into the item buffer from now on. Clears it, but keeps the depths.
  void begin_items_before();

  [[nodiscard]] Image image() const;
  [[nodiscard]] Items items() const;

 private:
  void begin(GLenum attachment) const;
  void attach(const GlRenderbuffer& buffer, GLenum format, GLenum attachment);
  template <class Pixel>
  [[nodiscard]] Raster<Pixel> read(GLenum attachment, GLenum format, GLenum type) const;

  int width_, height_;
  GlFramebuffer frame_;
  GlRenderbuffer colour_, items_, depth_;
};

}  // namespace occlude::render
