// SPDX-License-Identifier: MIT
// Corners of triangles in OpenGL's memory.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "gl_object.h"
#include "triangle_list.h"

namespace occlude::render {

/// A vertex buffer of Corners and its layout.
class CornerBuffer {
 public:
  CornerBuffer() {
    bind();
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    gl.VertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), offset(offsetof(Corner, position)));
    gl.VertexAttribIPointer(kPolygon, 1, GL_UNSIGNED_INT, sizeof(Corner), offset(offsetof(Corner, polygon)));
    for (const GLuint attribute : {kPosition, kPolygon}) gl.EnableVertexAttribArray(attribute);
  }

  void bind() const {
    gl.BindVertexArray(layout_.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  }

  void upload(const std::vector<Corner>& corners) const {
    bind();
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)), corners.data(), GL_STATIC_DRAW);
    if (gl.GetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL has no memory for the model");
  }

 private:
  /// As the vertex shaders number them.
  enum Attribute : GLuint { kPosition, kPolygon };

  GlVertexArray layout_;
  GlBuffer buffer_;
};

}  // namespace occlude::render
