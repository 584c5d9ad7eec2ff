// SPDX-License-Identifier: MIT
// The OpenGL functions we call. Those of version 4.3 and before are linked: every OpenGL library exports them.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

namespace occlude::render {

using GlFunction = void (*)();

/// A newer OpenGL function by name, from the library that provides the OffscreenContext; null if there is none.
[[nodiscard]] GlFunction gl_function(const char* name);

}  // namespace occlude::render
