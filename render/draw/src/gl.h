// SPDX-License-Identifier: MIT
// The OpenGL functions that we call. They are called as gl.BindBuffer(…).
//
// They are loaded with the first OffscreenContext and not with the program: their library takes longer to load than most
// commands take that draw nothing.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

// clang-format off
#define OCCLUDE_GL_FUNCTIONS(DO) \
  DO(AttachShader) DO(BindBuffer) DO(BindBufferBase) DO(BindFramebuffer) DO(BindRenderbuffer) DO(BindVertexArray) \
  DO(BlendColor) DO(BlendFunc) DO(BufferData) DO(CheckFramebufferStatus) DO(ClearBufferfv) DO(ClearBufferuiv) \
  DO(ClipControl) DO(CompileShader) DO(CreateProgram) DO(CreateShader) DO(DeleteBuffers) DO(DeleteFramebuffers) \
  DO(DeleteProgram) DO(DeleteRenderbuffers) DO(DeleteShader) DO(DeleteVertexArrays) DO(DepthFunc) DO(DepthMask) \
  DO(Disable) DO(DrawBuffers) DO(Enable) DO(EnableVertexAttribArray) DO(Finish) DO(FramebufferRenderbuffer) \
  DO(GenBuffers) DO(GenFramebuffers) DO(GenRenderbuffers) DO(GenVertexArrays) DO(GetBufferSubData) DO(GetError) \
  DO(GetIntegerv) DO(GetProgramInfoLog) DO(GetProgramiv) DO(GetString) DO(GetUniformLocation) DO(LinkProgram) \
  DO(MemoryBarrier) DO(MultiDrawArrays) DO(PolygonOffset) DO(ReadBuffer) DO(ReadPixels) DO(RenderbufferStorage) DO(ShaderSource) \
  DO(Uniform1f) DO(Uniform3fv) DO(UniformMatrix4fv) DO(UseProgram) DO(VertexAttribIPointer) DO(VertexAttribPointer) \
  DO(Viewport)
// clang-format on

namespace occlude::render {

struct Gl {
#define OCCLUDE_GL_POINTER(name) decltype(&::gl##name) name = nullptr;
  OCCLUDE_GL_FUNCTIONS(OCCLUDE_GL_POINTER)
#undef OCCLUDE_GL_POINTER
};

/// Null before the first context.
inline Gl gl;

}  // namespace occlude::render
