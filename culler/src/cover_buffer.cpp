// SPDX-License-Identifier: MIT
#include "cover_buffer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rounded_float.h"

namespace occlude::culler {
namespace {

constexpr int kWord = 64;

}  // namespace

CoverBuffer::CoverBuffer(int width, int height)
    : width_(width), height_(height), nearness_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void CoverBuffer::begin(const Camera& camera, double depth) {
  picture_ = BeamPicture(camera, depth, width_, height_, CoverPiece::kTile / 2.0);
  std::ranges::fill(nearness_, -std::numeric_limits<float>::infinity());
}

void CoverBuffer::add(std::span<const glm::dvec3> vertices, std::span<const Triangle> piece) {
  if (!piece_.draw(picture_, vertices, piece)) return;
  const PixelRectangle& r = piece_.rectangle();
  for (int y = r.y0; y < r.y1; ++y) {
    for (int word = r.x0 / kWord; word <= (r.x1 - 1) / kWord; ++word) {
      for (std::uint64_t closed = piece_.closed(y, word); closed != 0; closed &= closed - 1) {
        const int x = word * kWord + std::countr_zero(closed);
        float& pixel = nearness_[static_cast<std::size_t>(y * width_ + x)];
        pixel = std::max(pixel, piece_.nearness(x / CoverPiece::kTile, y / CoverPiece::kTile));
      }
    }
  }
}

bool CoverBuffer::hides(const kernel::Aabb& box) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Place low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
  double nearest = kInfinity;
  for (unsigned i = 0; i < 8; ++i) {
    const Seen corner =
        picture_.see({(i & 1U ? box.max : box.min).x, (i & 2U ? box.max : box.min).y, (i & 4U ? box.max : box.min).z});
    nearest = std::min(nearest, corner.forward);
    if (!(nearest > picture_.near())) return false;
    const Place p = picture_.place(corner);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  if (low.x < 0 || low.y < 0 || high.x > width_ || high.y > height_) return false;
  const double wider = picture_.place_error(nearest, width_ + height_);
  const PixelRectangle r = picture_.pixels(low, high, wider);
  if (!(wider < 1) || r.x0 < 0 || r.y0 < 0 || r.x1 > width_ || r.y1 > height_) return false;
  const float most = rounded_up(picture_.nearness(nearest) + picture_.nearness_error(nearest));
  for (int y = r.y0; y < r.y1; ++y) {
    const auto row = nearness_.begin() + std::ptrdiff_t{y} * width_;
    if (!std::all_of(row + r.x0, row + r.x1, [&](float nearness) { return nearness > most; })) return false;
  }
  return true;
}

}  // namespace occlude::culler
