// SPDX-License-Identifier: MIT
// Ownership of OpenGL objects.
#pragma once

#include "gl.h"

namespace occlude::render {

/// Owns one object made by `Create` and destroyed by `Delete`. REQUIRES: its context outlives it.
template <auto Gl::*Create, auto Gl::*Delete>
class GlObject {
 public:
  GlObject() { (gl.*Create)(1, &name_); }
  ~GlObject() { (gl.*Delete)(1, &name_); }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;

  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

using GlBuffer = GlObject<&Gl::GenBuffers, &Gl::DeleteBuffers>;
using GlVertexArray = GlObject<&Gl::GenVertexArrays, &Gl::DeleteVertexArrays>;
using GlRenderbuffer = GlObject<&Gl::GenRenderbuffers, &Gl::DeleteRenderbuffers>;
using GlFramebuffer = GlObject<&Gl::GenFramebuffers, &Gl::DeleteFramebuffers>;

}  // namespace occlude::render
