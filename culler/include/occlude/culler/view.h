// SPDX-License-Identifier: MIT
// One camera as it moves: its last frame, and what is kept of it for the next. Reading order: 11.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "occlude/culler/box.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {

enum class Visibility {
  visible,      ///< for all that the frame knows
  occluded,     ///< all of it is in the shadow of one occluder, or of a pair that is asked together, or behind a cover
  out_of_view,  ///< all of it is beyond a half-space of the view
};

/// Tells the cullers and scenes of a program from each other, so that a view notices which of them it is used with. A copy
/// holds the same and is the same.
class Identity {
 public:
  Identity();
  friend bool operator==(const Identity&, const Identity&) = default;

 private:
  friend class View;
  Identity(std::nullptr_t) {}  ///< of no culler

  std::uint64_t number_ = 0;
};

/// A view belongs to one camera, and to one thread at a time; different views may be culled at once. Used with another
/// culler or scene than in the frame before it starts anew, as if it had just been made. After its first frame
/// nothing is allocated any more (README.md, Contracts).
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
  /// is visible before the first frame. For a box that reaches farther than all that the culler knows the half-spaces are
  /// taken as much larger as they would be, had the culler known of it. Many threads may ask one view at a time, between its
  /// frames. Throws std::invalid_argument for a box that the kernel refuses, std::runtime_error while the processor does not
  /// round to nearest (occlude/kernel/validity.h).
  [[nodiscard]] Visibility visibility(const Box& box) const;

  /// For the cullers alone: src/view_memory.h.
  struct Memory;
  [[nodiscard]] Memory& memory() const { return *memory_; }
  /// The same for a frame of this culler or scene: empty unless the frame before was one of it.
  [[nodiscard]] Memory& memory_for(const Identity& owner);

 private:
  std::unique_ptr<Memory> memory_;
  Identity owner_{nullptr};
};

}  // namespace occlude::culler
