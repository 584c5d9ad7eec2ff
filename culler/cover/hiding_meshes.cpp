// SPDX-License-Identifier: MIT
#include "cover/hiding_meshes.h"

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "cover/cover_tile.h"

namespace occlude::culler {
namespace {

/// The pixels of the tile at (x, y), in tiles, that are in a rectangle.
std::uint64_t pixels_of_tile(const PixelRectangle& r, int x, int y) {
  const int row0 = std::max(r.y0 - kTile * y, 0), row1 = std::min(r.y1 - kTile * y, kTile);
  return row0 < row1 ? pixels_of(from_to(r.x0 - kTile * x, r.x1 - kTile * x), row0, row1) : 0;
}

}  // namespace

void HidingMeshes::begin(const CoverBuffer& buffer) {
  tiles_across_ = buffer.picture().width() / kTile;
  tiles_up_ = buffer.picture().height() / kTile;
  const auto tiles = static_cast<std::size_t>(tiles_across_ * tiles_up_);
  if (hidden_.size() < tiles) hidden_ = std::vector<std::atomic<std::uint64_t>>(tiles);
  for (auto& hidden : std::span(hidden_).first(tiles)) hidden.store(0, std::memory_order_relaxed);
}

void HidingMeshes::hide(const PixelRectangle& pixels) {
  const int x1 = std::min((pixels.x1 + kTile - 1) / kTile, tiles_across_),
            y1 = std::min((pixels.y1 + kTile - 1) / kTile, tiles_up_);
  for (int y = std::max(pixels.y0 / kTile, 0); y < y1; ++y) {
    for (int x = std::max(pixels.x0 / kTile, 0); x < x1; ++x) {
      auto& hidden = hidden_[static_cast<std::size_t>(y * tiles_across_ + x)];
      hidden.fetch_or(pixels_of_tile(pixels, x, y), std::memory_order_relaxed);
    }
  }
}

/// From the last to the first, so that each pixel goes to the mesh that brought it nearer last.
void HidingMeshes::find(std::span<CoverBuffer::Closing> closings) {
  auto first = closings.end();
  for (auto closing = closings.end(); closing != closings.begin();) {
    --closing;
    auto& hidden = hidden_[closing->tile];
    const std::uint64_t pixels = hidden.load(std::memory_order_relaxed);
    closing->pixels &= pixels;
    hidden.store(pixels & ~closing->pixels, std::memory_order_relaxed);
    if (closing->pixels != 0) *--first = *closing;
  }
  closings_ = {first, closings.end()};
}

std::span<const CoverBuffer::Closing> HidingMeshes::of(std::uint32_t id) const {
  const auto first = std::ranges::lower_bound(closings_, id, {}, &CoverBuffer::Closing::id);
  return {first, std::ranges::upper_bound(first, closings_.end(), id, {}, &CoverBuffer::Closing::id)};
}

bool HidingMeshes::has_hidden(std::uint32_t id, const PixelRectangle& pixels) const {
  return std::ranges::any_of(of(id), [&](const CoverBuffer::Closing& closing) {
    const int tile = static_cast<int>(closing.tile);
    return (closing.pixels & pixels_of_tile(pixels, tile % tiles_across_, tile / tiles_across_)) != 0;
  });
}

}  // namespace occlude::culler
