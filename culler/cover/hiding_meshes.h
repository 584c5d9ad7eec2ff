// SPDX-License-Identifier: MIT
// Which of the meshes that were drawn into a picture hid something in it.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "base/each_bit.h"
#include "cover/conservative_viewport.h"
#include "cover/cover_buffer.h"

namespace occlude::culler {

/// A pixel is closed by the mesh that last brought it nearer. A mesh hid something if something is hidden in a pixel that it
/// closed. This estimates what a mesh is good for, and proves nothing.
class HidingMeshes {
 public:
  /// Forgets what was hidden, for a picture of this size.
  void begin(const CoverBuffer& buffer);
  /// Something is hidden that touches these pixels. May be called by several threads at once.
  void hide(const PixelRectangle& pixels);
  void hide(const BoxPixels& boxes, kernel::BoxBits hidden) {
    for_each_bit(hidden, [&](std::uint32_t i) { hide({boxes.x0[i], boxes.y0[i], boxes.x1[i], boxes.y1[i]}); });
  }
  /// Once all that is hidden was told: by these. They outlive this, and keep only pixels in which something is hidden.
  void find(std::span<CoverBuffer::Closing> closings);
  /// Whether the mesh hid something in one of these pixels. REQUIRES: find(); ids of meshes ascend in the order in which
  /// they were drawn.
  [[nodiscard]] bool has_hidden(std::uint32_t id, const PixelRectangle& pixels) const;
  [[nodiscard]] bool has_hidden(std::uint32_t id) const { return !of(id).empty(); }

 private:
  [[nodiscard]] std::span<const CoverBuffer::Closing> of(std::uint32_t id) const;

  int tiles_across_ = 0, tiles_up_ = 0;
  std::vector<std::atomic<std::uint64_t>> hidden_;  ///< of each tile, the pixels in which something is hidden
  std::span<const CoverBuffer::Closing> closings_;  ///< in which something is hidden, in order
};

}  // namespace occlude::culler
