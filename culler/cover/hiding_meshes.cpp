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
  constexpr std::uint64_t kEachRow = 0x0101'0101'0101'0101;
  const auto below = [](int n) { return n >= kTile ? 0xFFU : (1U << std::max(n, 0)) - 1U; };
  const std::uint64_t columns = below(r.x1 - kTile * x) & ~below(r.x0 - kTile * x);
  std::uint64_t rows = ~std::uint64_t{0};
  const int first = std::max(r.y0 - kTile * y, 0), end = std::min(r.y1 - kTile * y, kTile);
  if (first >= end) return 0;
  rows = rows << (kTile * first) & rows >> (kTile * (kTile - end));
  return columns * kEachRow & rows;
}

}  // namespace

void HidingMeshes::begin(const CoverBuffer& buffer) {
  tiles_across_ = buffer.tiles_across();
  tiles_up_ = buffer.picture().height() / kTile;
  hidden_.assign(static_cast<std::size_t>(tiles_across_ * tiles_up_), 0);
}

void HidingMeshes::hide(const PixelRectangle& pixels) {
  const int x1 = std::min((pixels.x1 + kTile - 1) / kTile, tiles_across_),
            y1 = std::min((pixels.y1 + kTile - 1) / kTile, tiles_up_);
  for (int y = std::max(pixels.y0 / kTile, 0); y < y1; ++y) {
    for (int x = std::max(pixels.x0 / kTile, 0); x < x1; ++x) {
      std::atomic_ref hidden(hidden_[static_cast<std::size_t>(y * tiles_across_ + x)]);
      hidden.fetch_or(pixels_of_tile(pixels, x, y), std::memory_order_relaxed);
    }
  }
}

/// From the last to the first, so that each pixel goes to the mesh that brought it nearer last.
void HidingMeshes::find(std::span<CoverBuffer::Closing> closings) {
  auto first = closings.end();
  for (auto closing = closings.end(); closing != closings.begin();) {
    --closing;
    std::uint64_t& hidden = hidden_[closing->tile];
    closing->pixels &= hidden;
    hidden &= ~closing->pixels;
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
