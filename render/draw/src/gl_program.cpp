// SPDX-License-Identifier: MIT
#include "gl_program.h"

#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>
#include <string>

namespace occlude::render {

GlProgram::GlProgram(const char* vertex_shader, const char* fragment_shader) : name_(gl.CreateProgram()) {
  attach(GL_VERTEX_SHADER, vertex_shader);
  attach(GL_FRAGMENT_SHADER, fragment_shader);
  gl.LinkProgram(name_);
  GLint linked = GL_FALSE, length = 0;
  gl.GetProgramiv(name_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  // A shader that did not compile does not link either; the log has the reason.
  gl.GetProgramiv(name_, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  gl.GetProgramInfoLog(name_, length, nullptr, log.data());
  gl.DeleteProgram(name_);
  throw std::runtime_error("OpenGL refuses the shaders: " + log);
}

void GlProgram::attach(GLenum stage, const char* text) const {
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  gl.AttachShader(name_, shader);
  gl.DeleteShader(shader);  // OpenGL keeps it until the program is deleted
}

void GlProgram::set(const char* uniform, float value) const { gl.Uniform1f(location(uniform), value); }

void GlProgram::set(const char* uniform, const glm::vec3& value) const {
  gl.Uniform3fv(location(uniform), 1, glm::value_ptr(value));
}

void GlProgram::set(const char* uniform, const glm::mat4& value) const {
  gl.UniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace occlude::render
