// SPDX-License-Identifier: MIT
// Counts the pixels of polygons while OpenGL draws them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "gl_object.h"

namespace occlude::render {

/// A number for each polygon, which a fragment shader counts up. The shader has it as the array of a block of binding 0.
class PixelCounter {
 public:
  explicit PixelCounter(std::size_t polygons) : counts_(polygons) {}

  /// Sets all numbers to 0 and lets shaders count from now on.
  void begin() const {
    const std::vector<std::uint32_t> zeros(counts_);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kBinding, buffer_.name());
    gl.BufferData(GL_SHADER_STORAGE_BUFFER, size(), zeros.data(), GL_DYNAMIC_READ);
    if (gl.GetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL has no memory to count pixels");
  }
  [[nodiscard]] std::vector<std::uint32_t> counts() const {
    std::vector<std::uint32_t> result(counts_);
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer_.name());
    gl.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, size(), result.data());
    return result;
  }

 private:
  static constexpr GLuint kBinding = 0;

  [[nodiscard]] GLsizeiptr size() const { return static_cast<GLsizeiptr>(counts_ * sizeof(std::uint32_t)); }

  std::size_t counts_;
  GlBuffer buffer_;
};

}  // namespace occlude::render
