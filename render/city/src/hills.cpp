// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <vector>

#include "buildings.h"
#include "nature.h"
#include "parts.h"
#include "plan.h"
#include "random.h"

namespace occlude::render::city {
namespace {

// Kinds of random generator, see Random.
constexpr std::uint64_t kFieldKind = 30;
constexpr std::uint64_t kHedgeKind = 31;
constexpr std::uint64_t kWoodKind = 32;

constexpr Length kField = m(57);  // pitch of the fields; a whole number of them fits the hills
constexpr Length kLaneHalfWidth = m(2.6);
constexpr Length kFineGround = m(11);  // within this distance of the camera's route, the ground is cut finely

Point on_ground(const Terrain& t, Length x, Length y) { return {x, y, t.height(x, y)}; }

void build_ground(Builder& b, const Terrain& t, const Route& route, Length fine_parts) {
  for (Length j = 0; j < t.rows(); ++j) {
    for (Length i = 0; i < t.columns(); ++i) {
      const Rect cell{t.x(i), t.y(j), t.x(i + 1), t.y(j + 1)};
      const Length parts = route.crosses(cell, kFineGround) ? fine_parts : 1;
      for (Length v = 0; v < parts; ++v) {
        for (Length u = 0; u < parts; ++u) {
          const Length x0 = cell.x0 + t.cell() * u / parts;
          const Length x1 = cell.x0 + t.cell() * (u + 1) / parts;
          const Length y0 = cell.y0 + t.cell() * v / parts;
          const Length y1 = cell.y0 + t.cell() * (v + 1) / parts;
          const Point sw = on_ground(t, x0, y0);
          const Point ne = on_ground(t, x1, y1);
          b.triangle(sw, on_ground(t, x1, y0), ne);
          b.triangle(sw, ne, on_ground(t, x0, y1));
        }
      }
    }
  }
}

/// The lane's hedges, in straight pieces of about 19 m that share their ends; some pieces give way to a gate.
struct LaneSides {
  std::vector<Boundary> hedges;
  std::vector<std::array<Point, 2>> gates;
};

LaneSides lane_sides(const Terrain& t) {
  constexpr Length kHedgeHeight = m(2.9);
  constexpr Length kHedgeThickness = m(1.3);
  constexpr Length kGate = m(3.4);
  constexpr Length kPieces = 2;
  std::vector<Point> middle;
  const std::vector<Point>& bends = lane();
  for (std::size_t i = 0; i + 1 < bends.size(); ++i) {
    for (Length s = 0; s < kPieces; ++s) {
      middle.push_back({bends[i].x + (bends[i + 1].x - bends[i].x) * s / kPieces,
                        bends[i].y + (bends[i + 1].y - bends[i].y) * s / kPieces, 0});
    }
  }
  middle.push_back(bends.back());
  LaneSides sides;
  for (const Length side : {Length{1}, Length{-1}}) {
    std::vector<Point> edge;
    for (std::size_t i = 0; i < middle.size(); ++i) {
      const Point& before = middle[i == 0 ? 0 : i - 1];
      const Point& after = middle[std::min(i + 1, middle.size() - 1)];
      const Length dx = after.x - before.x;
      const Length dy = after.y - before.y;
      const Length reach = integer_sqrt(dx * dx + dy * dy);
      edge.push_back(
          on_ground(t, middle[i].x - side * dy * kLaneHalfWidth / reach, middle[i].y + side * dx * kLaneHalfWidth / reach));
    }
    for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
      Point a = edge[i];
      Point b = edge[i + 1];
      if (i % 6 == (side > 0 ? 3U : 5U)) {
        const Length reach = integer_sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
        const Point gate = on_ground(t, a.x + (b.x - a.x) * kGate / reach, a.y + (b.y - a.y) * kGate / reach);
        sides.gates.push_back({a, gate});
        a = gate;
      }
      // The thickness lies to the left of the piece, so the right-hand hedge runs backwards.
      if (side > 0) {
        sides.hedges.push_back({a, b, kHedgeThickness, kHedgeHeight, false});
      } else {
        sides.hedges.push_back({b, a, kHedgeThickness, kHedgeHeight, false});
      }
    }
  }
  return sides;
}

enum class FieldUse { pasture, cottage, unfinished, copse, orchard };

struct Field {
  Rect land;
  FieldUse use = FieldUse::pasture;
  bool stone = false;
  std::uint64_t seed = 0;
};

std::vector<Field> divide_fields(const Terrain& t, std::uint64_t seed) {
  std::vector<Field> fields;
  const Rect& all = t.extent();
  for (Length x = all.x0; x + kField <= all.x1; x += kField) {
    for (Length y = all.y0; y + kField <= all.y1; y += kField) {
      Random random(seed, kFieldKind, fields.size());
      Field field;
      field.land = {x, y, x + kField, y + kField};
      field.use = static_cast<FieldUse>(random.below(5));
      field.stone = random.chance(45);
      field.seed = random.next();
      fields.push_back(field);
    }
  }
  return fields;
}

/// The southern and western boundary of a field, in pieces short enough to follow the ground, clear of the lane.
std::vector<Boundary> boundaries(const Field& field, const Terrain& t, const Route& route) {
  constexpr Length kPieces = 5;
  std::vector<Boundary> pieces;
  for (const bool west : {false, true}) {
    for (Length i = 0; i < kPieces; ++i) {
      const Length from = kField * i / kPieces;
      const Length to = kField * (i + 1) / kPieces;
      const Rect& l = field.land;
      const Rect line = west ? Rect{l.x0, l.y0 + from, l.x0, l.y0 + to} : Rect{l.x0 + from, l.y0, l.x0 + to, l.y0};
      if (route.crosses(line, m(5.5))) continue;
      const Length thickness = field.stone ? m(0.6) : m(1);
      const Length height = field.stone ? m(1.3) : m(2.1);
      pieces.push_back({on_ground(t, line.x0, line.y0), on_ground(t, line.x1, line.y1), thickness, height, field.stone});
    }
  }
  return pieces;
}

/// Where the house of a field stands, turned by a quarter or not.
Frame house_site(const Field& field, const Terrain& t, Random& random) {
  const Length x = field.land.x0 + random.between(m(16), kField - m(16));
  const Length y = field.land.y0 + random.between(m(16), kField - m(16));
  return Frame{{x, y, t.height(x, y) + m(0.3)}, 1, 0}.moved(0, 0, 0, static_cast<int>(random.below(4)));
}

bool near_lane(const Point& p, const Route& route, Length margin) { return route.crosses({p.x, p.y, p.x, p.y}, margin); }

void build_house(Builder& b, const Field& field, const Terrain& t, const Route& route, bool details) {
  if (field.use != FieldUse::cottage && field.use != FieldUse::unfinished) return;
  Random random(field.seed);
  const Frame site = house_site(field, t, random);
  if (near_lane(site.origin, route, m(13))) return;
  if (field.use == FieldUse::unfinished) {
    if (!details) build_unfinished_cottage(b, site, random);
  } else if (details) {
    build_cottage_details(b, site, random);
  } else {
    build_cottage_shell(b, site);
  }
}

void build_trees(Builder& b, const Field& field, const Terrain& t, const Route& route, Length leaves) {
  Random random(field.seed + 1);
  const Length inner = kField - m(8);
  const auto plant = [&](Length x, Length y, Random tree) {
    const Point foot = on_ground(t, field.land.x0 + m(4) + x, field.land.y0 + m(4) + y);
    if (!near_lane(foot, route, m(7))) add_tree(b, foot, leaves, tree);
  };
  if (field.use == FieldUse::orchard) {
    for (Length y = 0; y < inner; y += m(8)) {
      for (Length x = 0; x < inner; x += m(8)) plant(x, y, Random(random.next()));
    }
    return;
  }
  const Length count = field.use == FieldUse::copse ? 45 : 7;
  for (Length i = 0; i < count; ++i) {
    const Length x = random.below(inner);
    const Length y = random.below(inner);
    plant(x, y, Random(random.next()));
  }
}

}  // namespace

Terrain make_terrain(std::uint64_t seed, std::size_t polygons) {
  const Length cell = polygons >= 300'000 ? m(8) : polygons >= 80'000 ? m(12) : m(24);
  Rect extent = kHills;
  // In models larger than the paper's the hills grow to the north, east and south. Their number of polygons is proportional
  // to their area.
  constexpr std::size_t kPaper = 500'000;
  if (polygons > kPaper) {
    const Length scale = integer_sqrt(static_cast<Length>(polygons / 100) * 1024 * 1024 / static_cast<Length>(kPaper / 100));
    extent.x1 = extent.x0 + kHills.width() * scale / 1024;
    extent.y1 = kHills.y1 * scale / 1024 / cell * cell;
    extent.y0 = -extent.y1;
  }
  return Terrain(seed, extent, cell);
}

void build_hills(Builder& b, std::uint64_t seed, const Route& route, const Terrain& terrain, std::size_t target) {
  const std::size_t budget = target > b.size() ? target - b.size() : 0;
  const Length fine_parts = budget >= 45'000 ? 6 : budget >= 12'000 ? 4 : 3;
  build_ground(b, terrain, route, fine_parts);
  const LaneSides sides = lane_sides(terrain);
  for (const Boundary& hedge : sides.hedges) build_boundary_core(b, hedge);
  for (const auto& gate : sides.gates) build_gate(b, gate[0], gate[1]);

  const std::vector<Field> fields = divide_fields(terrain, seed);
  const std::vector<std::size_t> order = shuffled(fields.size(), Random(seed, kFieldKind, fields.size()));
  const auto full = [&] { return b.size() >= target; };
  for (const std::size_t i : order) {
    if (full()) return;
    build_house(b, fields[i], terrain, route, false);
    for (const Boundary& piece : boundaries(fields[i], terrain, route)) build_boundary_core(b, piece);
  }
  const Length leaves = budget >= 45'000 ? 16 : 4;
  for (const std::size_t i : order) {
    if (full()) return;
    build_trees(b, fields[i], terrain, route, leaves);
  }
  for (std::size_t i = 0; i < sides.hedges.size() && !full(); ++i) {
    build_boundary_details(b, sides.hedges[i], Random(seed, kHedgeKind, i));
  }
  for (const std::size_t i : order) {
    if (full()) return;
    build_house(b, fields[i], terrain, route, true);
    std::uint64_t index = 0;
    for (const Boundary& piece : boundaries(fields[i], terrain, route)) {
      build_boundary_details(b, piece, Random(fields[i].seed, kHedgeKind, index++));
    }
  }
  // The remaining polygons become woodland.
  const Rect& all = terrain.extent();
  for (std::uint64_t i = 0; !full(); ++i) {
    Random random(seed, kWoodKind, i);
    const Length x = all.x0 + random.below(all.width());
    const Length y = all.y0 + random.below(all.depth());
    const Point foot = on_ground(terrain, x, y);
    if (!near_lane(foot, route, m(7))) add_tree(b, foot, leaves, random);
  }
}

}  // namespace occlude::render::city
