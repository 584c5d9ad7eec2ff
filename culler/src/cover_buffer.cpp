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
  piece_.begin(picture_);
  tiles_across_ = width / kTile;
  wider_ = margin >= 0 ? margin * (height - 2 * kBorder) : kInfinity;  // of what is no margin nothing is hidden
  work_ = 0;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  nearness_.assign(pixels, kOpen);
  farthest_.assign(pixels / kPixels, kOpen);
  owners_.clear();
}

void CoverBuffer::keep_owners() { owners_.assign(nearness_.size(), kNone); }

bool CoverBuffer::add(const CoverMesh& mesh, std::uint32_t id) {
  if (!piece_.find(mesh)) return false;
  const auto tiles = tiles_to_draw();
  if (!tiles || !piece_.draw(*tiles)) return false;
  work_ += piece_.work();
  for (int y = tiles->y0; y < tiles->y1; ++y) {
    for (int x = tiles->x0; x < tiles->x1; ++x) {
      const float nearness = piece_.nearness(x, y);
      const auto tile = static_cast<std::size_t>(y * tiles_across_ + x);
      if (nearness > farthest_[tile] && nearness < kInfinity) add_to_tile(tile, x, y, nearness, id);
    }
  }
  return true;
}

std::optional<PixelRectangle> CoverBuffer::tiles_to_draw() const {
  const PixelRectangle& r = piece_.tiles();
  PixelRectangle left{r.x1, r.y1, r.x0, r.y0};
  for (int y = r.y0; y < r.y1; ++y) {
    for (int x = r.x0; x < r.x1; ++x) {
      if (farthest_[static_cast<std::size_t>(y * tiles_across_ + x)] >= piece_.nearest()) continue;
      left = {std::min(left.x0, x), std::min(left.y0, y), std::max(left.x1, x + 1), std::max(left.y1, y + 1)};
    }
  }
  if (left.x0 >= left.x1) return std::nullopt;
  return left;
}

void CoverBuffer::add_to_tile(std::size_t tile, int x, int y, float nearness, std::uint32_t id) {
  std::array<std::uint8_t, kPixels> closed;
  std::uint64_t any = 0;
  for (std::size_t row = 0; row < kTile; ++row) {
    std::uint64_t eight = 0;
    static_assert(sizeof eight == kTile);
    std::memcpy(&eight, piece_.closed(y * kTile + static_cast<int>(row)) + x * kTile, sizeof eight);
    std::memcpy(&closed[row * kTile], &eight, sizeof eight);
    any |= eight;
  }
  if (any == 0) return;
  float* const pixels = &nearness_[tile * kPixels];
  if (!owners_.empty()) {
    for (std::size_t i = 0; i < kPixels; ++i) {
      if (closed[i] != 0 && nearness > pixels[i]) owners_[tile * kPixels + i] = id;
    }
  }
  float farthest = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < kPixels; ++i) {
    const float now = closed[i] != 0 && nearness > pixels[i] ? nearness : pixels[i];
    pixels[i] = now;
    farthest = now < farthest ? now : farthest;
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

float CoverBuffer::most_nearness(const Outline& outline) const {
  return rounded_up(picture_.nearness(outline.nearest) + picture_.nearness_error(outline.nearest));
}

bool CoverBuffer::is_in_picture(const Outline& outline) const {
  if (outline.nearest == 0) return false;
  const PixelRectangle r = pixels(outline);
  return r.x0 >= 0 && r.y0 >= 0 && r.x1 <= picture_.width() && r.y1 <= picture_.height();
}

bool CoverBuffer::hides(const kernel::Aabb& box) const {
  const Outline outline = this->outline(box);
  return is_in_picture(outline) && count_open(pixels(outline), most_nearness(outline), 1) == 0;
}

CoverBuffer::Gap CoverBuffer::gap(const kernel::Aabb& box) const {
  const Outline outline = this->outline(box);
  if (!is_in_picture(outline)) return Gap::beyond_picture;
  if (count_open(pixels(outline), most_nearness(outline), 1) == 0) return Gap::none;
  return count_open(pixels(outline), std::numeric_limits<float>::lowest(), 1) == 0 ? Gap::not_behind : Gap::open;
}

bool CoverBuffer::has_open(const kernel::Aabb& box, int count) const {
  const Outline outline = this->outline(box);
  if (outline.nearest == 0) return true;
  return count_open(picture_.clipped(pixels(outline)), most_nearness(outline), count) >= count;
}

int CoverBuffer::count_open(const PixelRectangle& r, float most, int enough) const {
  int open = 0;
  for (int y = r.y0 / kTile; y * kTile < r.y1; ++y) {
    for (int x = r.x0 / kTile; x * kTile < r.x1; ++x) {
      const auto tile = static_cast<std::size_t>(y * tiles_across_ + x);
      if (farthest_[tile] > most) continue;
      const float* const pixels = &nearness_[tile * kPixels];
      const int x0 = std::max(r.x0 - x * kTile, 0), x1 = std::min(r.x1 - x * kTile, kTile);
      const int y1 = std::min(r.y1 - y * kTile, kTile);
      for (int row = std::max(r.y0 - y * kTile, 0); row < y1; ++row) {
        for (int i = x0; i < x1; ++i) open += pixels[row * kTile + i] > most ? 0 : 1;
      }
      if (open >= enough) return enough;
    }
  }
  return open;
}

std::vector<CoverBuffer::Owner> CoverBuffer::owners(const kernel::Aabb& box) const {
  const Outline outline = this->outline(box);
  const auto& [low, high] = outline.places;
  const PixelRectangle r = picture_.clipped(pixels(outline));
  std::vector<Owner> runs;
  for (int y = r.y0; y < r.y1; ++y) {
    std::uint32_t last = kNone;
    for (int x = r.x0; x < r.x1; ++x) {
      const auto tile = static_cast<std::size_t>(y / kTile * tiles_across_ + x / kTile);
      const std::uint32_t id = owners_[tile * kPixels + static_cast<std::size_t>(y % kTile * kTile + x % kTile)];
      const PlaceRectangle pixel{{std::max<double>(x, low.x), std::max<double>(y, low.y)},
                                 {std::min<double>(x + 1, high.x), std::min<double>(y + 1, high.y)}};
      const bool is_of_box = pixel.low.x <= pixel.high.x && pixel.low.y <= pixel.high.y;  // else the margin alone reaches it
      if (!is_of_box || id == kNone) {
        last = kNone;
      } else if (id == last) {
        runs.back().places.high.x = pixel.high.x;
      } else {
        runs.push_back({id, pixel});
        last = id;
      }
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

}  // namespace occlude::culler
