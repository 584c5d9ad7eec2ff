// SPDX-License-Identifier: MIT
// Ownership of OpenGL objects.
#pragma once

#include "gl.h"

namespace occlude::render {

/// Owns one object made by `Create` and destroyed by `Delete`. REQUIRES: its context outlives it.
template <auto Create, auto Delete>
class GlObject {
 public:
  GlObject() { Create(1, &name_); }
  ~GlObject() { Delete(1, &name_); }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;

  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

using GlBuffer = GlObject<glGenBuffers, glDeleteBuffers>;
using GlVertexArray = GlObject<glGenVertexArrays, glDeleteVertexArrays>;
using GlRenderbuffer = GlObject<glGenRenderbuffers, glDeleteRenderbuffers>;
using GlFramebuffer = GlObject<glGenFramebuffers, glDeleteFramebuffers>;

}  // namespace occlude::render
