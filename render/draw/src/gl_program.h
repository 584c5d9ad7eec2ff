// SPDX-License-Identifier: MIT
// A pair of shaders, compiled and linked.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "gl.h"

namespace occlude::render {

/// Throws std::runtime_error with the compiler's message if OpenGL refuses the shaders.
class GlProgram {
 public:
  GlProgram(const char* vertex_shader, const char* fragment_shader);
  ~GlProgram() { gl.DeleteProgram(name_); }
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const { gl.UseProgram(name_); }
  /// Sets a uniform; ignores one that the shaders do not use. REQUIRES: the program is in use.
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::mat4& value) const;

 private:
  [[nodiscard]] GLint location(const char* uniform) const { return gl.GetUniformLocation(name_, uniform); }
  void attach(GLenum stage, const char* text) const;

  GLuint name_;
};

}  // namespace occlude::render
