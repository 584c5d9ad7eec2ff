// SPDX-License-Identifier: MIT
// A search for a visible point of the box. Take any point. If no piece of the shadow contains it, it is visible. Otherwise
// every visible point lies outside the piece that contains it, beyond at least one of the bounds of that piece. So the
// search goes on beyond each of those bounds in turn.
#include "occlude/oracle/cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "box.h"
#include "cover_pieces.h"
#include "faults.h"
#include "feasibility.h"

namespace occlude::oracle {
namespace {

/// A unit of work is one piece that a point is compared with, or one condition on a point. It takes about a tenth of a
/// microsecond, so the limit is about half a minute.
constexpr std::size_t kMostWork = std::size_t{1} << 28U;

/// Half-spaces in the box's own coordinates.
template <class N>
struct System {
  std::vector<Inequality<N, 3>> closed, strict;
};

template <class N>
Inequality<N, 3> negated(const Inequality<N, 3>& row) {
  return {{-row.a[0], -row.a[1], -row.a[2]}, -row.b};
}

template <class N>
class Search {
 public:
  Search(const Box& box, const std::vector<ShadowPiece<N>>& pieces) : bounds_(own_bounds<N>(box)) {
    const auto own = [&](const std::vector<HalfSpace<N>>& half_spaces) {
      std::vector<Inequality<N, 3>> rows;
      for (const HalfSpace<N>& h : half_spaces) rows.push_back(in_own_coordinates(h, box));
      return rows;
    };
    for (const ShadowPiece<N>& piece : pieces) pieces_.push_back({own(piece.closed), own(piece.open)});
  }

  /// Whether some point of the box is in none of the pieces. Empty when finding out takes more than kMostWork.
  [[nodiscard]] std::optional<bool> outcome() {
    const bool found = has_point_outside();
    return found || work_ <= kMostWork ? std::optional(found) : std::nullopt;
  }

 private:
  [[nodiscard]] bool has_point_outside() {
    work_ += pieces_.size() + system_.closed.size() + system_.strict.size();
    if (work_ > kMostWork) return false;
    const auto point = feasible_point(bounds_, system_.closed, system_.strict);
    if (!point) return false;
    const System<N>* const piece = best_of_those_that_hold(*point);
    if (piece == nullptr) return true;
    const std::size_t closed = system_.closed.size(), strict = system_.strict.size();
    const bool found = has_point_beyond(*piece);
    system_.closed.resize(closed);
    system_.strict.resize(strict);
    return found;
  }

  static bool holds(const System<N>& piece, const Ratios<N, 3>& point) {
    const auto slack = [&](const Inequality<N, 3>& row) {
      const auto& [x, w] = point;
      return certain_sign(N(row.b * w - row.a[0] * x[0] - row.a[1] * x[1] - row.a[2] * x[2]));
    };
    return std::ranges::all_of(piece.closed, [&](const auto& row) { return slack(row) != CGAL::NEGATIVE; }) &&
           std::ranges::all_of(piece.strict, [&](const auto& row) { return slack(row) == CGAL::POSITIVE; });
  }

  /// Of the pieces that contain the point, the one in which it lies deepest, because that one is likely to contain much of
  /// its surroundings. Null when no piece contains the point.
  const System<N>* best_of_those_that_hold(const Ratios<N, 3>& point) const {
    const System<N>* best = nullptr;
    double deepest = 0;
    for (const System<N>& piece : pieces_) {
      if (!holds(piece, point)) continue;
      const double depth = depth_in(piece, point);
      if (best != nullptr && !(depth > deepest)) continue;
      best = &piece;
      deepest = depth;
    }
    return best;
  }

  /// An estimate of the distance to the nearest bound. It only decides which piece is tried first.
  static double depth_in(const System<N>& piece, const Ratios<N, 3>& point) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<Inequality<N, 3>>* rows : {&piece.closed, &piece.strict}) {
      for (const auto& [a, b] : *rows) {
        double slack = CGAL::to_double(b), length = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double coefficient = CGAL::to_double(a[k]);
          slack -= coefficient * (CGAL::to_double(point.x[k]) / CGAL::to_double(point.w));
          length += std::fabs(coefficient);
        }
        if (length > 0) least = std::min(least, slack / length);
      }
    }
    return least;
  }

  /// Each bound that has been tried becomes a condition, so a point beyond several bounds is searched for only beyond the
  /// first.
  bool has_point_beyond(const System<N>& piece) {
    for (const Inequality<N, 3>& row : piece.closed) {
      system_.strict.push_back(negated(row));
      if (has_point_outside()) return true;
      system_.strict.pop_back();
      system_.closed.push_back(row);
    }
    for (const Inequality<N, 3>& row : piece.strict) {
      system_.closed.push_back(negated(row));
      if (has_point_outside()) return true;
      system_.closed.pop_back();
      system_.strict.push_back(row);
    }
    return false;
  }

  Bounds<N, 3> bounds_;
  std::vector<System<N>> pieces_;
  System<N> system_;
  std::size_t work_ = 0;
};

std::string fault(const Viewpoint& view, const std::vector<Loop>& polygons, const Box& box,
                  const std::optional<HalfSpaceCoefficients>& drawn) {
  for (const Loop& polygon : polygons) {
    if (std::string reason = number_fault(view, polygon); !reason.empty()) return reason;
    if (polygon.size() < 3) return "a polygon has fewer than 3 vertices";
  }
  if (std::string reason = setting_fault(view, {}); !reason.empty()) return reason;
  if (drawn) {
    if (std::string reason = plane_fault(*drawn); !reason.empty()) return reason;
  }
  return strict_box_fault(box);
}

}  // namespace

Answer relation_to_cover(const Viewpoint& view, const std::vector<Loop>& polygons, const Box& box,
                         const std::optional<HalfSpaceCoefficients>& drawn) {
  const RoundUpward rounding;
  if (std::string reason = fault(view, polygons, box, drawn); !reason.empty()) return {std::move(reason), Relation::partial};
  const std::optional<bool> is_visible =
      decide([&]<class N>() { return Search<N>(box, pieces_of<N>(view, polygons, drawn)).outcome(); });
  if (!is_visible) return {"the cover takes too much work", Relation::partial};
  return {"", *is_visible ? Relation::partial : Relation::inside};
}

}  // namespace occlude::oracle
