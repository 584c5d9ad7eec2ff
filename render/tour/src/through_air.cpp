// SPDX-License-Identifier: MIT
#include "through_air.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "air.h"
#include "around.h"
#include "poses.h"
#include "rounds.h"

namespace occlude::render {
namespace {

using glm::dvec3;

// Tenths of a cell. From a cell that is two cells from the nearest full one, all of it is at least one cell away.
constexpr std::uint32_t kClear = 20;
constexpr double kFilmed = 0.5;  // cells: what is left of that where the eye goes from cell to cell, halved
// Hidden in 22 of 26 directions: in a cave or a room, rather than between things or in a nook.
constexpr double kInside = 0.84;
// Openings that are wider, a tenth of the model, are no better.
constexpr double kWideEnough = 60;
constexpr std::size_t kFlightStops = 6;
constexpr double kFlightLength = 5;    // of the flight, in diagonals of the model
constexpr double kFlightApart = 0.2;   // of the stops
constexpr double kFlightAhead = 0.08;  // the eye looks so far ahead
constexpr double kFlightFrames = 200;  // at the most, if it had not to turn

/// Where one can fly from outside. Ways are dear near triangles.
using Space = Weighted<Air>;

/// A clearance of `comfort` or more is cheap.
Space space_in(const Air& air, double comfort) {
  Space space(air);
  for (std::uint32_t cell = 0; cell < air.size(); ++cell) {
    if (air.clearance(cell) < kClear || air.width(cell) < kClear) continue;
    space.allow(cell, std::max(0.0, 1 - air.clearance(cell) / comfort));
  }
  return space;
}

/// How much a cell is worth to be seen from.
double worth(const Air& air, std::uint32_t cell) {
  return air.enclosure(cell) * air.enclosure(cell) * std::min<double>(air.width(cell), kWideEnough);
}

/// The cells inside of the model that can be reached; the one that is worth most comes first.
std::vector<std::uint32_t> inner_cells(const Air& air) {
  std::vector<std::uint32_t> cells;
  for (std::uint32_t cell = 0; cell < air.size(); ++cell) {
    if (air.width(cell) >= kClear && air.enclosure(cell) >= kInside) cells.push_back(cell);
  }
  const auto best = std::max_element(cells.begin(), cells.end(), [&](auto a, auto b) {
    return std::pair(worth(air, a), air.clearance(a)) < std::pair(worth(air, b), air.clearance(b));
  });
  if (best != cells.end()) std::iter_swap(cells.begin(), best);
  return cells;
}

/// The outermost cell from which `to` is reached at the least cost.
std::uint32_t gate(const Air& air, const Space& space, std::uint32_t to, const culler::Checkpoint& checkpoint) {
  const std::vector<std::uint32_t> cost = costs(space, std::array{to}, checkpoint);
  std::uint32_t best = to;
  std::uint32_t least = kUnreached;
  for (std::uint32_t cell = 0; cell < air.size(); ++cell) {
    if (!air.is_outermost(cell) || cost[cell] >= least) continue;
    best = cell;
    least = cost[cell];
  }
  return best;
}

/// The middles of the cells, as a smooth line.
std::vector<dvec3> smooth_line(const Air& air, const Space& space, const std::vector<std::uint32_t>& cells, double comfort) {
  std::vector<dvec3> points;
  for (const std::uint32_t cell : cells) points.push_back(air.middle(cell));
  constexpr int kRounds = 100;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const dvec3 to = 0.25 * points[i - 1] + 0.5 * points[i] + 0.25 * points[i + 1];
      const std::uint32_t from_cell = air.cell_at(points[i]), cell = air.cell_at(to);
      if (space.has(cell) && air.clearance(cell) >= std::min<double>(air.clearance(from_cell), comfort)) points[i] = to;
    }
  }
  return points;
}

/// The poses of the flight. Before it is in the model it looks at where it goes in, and after it has left it looks back.
/// None if it does not go in: smoothing may leave it outside of a nook.
std::optional<std::vector<Pose>> flight(const Air& air, const std::vector<dvec3>& points, double ahead, double stride) {
  const auto is_inside = [&](const dvec3& point) { return air.enclosure(air.cell_at(point)) >= kInside; };
  const auto first = std::find_if(points.begin(), points.end(), is_inside);
  if (first == points.end()) return std::nullopt;
  const auto last = std::find_if(points.rbegin(), points.rend(), is_inside);
  std::vector<Pose> poses = looking_ahead(points, ahead, stride);
  const auto look_at = [&](const dvec3& target) {
    return [&](const Pose& p) { return pose(p.eye, target, p.yaw, stride); };
  };
  const auto way_in = poses.begin() + (first - points.begin()), way_out = poses.end() - (last - points.rbegin());
  std::transform(poses.begin(), way_in, poses.begin(), look_at(*first));
  std::transform(way_out, poses.end(), way_out, look_at(*last));
  return poses;
}

}  // namespace

std::optional<CameraPath> through_air(const Place& place, const culler::Checkpoint& checkpoint) {
  const std::optional<Air> air = Air::find(place, checkpoint);
  if (!air) return std::nullopt;
  const std::vector<std::uint32_t> inner = inner_cells(*air);
  if (inner.empty()) return std::nullopt;
  const double comfort = air->width(inner.front());
  const Space space = space_in(*air, comfort);
  const std::uint32_t start = gate(*air, space, inner.front(), checkpoint);

  Rounds rounds(space, start, true, checkpoint);
  const double size = glm::length(place.size());
  const auto cost = [&](double sizes) { return Space::kCostOfWhole * (sizes * size) / air->cell(); };
  const auto unlimited = std::numeric_limits<std::uint64_t>::max();
  rounds.grow(
      std::span(inner).first(1), [](std::uint32_t) { return 1.0; }, 2, unlimited, 0);
  const auto interest = [&](std::uint32_t cell) { return worth(*air, cell) / kWideEnough; };
  rounds.grow(inner, interest, kFlightStops, static_cast<std::uint64_t>(cost(kFlightLength)),
              static_cast<std::uint32_t>(cost(kFlightApart)));
  const std::vector<dvec3> line = smooth_line(*air, space, rounds.places(), comfort);

  // From the end of the way round straight to the gate, and back there at last. Both lie beyond the same side of the model's
  // box, unless the gate is on top: then the eye first goes up.
  const dvec3 middle = 0.5 * (place.low + place.high), outside = line.front() - middle;
  std::vector<Pose> poses = round(place, std::atan2(outside.y, outside.x));
  const dvec3 end = poses.back().eye, above(end.x, end.y, std::max(end.z, line.front().z));
  std::vector<dvec3> points{end, above};
  points.insert(points.end(), line.begin(), line.end());
  points.insert(points.end(), {above, end});
  const auto through = flight(*air, points, kFlightAhead * size, length_of(points) / kFlightFrames);
  if (!through) return std::nullopt;
  poses.insert(poses.end(), through->begin(), through->end());
  return film(place, poses, kFilmed * air->cell());
}

}  // namespace occlude::render
