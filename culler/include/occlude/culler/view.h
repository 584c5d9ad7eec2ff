// SPDX-License-Identifier: MIT
// One camera as it moves: its last frame, and what is kept of it for the next. Reading order: 11.
#pragma once

#include <memory>

#include "occlude/culler/box.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {

enum class Visibility {
  visible,      ///< for all that the frame knows
  occluded,     ///< all of it is in the shadow of one occluder, or of a pair that is asked together, or behind a cover
  out_of_view,  ///< all of it is beyond a half-space of the view
};

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

  /// What the last frame makes of any box, say of something about to be created: by the same half-spaces and occluders, or
  /// cover, with its margin, and certified whatever the frame was. Shadows are strictly beyond their near planes. Everything
  /// is visible before the first frame. A box that reaches farther than all that the culler knows may be out of view by a
  /// plane that rounding, in its last digits, has tilted before it. Many threads may ask one view at a time, between its
  /// frames. Throws std::invalid_argument for a box that the kernel refuses.
  [[nodiscard]] Visibility visibility(const Box& box) const;

  /// For the cullers alone: src/view_memory.h.
  struct Memory;
  [[nodiscard]] Memory& memory() const { return *memory_; }

 private:
  std::unique_ptr<Memory> memory_;
};

}  // namespace occlude::culler
