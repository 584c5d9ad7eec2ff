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
    glVertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), offset(offsetof(Corner, position)));
    glVertexAttribIPointer(kPolygon, 1, GL_UNSIGNED_INT, sizeof(Corner), offset(offsetof(Corner, polygon)));
    for (const GLuint attribute : {kPosition, kPolygon}) glEnableVertexAttribArray(attribute);
  }

  void bind() const {
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  }

  void upload(const std::vector<Corner>& corners) const {
    bind();
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)), corners.data(), GL_STATIC_DRAW);
    if (glGetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL has no memory for the model");
  }

 private:
  /// As the vertex shaders number them.
  enum Attribute : GLuint { kPosition, kPolygon };

  GlVertexArray layout_;
  GlBuffer buffer_;
};

}  // namespace occlude::render
