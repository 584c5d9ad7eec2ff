// SPDX-License-Identifier: MIT
// A pair of shaders, compiled and linked.
#pragma once

#include "gl.h"

namespace occlude::render {

/// Throws std::runtime_error with the compiler's words if OpenGL refuses the shaders.
class GlProgram {
 public:
  GlProgram(const char* vertex_shader, const char* fragment_shader);
  ~GlProgram() { glDeleteProgram(name_); }
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const { glUseProgram(name_); }
  [[nodiscard]] GLint uniform(const char* name) const { return glGetUniformLocation(name_, name); }

 private:
  void attach(GLenum stage, const char* text) const;

  GLuint name_;
};

}  // namespace occlude::render
