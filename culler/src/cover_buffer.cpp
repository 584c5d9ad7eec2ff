// SPDX-License-Identifier: MIT
#include "cover_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "rounded_float.h"
#include "single_precision.h"

namespace occlude::culler {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Pixels about the camera's picture: what reaches beyond it a little is hidden all the same. Twice as many hide no more in
/// the models tried, and leave the picture fewer.
constexpr double kBorder = 16;

constexpr float kOpen = -std::numeric_limits<float>::infinity();

}  // namespace

void CoverBuffer::begin(const Camera& camera, double depth, int width, int height, double margin) {
  picture_ = BeamPicture(camera, depth, {width, height, kBorder}, margin > 0 ? kSinglePrecision * depth : 0);
  tiles_across_ = width / kTile;
  wider_ = margin * (height - 2 * kBorder);
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  nearness_.assign(pixels, kOpen);
  farthest_.assign(pixels / kPixels, kOpen);
  owners_.clear();
}

void CoverBuffer::keep_owners() { owners_.assign(nearness_.size(), kNone); }

bool CoverBuffer::add(const CoverMesh& mesh, std::uint32_t id) {
  if (!piece_.draw(picture_, mesh)) return false;
  const PixelRectangle& r = piece_.rectangle();
  for (int y = r.y0 / kTile; y < r.y1 / kTile; ++y) {
    for (int x = r.x0 / kTile; x < r.x1 / kTile; ++x) {
      const float nearness = piece_.nearness(x, y);
      const auto tile = static_cast<std::size_t>(y * tiles_across_ + x);
      if (nearness > farthest_[tile] && nearness < kInfinity) add_to_tile(tile, x, y, nearness, id);
    }
  }
  return true;
}

void CoverBuffer::add_to_tile(std::size_t tile, int x, int y, float nearness, std::uint32_t id) {
  float* const pixels = &nearness_[tile * kPixels];
  float farthest = std::numeric_limits<float>::infinity();
  for (int row = 0; row < kTile; ++row) {
    const std::uint8_t* const closed = piece_.closed(y * kTile + row) + x * kTile;
    for (int i = 0; i < kTile; ++i) {
      float& pixel = pixels[row * kTile + i];
      const float now = closed[i] != 0 ? std::max(pixel, nearness) : pixel;
      if (!owners_.empty() && now > pixel) owners_[tile * kPixels + static_cast<std::size_t>(row * kTile + i)] = id;
      pixel = now;
      farthest = std::min(farthest, now);
    }
  }
  farthest_[tile] = farthest;
}

CoverBuffer::Outline CoverBuffer::outline(const kernel::Aabb& box) const {
  Place low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
  double nearest = kInfinity, error = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const Seen corner =
        picture_.see({(i & 1U ? box.max : box.min).x, (i & 2U ? box.max : box.min).y, (i & 4U ? box.max : box.min).z});
    nearest = std::min(nearest, corner.forward);
    if (!(nearest > picture_.near())) return {{}, 0};
    const Place p = picture_.place(corner);
    error = std::max(error, picture_.place_error(p, corner.forward));
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {{{low.x - error, low.y - error}, {high.x + error, high.y + error}}, nearest};
}

PixelRectangle CoverBuffer::pixels(const Outline& outline) const {
  return picture_.pixels(outline.places.low, outline.places.high, wider_);
}


bool CoverBuffer::hides(const kernel::Aabb& box) const {
  const Outline outline = this->outline(box);
  const double nearest = outline.nearest;
  if (nearest == 0) return false;
  const PixelRectangle r = pixels(outline);
  if (r.x0 < 0 || r.y0 < 0 || r.x1 > picture_.width() || r.y1 > picture_.height()) return false;
  const float most = rounded_up(picture_.nearness(nearest) + picture_.nearness_error(nearest));
  for (int y = r.y0 / kTile; y <= (r.y1 - 1) / kTile; ++y) {
    for (int x = r.x0 / kTile; x <= (r.x1 - 1) / kTile; ++x) {
      const auto tile = static_cast<std::size_t>(y * tiles_across_ + x);
      if (farthest_[tile] > most) continue;
      const PixelRectangle left{std::max(r.x0 - x * kTile, 0), std::max(r.y0 - y * kTile, 0),
                                std::min(r.x1 - x * kTile, kTile), std::min(r.y1 - y * kTile, kTile)};
      if (!hides_in_tile(tile, left, most)) return false;
    }
  }
  return true;
}

std::vector<CoverBuffer::Owner> CoverBuffer::owners(const kernel::Aabb& box) const {
  const Outline outline = this->outline(box);
  const auto& [low, high] = outline.places;
  const PixelRectangle r = pixels(outline);
  std::vector<Owner> runs;
  for (int y = r.y0; y < r.y1; ++y) {
    for (int x = r.x0; x < r.x1; ++x) {
      const auto tile = static_cast<std::size_t>(y / kTile * tiles_across_ + x / kTile);
      const std::uint32_t id = owners_[tile * kPixels + static_cast<std::size_t>(y % kTile * kTile + x % kTile)];
      const PlaceRectangle pixel{{std::max<double>(x, low.x), std::max<double>(y, low.y)},
                                 {std::min<double>(x + 1, high.x), std::min<double>(y + 1, high.y)}};
      if (pixel.low.x > pixel.high.x || pixel.low.y > pixel.high.y) continue;  // the margin alone reaches it
      runs.push_back({id, pixel});
    }
  }
  std::ranges::stable_sort(runs, {}, &Owner::id);
  std::vector<Owner> owners;
  for (const auto& [id, pixel] : runs) {
    if (owners.empty() || owners.back().id != id) owners.push_back({id, pixel});
    PlaceRectangle& all = owners.back().places;
    all = {{std::min(all.low.x, pixel.low.x), std::min(all.low.y, pixel.low.y)},
           {std::max(all.high.x, pixel.high.x), std::max(all.high.y, pixel.high.y)}};
  }
  return owners;
}

/// `r` within the tile.
bool CoverBuffer::hides_in_tile(std::size_t tile, const PixelRectangle& r, float most) const {
  if (r.x1 - r.x0 == kTile && r.y1 - r.y0 == kTile) return false;  // its farthest pixel is one of them
  const float* const pixels = &nearness_[tile * kPixels];
  for (int y = r.y0; y < r.y1; ++y) {
    for (int x = r.x0; x < r.x1; ++x) {
      if (!(pixels[y * kTile + x] > most)) return false;
    }
  }
  return true;
}

}  // namespace occlude::culler
