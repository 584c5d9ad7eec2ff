// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "camera/frame_view.h"
#include "cover/conservative_viewport.h"
#include "cover/cover_border.h"
#include "cover/projected_edge.h"
#include "exact.h"
#include "measure_culler.h"

namespace occlude::bound_check {
namespace {

using culler::BoundedPosition;
using culler::PixelPosition;
using Share = std::optional<double>;

Exact largest(const Exact& a, const Exact& b) { return a < b ? b : a; }
Exact least(const Exact& a, const Exact& b) { return a < b ? a : b; }

/// An edge with exact ends.
struct TrueEdge {
  Exact ax, ay, bx, by;

  [[nodiscard]] Exact at(const Exact& y) const { return ax + (y - ay) * (bx - ax) / (by - ay); }
  /// The least x of the edge between two heights; none if it does not come there.
  [[nodiscard]] std::optional<Exact> least_between(const Exact& from, const Exact& to) const {
    const Exact first = largest(from, least(ay, by)), last = least(to, largest(ay, by));
    if (first > last || ay == by) return std::nullopt;
    return least(at(first), at(last));
  }
};

PixelPosition any_place(Choices& choices) {
  const double size = choices.chance(0.3) ? choices.scale(0, 40) : 64;
  const double x = choices.real(-1, 2), y = choices.real(-1, 2);
  return {size * x, size * y};
}

/// The part of the error of an end that is left for the roundings where it is used (kPlaceError), in a picture of 64 by 64
/// pixels.
double left_for_roundings(const PixelPosition& p, const PixelPosition& q) {
  return culler::kPlaceError * (std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(q.x), std::fabs(q.y)}) + 64 + 64);
}

/// The columns of an edge between two heights. Its ends are anywhere within their errors.
Share positions_on_edges(Choices& choices, bool is_moved) {
  const PixelPosition p = any_place(choices), q = any_place(choices);
  const double move = is_moved ? choices.scale(-30, 3) : 0, error = move + left_for_roundings(p, q);
  const double low = choices.real(0, 64), high = low + choices.scale(-10, 3);
  const auto moved = [&](double x) { return Exact(Exact(x) + Exact(choices.sign() * move)); };
  const TrueEdge given{p.x, p.y, q.x, q.y}, truth{moved(p.x), moved(p.y), moved(q.x), moved(q.y)};
  const auto unmoved = given.least_between(low, high), least_x = truth.least_between(low, high);
  if (!unmoved || !least_x) return std::nullopt;
  const auto range = culler::ProjectedEdge({p, error}, {q, error}).between(low, high);
  const auto widened = given.least_between(Exact(low) - Exact(error), Exact(high) + Exact(error));
  const Exact wide = Exact(error) + Exact(0x1p-49) * (CGAL::abs(Exact(p.x)) + CGAL::abs(Exact(q.x)));
  return share_used(*unmoved - *widened + wide, *least_x - Exact(range.low));
}

/// A border of one edge in a picture of 64 by 64 pixels, and whether it touches a pixel.
class OneEdge {
 public:
  [[nodiscard]] bool touches(const BoundedPosition& p, const BoundedPosition& q, int x, int y) {
    border_.begin(picture_, {0, 0, kTiles, kTiles});
    // Everything is enclosed once. The edge is drawn back and forth, so that it encloses nothing.
    constexpr double kBeyond = 1000;
    const std::array<PixelPosition, 4> around{
        {{-kBeyond, -kBeyond}, {kBeyond, -kBeyond}, {kBeyond, kBeyond}, {-kBeyond, kBeyond}}};
    for (std::size_t i = 0; i < 4; ++i) border_.draw({around[i], 0}, {around[(i + 1) % 4], 0});
    border_.draw(p, q);
    border_.draw(q, p);
    border_.find_closed(closed_);
    const auto tile = static_cast<std::size_t>(y / culler::kTile * kTiles + x / culler::kTile);
    return (closed_[tile] >> (y % culler::kTile * culler::kTile + x % culler::kTile) & 1U) == 0;
  }

 private:
  static constexpr int kTiles = 8;

  culler::CoverBorder border_;
  culler::ConservativeViewport picture_{{}, {kTiles * culler::kTile, kTiles* culler::kTile, 16}, 0};
  std::vector<std::uint64_t> closed_ = std::vector<std::uint64_t>(kTiles * kTiles);
};

/// Moves an edge without errors of its ends away from a pixel that it touches, to the left, until the border no longer
/// touches the pixel. How far that is tells what the roundings leave of the bounds in CoverBorder::touch().
Share touched_pixels(Choices& choices) {
  const int x = static_cast<int>(choices.index(60)) + 2, y = static_cast<int>(choices.index(60)) + 2;
  const PixelPosition p = any_place(choices), q = any_place(choices);
  if (std::fabs(p.y - q.y) < 0x1p-10 || std::max(p.y, q.y) < y || std::min(p.y, q.y) > y + 1) return std::nullopt;
  // The largest x of the edge in the row of the pixel. It is mirrored because TrueEdge tells the least.
  const auto right_end = [&](double shift) {
    const TrueEdge mirrored{-Exact(p.x - shift), p.y, -Exact(q.x - shift), q.y};
    return Exact(-*mirrored.least_between(y, y + 1));
  };
  OneEdge edge;
  const auto touches = [&](double shift) {
    const PixelPosition a{p.x - shift, p.y}, b{q.x - shift, q.y};
    const double error = left_for_roundings(a, b);
    return edge.touches({a, error}, {b, error}, x, y);
  };
  const double start = CGAL::to_double(Exact(right_end(0) - x));
  const PixelPosition low{p.x - start, p.y}, high{q.x - start, q.y};
  const culler::ProjectedEdge seen({low, left_for_roundings(low, high)}, {high, left_for_roundings(low, high)});
  const auto part = seen.within({{0, 0}, {64, 64}});
  if (!part) return std::nullopt;
  // As CoverBorder::touch() has them. Where an end of the edge is in the row, the edge does not go on above or below it.
  const double rise = part->high.y - part->low.y, run = part->high.x - part->low.x;
  const double error = seen.error() + 0x1p-20 + 0x1p-21 * (rise + culler::kTile);
  const double wide = seen.wide() + 0x1p-20 * (std::fabs(part->low.x) + std::fabs(part->high.x));
  const TrueEdge mirrored{-Exact(low.x), low.y, -Exact(high.x), high.y};
  const Exact reached = *mirrored.least_between(y, y + 1),
              further = *mirrored.least_between(y - Exact(error), y + 1 + Exact(error));
  const Exact room = reached - further + Exact(wide);
  if (room > 1 || rise > 0x1p40 || std::fabs(run) > 0x1p40) return std::nullopt;
  double touched = start, free = start + 2 * CGAL::to_double(room) + 0x1p-10;
  if (!touches(touched)) {
    // It is as far to the left as doubles have it, or it does not touch a pixel that it reaches.
    return right_end(touched) >= x ? Share(std::numeric_limits<double>::infinity()) : std::nullopt;
  }
  if (touches(free)) return std::nullopt;  // the part ends in the row
  for (int step = 0; step < 50; ++step) {
    const double middle = (touched + free) / 2;
    (touches(middle) ? touched : free) = middle;
  }
  return share_used(room, x - right_end(free));
}

}  // namespace

std::vector<Measured> measure_edges(int cases, std::uint64_t seed) {
  const auto columns = [](bool is_moved) { return [=](Choices& choices) { return positions_on_edges(choices, is_moved); }; };
  return {
      search("columns of edges", "seen_edge", cases, seed, columns(false)),
      search("columns of edges whose ends are moved", "seen_edge", cases, seed, columns(true)),
      search("pixels that an edge touches, in floats", "cover_border", cases, seed, touched_pixels),
  };
}

}  // namespace occlude::bound_check
