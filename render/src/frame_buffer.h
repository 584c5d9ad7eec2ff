// SPDX-License-Identifier: MIT
// The picture, item buffer and depth buffer that SceneRenderer draws into.
#pragma once

#include <cstdint>

#include "gl_object.h"
#include "occlude/render/image.h"

namespace occlude::render {

class FrameBuffer {
 public:
  /// Throws std::runtime_error if OpenGL offers no buffers of this size.
  FrameBuffer(int width, int height);

  /// Makes it the target of drawing and reading, with `sky` everywhere, nothing in the item buffer and depth 0, the
  /// farthest.
  void begin(const Rgba& sky);
  /// Whether drawing from here on writes the item buffer besides the picture.
  void write_items(bool on);

  [[nodiscard]] Image image() const;
  [[nodiscard]] ItemBuffer item_buffer() const;

 private:
  void attach(const GlRenderbuffer& buffer, GLenum format, GLenum attachment);
  template <class Pixel>
  [[nodiscard]] Raster<Pixel> read(GLenum attachment, GLenum format, GLenum type) const;

  int width_, height_;
  GlFramebuffer frame_;
  GlRenderbuffer colour_, items_, depth_;
};

}  // namespace occlude::render
