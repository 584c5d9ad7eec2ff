// SPDX-License-Identifier: MIT
// One camera as it moves: its last frame, and what is kept of it for the next. Reading order: 11.
#pragma once

#include <memory>

#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// A view belongs to one camera and one culler, and to one thread at a time; different views may be culled at once. After
/// some frames along a path nothing is allocated any more.
class View {
 public:
  View();
  ~View();
  View(View&&) noexcept;
  View& operator=(View&&) noexcept;

  /// The last frame.
  [[nodiscard]] const CullResult& result() const;

  /// For the cullers alone: src/view_memory.h.
  struct Memory;
  [[nodiscard]] Memory& memory() const { return *memory_; }

 private:
  std::unique_ptr<Memory> memory_;
};

}  // namespace occlude::culler
