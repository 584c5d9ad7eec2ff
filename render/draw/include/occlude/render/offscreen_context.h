// SPDX-License-Identifier: MIT
// An OpenGL context without a window. Its implementation alone knows which library provides it.
#pragma once

#include <memory>
#include <string>

namespace occlude::render {

/// Keeps an OpenGL 4.5 core context current on the constructing thread during its lifetime.
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;
  /// The renderer's own name for itself, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
  [[nodiscard]] virtual std::string description() const = 0;
};

/// Throws std::runtime_error if the machine offers no such context.
[[nodiscard]] std::unique_ptr<OffscreenContext> make_offscreen_context();

}  // namespace occlude::render
