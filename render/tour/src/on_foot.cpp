// SPDX-License-Identifier: MIT
#include "on_foot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <limits>
#include <vector>

#include "floors.h"
#include "poses.h"
#include "rounds.h"

namespace occlude::render {
namespace {

using glm::dvec2, glm::dvec3;

// In eye heights.
constexpr double kWalkStride = 0.6;                // 1 m a frame: 30 times as fast as a person, through 300 m in ten seconds
constexpr double kWalkLength = 600 * kWalkStride;  // of the whole walk at the cheapest; most ways cost twice as much
constexpr double kLeastWalk = 3;                   // 5 m
constexpr double kWalkApart = 2;                   // stops are no nearer to each other
constexpr double kWalkAhead = 3;                   // the walker looks 5 m ahead
constexpr double kLevelling = 0.5;        // the eye goes up a stair as if it were a ramp: steps within 0.85 m are levelled
constexpr double kLeastArea = 4;          // squared eye heights, weighted by how enclosed they are: 12 square metres
constexpr double kLeastEnclosure = 0.45;  // on average, of a walk that is worth it
constexpr std::size_t kWalkStops = 12;

double square(double x) { return x * x; }

/// How much a stand is worth. In the open it is as good as nothing, but not nothing: there may be no other.
double worth(const Floors& floors, std::uint32_t stand) { return 0.001 + square(floors.enclosure(stand)); }

/// The stands of one region that are far enough from walls. Ways are dear near walls and in the open.
using Region = Weighted<Floors>;

Region region_of(const Floors& floors, double comfort, const std::vector<std::uint32_t>& stands) {
  Region region(floors);
  for (const std::uint32_t s : stands) {
    const double crowded = std::max(0.0, 1 - floors.clearance(s) / comfort), open = 1 - floors.enclosure(s);
    region.allow(s, 0.5 * (crowded + open));
  }
  return region;
}

/// A length in tenths of a column, as clearances are.
double tenths(double eye_heights, const Place& place, const Floors& floors) {
  return 10 * eye_heights * place.eye_height / floors.columns().cell;
}

/// The clearance of stands at the walker's radius from walls: the wall is half a column from a stand with clearance 0.
double least_clearance(const Place& place, const Floors& floors) { return tenths(walker::kRadius, place, floors) - 5; }

/// Whether most polygons of the model lie in the box of the region.
bool holds_most(const Place& place, const Floors& floors, const std::vector<std::uint32_t>& region) {
  dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const std::uint32_t s : region) {
    const auto& [floor, ceiling, column, span, next] = floors.stands()[s];
    const dvec2 middle = floors.columns().middle(column);
    low = glm::min(low, dvec3(middle, floor));
    high = glm::max(high, dvec3(middle, ceiling));
  }
  const double margin = place.eye_height;
  std::size_t count = 0;
  for (std::size_t p = 0; p < place.soup.size(); ++p) {
    const dvec3& corner = place.points[place.soup.loop(p)[0]];
    if (glm::all(glm::greaterThanEqual(corner, low - margin)) && glm::all(glm::lessThanEqual(corner, high + margin)))
      ++count;
  }
  return 2 * count >= place.soup.size();
}

/// Whether a person would find himself in a hollow of something that is meant to be seen from outside: no air comes in, and
/// most of what he sees turns its back on him, or most of the model is elsewhere.
bool is_hollow(const Place& place, const Floors& floors, const std::vector<std::uint32_t>& region) {
  std::size_t fronts = 0;
  for (const std::uint32_t s : region) {
    if (!floors.is_sealed(s)) return false;
    fronts += static_cast<std::size_t>(floors.fronts(s));
  }
  return fronts <= region.size() || !holds_most(place, floors, region);
}

/// The connected stands with the largest area, weighted by how enclosed they are. Empty if there is none.
std::vector<std::uint32_t> best_region(const Place& place, const Floors& floors, bool is_choosy) {
  const double clearance = least_clearance(place, floors);
  const double area = square(floors.columns().cell / place.eye_height);
  std::vector<bool> is_met(floors.stands().size());
  std::vector<std::uint32_t> best;
  double best_score = is_choosy ? kLeastArea : 0;
  for (std::uint32_t start = 0; start < is_met.size(); ++start) {
    const auto is_free = [&](std::uint32_t s) { return !is_met[s] && floors.clearance(s) >= clearance; };
    if (!is_free(start)) continue;
    std::vector<std::uint32_t> region{start};
    is_met[start] = true;
    double score = 0;
    for (std::size_t i = 0; i < region.size(); ++i) {
      score += area * worth(floors, region[i]);
      floors.for_each_next(region[i], [&](std::uint32_t next, std::uint32_t) {
        if (!is_free(next)) return;
        is_met[next] = true;
        region.push_back(next);
      });
    }
    if (score <= best_score || (is_choosy && is_hollow(place, floors, region))) continue;
    best_score = score;
    best = std::move(region);
  }
  return best;
}

/// The most enclosed of the stands; of several, the one with the most room; of several, the first.
std::uint32_t heart(const Floors& floors, const std::vector<std::uint32_t>& stands) {
  const auto rank = [&](std::uint32_t s) { return std::pair(floors.enclosure(s), floors.clearance(s)); };
  return *std::max_element(stands.begin(), stands.end(), [&](auto a, auto b) { return rank(a) < rank(b); });
}

/// The walk as a line of points on the floor, which becomes smooth and stays as far from walls as it was, or comfortably
/// far.
class Line {
 public:
  Line(const Place& place, const Floors& floors, const Region& region, std::vector<std::uint32_t> stands)
      : place_(place),
        floors_(floors),
        region_(region),
        stands_(std::move(stands)),
        comfort_(tenths(walker::kComfort, place, floors)) {
    for (const std::uint32_t s : stands_) points_.push_back(middle(s));
  }

  void smooth(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 1; i + 1 < points_.size(); ++i)
        move(i, 0.25 * points_[i - 1] + 0.5 * points_[i] + 0.25 * points_[i + 1]);
    }
  }

  /// The eyes above the line.
  [[nodiscard]] std::vector<dvec3> eyes() const {
    std::vector<dvec3> result;
    for (std::size_t i = 0; i < points_.size(); ++i) result.emplace_back(points_[i], levelled(i) + place_.eye_height);
    return result;
  }

  [[nodiscard]] double enclosure() const {
    double sum = 0;
    for (const std::uint32_t s : stands_) sum += floors_.enclosure(s);
    return sum / static_cast<double>(stands_.size());
  }
  [[nodiscard]] double length() const { return length_of(points_); }

 private:
  [[nodiscard]] dvec2 middle(std::uint32_t stand) const { return floors_.columns().middle(floors_.stands()[stand].column); }

  /// Steps from column to column to the one with the point, first in x, then in y; kNone where the floor ends.
  [[nodiscard]] std::uint32_t stand_at(std::uint32_t stand, const dvec2& to) const {
    const Columns& columns = floors_.columns();
    const dvec2 steps = glm::floor((to - middle(stand)) / columns.cell + 0.5);
    for (const unsigned axis : {0U, 1U}) {
      const double count = steps[static_cast<int>(axis)];
      for (double k = 0; k < std::fabs(count) && stand != Floors::kNone; ++k) {
        stand = floors_.stands()[stand].next[axis + (count > 0 ? 0 : 2)];
      }
    }
    return stand;
  }

  void move(std::size_t i, const dvec2& to) {
    const std::uint32_t stand = stand_at(stands_[i], to);
    if (stand == Floors::kNone || !region_.has(stand)) return;
    if (floors_.clearance(stand) < std::min<double>(floors_.clearance(stands_[i]), comfort_)) return;
    stands_[i] = stand;
    points_[i] = to;
  }

  /// The mean height of the floor around a point of the line.
  [[nodiscard]] double levelled(std::size_t i) const {
    const double reach = kLevelling * place_.eye_height;
    double sum = 0;
    std::size_t count = 0;
    const auto take = [&](std::size_t k) {
      if (glm::distance(points_[k], points_[i]) > reach) return false;
      sum += floors_.stands()[stands_[k]].floor;
      ++count;
      return true;
    };
    // As many to either side, so that a ramp stays one.
    for (std::size_t k = 0; k <= std::min(i, points_.size() - 1 - i) && take(i - k) && take(i + k); ++k) {
    }
    return count > 0 ? sum / static_cast<double>(count) : floors_.stands()[stands_[i]].floor;
  }

  const Place& place_;
  const Floors& floors_;
  const Region& region_;
  std::vector<std::uint32_t> stands_;
  std::vector<dvec2> points_;
  double comfort_;
};

}  // namespace

std::optional<CameraPath> on_foot(const Place& place, bool is_choosy, const culler::Checkpoint& checkpoint) {
  const std::optional<Floors> floors = Floors::find(place, checkpoint);
  if (!floors) return std::nullopt;
  const double comfort = tenths(walker::kComfort, place, *floors);
  const std::vector<std::uint32_t> stands = best_region(place, *floors, is_choosy);
  if (stands.empty()) return std::nullopt;

  const Region region = region_of(*floors, comfort, stands);
  const auto cost = [&](double eye_heights) { return Region::kCostOfWhole * (tenths(eye_heights, place, *floors) / 10); };
  const std::uint32_t start = heart(*floors, stands);
  // Nothing much duller than the start is worth a detour.
  constexpr double kDull = 0.6;
  std::vector<std::uint32_t> sights;
  std::ranges::copy_if(stands, std::back_inserter(sights),
                       [&](std::uint32_t s) { return floors->enclosure(s) >= kDull * floors->enclosure(start); });
  Rounds rounds(region, start, false, checkpoint);
  const auto interest = [&](std::uint32_t s) { return worth(*floors, s) * std::min(1.0, floors->clearance(s) / comfort); };
  rounds.grow(sights, interest, kWalkStops, static_cast<std::uint64_t>(cost(kWalkLength)),
              static_cast<std::uint32_t>(cost(kWalkApart)));

  Line line(place, *floors, region, rounds.places());
  if (line.length() < kLeastWalk * place.eye_height) return std::nullopt;
  if (is_choosy && line.enclosure() < kLeastEnclosure) return std::nullopt;
  // A corner becomes as round as a step of the smoothing, half a column, spreads in so many rounds.
  constexpr int kRounds = 200;
  line.smooth(kRounds);
  // The radius of the walker leaves an eighth of the eye height free except where he ducks; then half of it must do.
  const std::vector<Pose> poses = looking_ahead(line.eyes(), kWalkAhead * place.eye_height, kWalkStride * place.eye_height);
  for (const double clearance : {1.0 / 8, 1.0 / 16}) {
    checkpoint();
    if (auto path = film(place, poses, clearance * place.eye_height)) return path;
  }
  return std::nullopt;
}

}  // namespace occlude::render
