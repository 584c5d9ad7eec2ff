// SPDX-License-Identifier: MIT
// One camera as it moves: its last frame, and what is kept of it for the next. Reading order: 11.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "occlude/culler/box.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/visibility.h"

namespace occlude::culler {

/// Tells the cullers of a program apart, so that a view notices which of them it is used with. A copy has the
/// same identity, as it holds the same. Any thread may make one.
class Identity {
 public:
  Identity();
  friend bool operator==(const Identity&, const Identity&) = default;

 private:
  friend class View;
  Identity(std::nullptr_t) {}  ///< of no culler

  std::uint64_t number_ = 0;
};

/// 1. A view belongs to one camera, and one thread at a time may cull with it. Different views may be culled at once.
/// 2. If it is used with another culler than in the frame before, it starts anew, as if it had just been made.
/// 3. After its first frame nothing more is allocated. Exceptions: culler/README.md, Budgets.
/// 4. A view that was moved from may only be destroyed or assigned to.
class View {
 public:
  View();
  ~View();
  View(View&&) noexcept;
  View& operator=(View&&) noexcept;

  /// The last frame; empty before the first. Valid until the next frame of this view.
  [[nodiscard]] const CullResult& result() const;

  /// Whether any box, such as that of an object about to be created, would be visible in the last frame.
  /// 1. It is tested against the frame's half-spaces, and its occluders or cover, with the frame's margin. The tests are
  ///    certified, whatever the frame's arithmetic. Shadows begin strictly beyond their near planes.
  /// 2. Before the first frame everything is visible.
  /// 3. The box may reach farther from the eye than everything that the culler holds. Then the half-spaces are
  ///    moved outwards by another margin, that of its L1 distance (append_view_frustum()), and no cover hides it.
  /// 4. Allocates nothing. Many threads may ask the same view at once, while no frame of it is being culled.
  /// Throws std::invalid_argument for a box that is not legal, and std::runtime_error while the processor does not round to
  /// nearest (occlude/kernel/validity.h).
  [[nodiscard]] Visibility visibility(const Box& box) const;

  /// For the cullers only: frame/view_memory.h. Not protected by `const`.
  struct Memory;
  [[nodiscard]] Memory& memory() const { return *memory_; }
  /// The same for the next frame with this culler; emptied unless the frame before was with the same one.
  [[nodiscard]] Memory& memory_for(const Identity& owner);

 private:
  std::unique_ptr<Memory> memory_;
  Identity owner_{nullptr};
};

}  // namespace occlude::culler
