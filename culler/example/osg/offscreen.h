// SPDX-License-Identifier: MIT
// A graphics context without a display: EGL's surfaceless platform.
#pragma once

#include <osg/GraphicsContext>
#include <osg/ref_ptr>

namespace occlude::example {

/// Null, after a message on standard error, where there is none. It is current on the calling thread.
[[nodiscard]] osg::ref_ptr<osg::GraphicsContext> make_offscreen(int width, int height);

}  // namespace occlude::example
