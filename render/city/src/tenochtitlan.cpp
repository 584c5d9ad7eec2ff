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
constexpr std::uint64_t kAdobeKind = 20;
constexpr std::uint64_t kSkullKind = 21;
constexpr std::uint64_t kOrderKind = 22;
constexpr std::uint64_t kMaizeKind = 23;

constexpr Length kLakeHalfDepth = m(200);  // of the part of the lake round the main island
constexpr Length kWallThickness = m(2);
constexpr Length kWallHeight = m(6);

/// Sizes of pieces of water far from the causeways and near them, of the plaza's floor and of the ground under the houses.
struct Cells {
  Length far_water, near_water, plaza, town;
  Length parts;  ///< cuts of a piece of floor near the camera
};

Cells cells_for(std::size_t budget) {
  if (budget >= 45'000) return {m(8), m(1.4), m(4), m(5), 5};
  if (budget >= 12'000) return {m(12), m(3), m(6), m(8), 4};
  return {m(30), m(10), m(13), m(20), 3};
}

void build_water(Builder& b, const Route& route, const Cells& cells) {
  const Length near = kCausewayHalfWidth + m(12);
  for (const Rect& strait : {Rect{kQuayEast, 0, kIsland.x0, 0}, Rect{kIsland.x1, 0, kHills.x0, 0}}) {
    for (const Length side : {Length{1}, Length{-1}}) {
      const auto strip = [&](Length from, Length to) {
        return Rect{strait.x0, std::min(side * from, side * to), strait.x1, std::max(side * from, side * to)};
      };
      b.ground(strip(kCausewayHalfWidth, near), kLakeLevel, cells.near_water);
      b.ground(strip(near, kLakeHalfDepth), kLakeLevel, cells.far_water);
    }
    build_pavement(b, route, {strait.x0, -kCausewayHalfWidth, strait.x1, kCausewayHalfWidth}, 0, cells.plaza, cells.parts);
    for (const Length y : {-kCausewayHalfWidth, kCausewayHalfWidth}) {
      b.band({strait.x0, y, kLakeLevel - m(0.3)}, {strait.x1, y, kLakeLevel - m(0.3)}, m(0.3) - kLakeLevel,
             cells.near_water);
    }
  }
  b.ground({kIsland.x0, kIsland.y1, kIsland.x1, kLakeHalfDepth}, kLakeLevel, cells.far_water);
  b.ground({kIsland.x0, -kLakeHalfDepth, kIsland.x1, kIsland.y0}, kLakeLevel, cells.far_water);
}

/// The bank of an island.
void build_island(Builder& b, const Rect& r, Length cell) {
  const Length low = kLakeLevel - m(0.3);
  const std::array corner{Point{r.x0, r.y0, low}, Point{r.x1, r.y0, low}, Point{r.x1, r.y1, low}, Point{r.x0, r.y1, low}};
  for (std::size_t i = 0; i < 4; ++i) b.band(corner[i], corner[(i + 1) % 4], -low, cell);
}

/// A straight piece of the precinct wall, `length` long. `along` of its frame runs along the wall, `out` points away from
/// the precinct.
struct Run {
  Frame frame;
  Length length;
};

std::vector<Run> wall_runs() {
  const Rect& p = kPrecinct;
  const Length across = p.width() / 2;
  const Length to_gate = p.depth() / 2 - kGateHalfWidth;
  return {{{{p.x0, p.y0, 0}, 1, 0}, across},   {{{p.x0 + across, p.y0, 0}, 1, 0}, across},
          {{{p.x1, p.y0, 0}, 0, 1}, to_gate},  {{{p.x1, kGateHalfWidth, 0}, 0, 1}, to_gate},
          {{{p.x1, p.y1, 0}, -1, 0}, across},  {{{p.x1 - across, p.y1, 0}, -1, 0}, across},
          {{{p.x0, p.y1, 0}, 0, -1}, to_gate}, {{{p.x0, -kGateHalfWidth, 0}, 0, -1}, to_gate}};
}

void build_wall(Builder& b) {
  for (const Run& run : wall_runs()) {
    b.box(run.frame, {0, run.length, 0, kWallThickness, -m(0.3), kWallHeight}, kSides);
    // The top in short pieces, which are seen edge-on.
    const Length pieces = divide_up(run.length, m(6));
    for (Length i = 0; i < pieces; ++i) {
      b.level(run.frame, run.length * i / pieces, run.length * (i + 1) / pieces, 0, kWallThickness, kWallHeight);
    }
  }
  // Pylons beside the gates.
  for (const Length x : {kPrecinct.x0 - m(3), kPrecinct.x1 - m(1)}) {
    for (const Length y : {kGateHalfWidth - m(0.6), -kGateHalfWidth - m(3.4)}) {
      b.box({{x, y, 0}, 0, 1}, {0, m(4), 0, m(4), -m(0.3), m(7.5)}, kOnGround);
    }
  }
}

/// Serpents' heads and merlons on one run of the wall.
void decorate_wall(Builder& b, const Run& run) {
  const Length merlons = run.length / m(2.4);
  for (Length i = 0; i < merlons; ++i) {
    const Length along = run.length * i / merlons + m(0.5);
    b.box(run.frame, {along, along + m(1.3), m(0.3), kWallThickness - m(0.3), kWallHeight, kWallHeight + m(0.9)}, kOnGround);
    if (i % 4 != 2) continue;
    for (const Length inwards : {Length{0}, Length{1}}) {
      const Frame head =
          inwards != 0 ? run.frame.moved(along + m(1), 0, m(3.2), 2) : run.frame.moved(along, kWallThickness, m(3.2));
      b.box(head, {0, m(1), 0, m(0.7), 0, m(0.8)}, kOnWall);
      // Snout, narrowing to the front; eyes; tongue.
      const std::array wide{head.at(m(0.1), m(0.7), m(0.1)), head.at(m(0.9), m(0.7), m(0.1)),
                            head.at(m(0.9), m(0.7), m(0.6)), head.at(m(0.1), m(0.7), m(0.6))};
      const Point tip = head.at(m(0.5), m(1.3), m(0.2));
      for (std::size_t k = 0; k < 4; ++k) b.triangle(wide[k], wide[(k + 1) % 4], tip);
      b.facing(head, m(0.15), m(0.35), m(0.63), m(0.75), m(0.74));
      b.facing(head, m(0.65), m(0.85), m(0.63), m(0.75), m(0.74));
      b.triangle(head.at(m(0.45), m(1), m(0.08)), head.at(m(0.55), m(1), m(0.08)), head.at(m(0.5), m(1.6), -m(0.2)));
    }
  }
  // A running relief of coils at eye height, on the inside.
  const Length coils = run.length / m(1.2);
  for (Length i = 0; i < coils; ++i) {
    const Length along = run.length * i / coils;
    b.box(run.frame, {along + m(0.1), along + m(0.9), -m(0.1), 0, m(1.2), m(1.9)}, kBack | kLeft | kRight | kTop | kBottom);
    b.facing(run.frame, along + m(0.3), along + m(0.7), m(1.4), m(1.7), -m(0.14));
  }
}

/// Two aqueducts on arcaded walls bring water from the hills, one along either side of the eastern causeway.
void build_aqueducts(Builder& b) {
  constexpr Length kHeight = m(2.7);
  const Length from = kPrecinct.x1 + kWallThickness + m(2);
  const Length length = kHills.x0 - from;
  for (const Length y : {kCausewayHalfWidth - m(0.9), -kCausewayHalfWidth + m(0.1)}) {
    const Frame f{{from, y, 0}, 0, 1};
    for (Length i = 0; i < 2; ++i) {
      b.box(f, {0, m(0.8), length * i / 2, length * (i + 1) / 2, -m(0.3), kHeight}, kSides);
    }
    // The channel: a floor below the rim, in short slabs.
    const Length slabs = length / m(2);
    for (Length i = 0; i < slabs; ++i)
      b.level(f, 0, m(0.8), length * i / slabs, length * (i + 1) / slabs, kHeight - m(0.25));
  }
}

/// The pyramid on this foot. It faces south, turned by `quarters` quarter turns counter-clockwise.
Pyramid pyramid_on(const Rect& foot, int quarters, Length tiers, Length tier_height, Length flights) {
  const Point middle{(foot.x0 + foot.x1) / 2, (foot.y0 + foot.y1) / 2, 0};
  const bool turned = quarters % 2 != 0;
  Pyramid p{};
  p.width = turned ? foot.depth() : foot.width();
  p.depth = turned ? foot.width() : foot.depth();
  p.tiers = tiers;
  p.tier_height = tier_height;
  p.flights = flights;
  p.frame = Frame{middle, 1, 0}.moved(0, 0, 0, quarters).moved(0, p.depth / 2, 0);
  return p;
}

std::vector<Pyramid> pyramids() {
  constexpr int kSouth = 0, kEast = 1, kNorth = 2, kWest = 3;
  return {pyramid_on(kTemplo, kWest, 5, m(5.2), 2),
          pyramid_on({m(112), m(58), m(144), m(90)}, kSouth, 3, m(4), 1),
          pyramid_on({m(232), m(80), m(272), m(110)}, kSouth, 3, m(4.6), 1),
          pyramid_on({m(110), m(-84), m(150), m(-48)}, kNorth, 4, m(4), 1),
          pyramid_on({m(228), m(-104), m(276), m(-68)}, kNorth, 4, m(4.2), 2),
          pyramid_on({m(292), m(72), m(322), m(104)}, kWest, 3, m(4), 1),
          pyramid_on({m(296), m(-90), m(324), m(-58)}, kWest, 3, m(3.6), 1),
          pyramid_on({m(166), m(82), m(196), m(110)}, kSouth, 3, m(3.8), 1),
          pyramid_on({m(98), m(16), m(118), m(36)}, kEast, 2, m(3.4), 1)};
}

constexpr Rect kSkullRack{m(162), m(-22), m(176), m(8)};

/// Ball court, skull rack and the low altars of the plaza.
void build_courts(Builder& b) {
  // Two long ranges with a sloping bench each, the alley between them.
  for (const int quarters : {0, 2}) {
    const Frame f = Frame{{m(186), m(-84), 0}, 1, 0}.moved(0, 0, 0, quarters).moved(0, -m(5), 0);
    b.box(f, {-m(20), m(20), -m(7), 0, -m(0.3), m(4.5)}, kOnGround);
    b.quad(f.at(-m(20), m(2), m(0.9)), f.at(m(20), m(2), m(0.9)), f.at(m(20), 0, m(2)), f.at(-m(20), 0, m(2)));
    b.facing(f, -m(20), m(20), -m(0.2), m(0.9), m(2));
    b.box(f, {-m(0.3), m(0.3), 0, m(0.6), m(3), m(4)}, kOnWall);
  }
  for (const Length x : {m(160), m(206)}) {
    b.box({{x, m(-84), 0}, 1, 0}, {0, m(6), -m(12), m(12), -m(0.3), m(1.8)}, kOnGround);
  }
  const Rect& r = kSkullRack;
  b.box({{r.x0, r.y0, 0}, 0, 1}, {0, r.depth(), 0, r.width(), -m(0.3), m(1.6)}, kOnGround);
  for (const Point& at :
       {Point{m(140), m(-18), 0}, Point{m(190), m(24), 0}, Point{m(290), m(-44), 0}, Point{m(218), m(62) + m(12), 0}}) {
    b.box({at, 1, 0}, {-m(3), m(3), -m(3), m(3), -m(0.3), m(0.9)}, kOnGround);
    b.box({at, 1, 0}, {-m(2.2), m(2.2), -m(2.2), m(2.2), m(0.9), m(1.6)}, kOnGround);
  }
}

/// Posts, poles, and skulls (octahedra) strung on them.
void build_skulls(Builder& b, std::uint64_t seed, std::size_t target) {
  const Rect& r = kSkullRack;
  constexpr Length kFloor = m(1.6);
  constexpr Length kRow = m(2.6);
  Random random(seed, kSkullKind, 0);
  for (Length row = 0; row < 5; ++row) {
    const Frame f{{r.x0 + m(1) + row * kRow, r.y0, kFloor}, 0, 1};
    for (Length post = 0; post <= 10; ++post) {
      const Length along = m(0.5) + (r.depth() - m(1)) * post / 10;
      b.box(f, {along - m(0.1), along + m(0.1), -m(0.1), m(0.1), 0, m(4.2)}, kOnGround);
    }
    for (Length tier = 0; tier < 7; ++tier) {
      const Length up = m(0.6) + tier * m(0.5);
      b.box(f, {m(0.4), r.depth() - m(0.4), -m(0.03), m(0.03), up - m(0.03), up + m(0.03)}, kSides | kTop);
      for (Length i = 0; i < 50; ++i) {
        if (b.size() >= target) return;
        const Length along = m(0.8) + (r.depth() - m(1.6)) * i / 50 + random.between(0, m(0.06));
        if (random.chance(12)) continue;
        const Point centre = f.at(along, 0, up);
        const Length s = m(0.15);
        const std::array ring{Point{centre.x + s, centre.y, centre.z}, Point{centre.x, centre.y + s, centre.z},
                              Point{centre.x - s, centre.y, centre.z}, Point{centre.x, centre.y - s, centre.z}};
        for (std::size_t k = 0; k < 4; ++k) {
          b.triangle(ring[k], ring[(k + 1) % 4], {centre.x, centre.y, centre.z + s});
          b.triangle(ring[(k + 1) % 4], ring[k], {centre.x, centre.y, centre.z - m(0.2)});
        }
      }
    }
  }
}

/// A place for an adobe house.
struct Adobe {
  Point foot;
  std::uint64_t seed;
};

Length adobe_height(Random& random) { return random.between(m(2.6), m(3.4)); }

void build_adobe_shell(Builder& b, const Adobe& a) {
  Random random(a.seed);
  const Frame f = Frame{a.foot, 1, 0}.moved(0, 0, 0, static_cast<int>(random.below(4)));
  const Length height = adobe_height(random);
  b.box(f, {-m(3), m(3), -m(2.5), m(2.5), -m(0.2), height}, kOnGround);
  // A wing round the yard, lower than the house.
  b.box(f, {-m(3), -m(0.5), m(2.5), m(4.2), -m(0.2), height - m(0.5)}, kFront | kLeft | kRight | kTop);
}

void build_adobe_details(Builder& b, const Adobe& a) {
  Random random(a.seed);
  const Frame f = Frame{a.foot, 1, 0}.moved(0, 0, 0, static_cast<int>(random.below(4)));
  const Length height = adobe_height(random);
  // Doorway with a lintel, small windows.
  b.facing(f, m(0.6), m(1.6), 0, m(1.9), m(2.54));
  b.box(f, {m(0.4), m(1.8), m(2.5), m(2.62), m(1.95), m(2.15)}, kOnWall);
  b.facing(f, m(2), m(2.5), m(1.2), m(1.7), m(2.54));
  const Frame back = f.moved(0, 0, 0, 2);
  for (Length i = 0; i < 3; ++i) b.facing(back, -m(2.2) + i * m(1.8), -m(1.7) + i * m(1.8), m(1.3), m(1.8), m(2.54));
  // Ends of the roof beams, front and back; a parapet.
  for (Length i = 0; i < 6; ++i) {
    const Length along = -m(2.6) + i * m(1);
    b.box(back, {along, along + m(0.18), m(2.5), m(2.85), height - m(0.5), height - m(0.32)}, kOnWall);
  }
  b.box(f, {-m(3), m(3), m(2.3), m(2.5), height, height + m(0.4)}, kBack | kTop | kLeft | kRight);
  b.box(f, {-m(3), m(3), -m(2.5), -m(2.3), height, height + m(0.4)}, kFront | kTop | kLeft | kRight);
  // Jars and a hearth in the yard.
  const Length jars = random.between(2, 5);
  for (Length i = 0; i < jars; ++i) {
    const Length along = m(0.2) + i * m(0.6);
    const Frame jar = f.moved(along, m(3.6), 0);
    b.box(jar, {-m(0.2), m(0.2), -m(0.2), m(0.2), m(0.1), m(0.5)}, kAllFaces);
    b.box(jar, {-m(0.11), m(0.11), -m(0.11), m(0.11), m(0.5), m(0.65)}, kOnGround);
  }
  b.box(f, {m(2), m(2.7), m(3), m(3.7), 0, m(0.2)}, kOnGround);
}

/// A bed of maize: crossed blades.
void build_maize(Builder& b, const Point& foot, Random random) {
  for (Length j = 0; j < 3; ++j) {
    for (Length i = 0; i < 5; ++i) {
      const Point p{foot.x + i * m(0.6), foot.y + j * m(0.7), foot.z};
      const Length height = random.between(m(1.2), m(2.1));
      const Length lean = random.between(m(0.2), m(0.4));
      b.triangle({p.x - m(0.05), p.y, p.z}, {p.x + m(0.05), p.y, p.z}, {p.x, p.y, p.z + height});
      b.triangle({p.x, p.y, p.z + m(0.3)}, {p.x, p.y, p.z + m(0.4)}, {p.x + lean, p.y + m(0.1), p.z + height / 2});
      b.triangle({p.x, p.y, p.z + m(0.5)}, {p.x, p.y, p.z + m(0.6)}, {p.x - lean, p.y - m(0.1), p.z + height * 2 / 3});
    }
  }
}

constexpr Length kAdobePitch = m(11);

/// Places for houses on `land`, at equal distances with some variation.
std::vector<Adobe> places_on(const Rect& land, std::uint64_t seed, std::uint64_t first) {
  std::vector<Adobe> places;
  for (Length y = land.y0 + m(6); y <= land.y1 - m(6); y += kAdobePitch) {
    for (Length x = land.x0 + m(6); x <= land.x1 - m(6); x += kAdobePitch) {
      Random random(seed, kAdobeKind, first + places.size());
      Point foot{x, y, 0};
      foot.x += random.between(-m(0.6), m(0.6));
      foot.y += random.between(-m(0.6), m(0.6));
      places.push_back({foot, random.next()});
    }
  }
  return places;
}

/// The town between the wall of the precinct and the shore.
std::vector<Adobe> town(std::uint64_t seed, const Route& route) {
  const Rect keep_off = kPrecinct.inset(-kWallThickness - m(5.5));
  std::vector<Adobe> result;
  for (const Adobe& a : places_on(kIsland, seed, 0)) {
    const Rect at{a.foot.x, a.foot.y, a.foot.x, a.foot.y};
    if (!keep_off.meets(at) && !route.crosses(at, m(7))) result.push_back(a);
  }
  return result;
}

/// Gardens on the lake, in bands ever farther to the north and south.
void build_chinampas(Builder& b, std::uint64_t seed, const Cells& cells, std::size_t target) {
  constexpr Length kBand = m(60);
  constexpr Length kPitch = m(83);
  constexpr Length kCanal = m(7);
  std::uint64_t index = 0;
  for (Length band = 0; b.size() < target; ++band) {
    const Length from = kLakeHalfDepth + band / 2 * kBand;
    const Length y0 = band % 2 == 0 ? from : -from - kBand;
    const Length x0 = kQuayEast;
    for (Length i = 0; i < 5 && b.size() < target; ++i, ++index) {
      const Rect water{x0 + i * kPitch, y0, x0 + (i + 1) * kPitch, y0 + kBand};
      const Rect land = water.inset(kCanal);
      b.ground({water.x0, water.y0, water.x1, land.y0}, kLakeLevel, cells.far_water);
      b.ground({water.x0, land.y1, water.x1, water.y1}, kLakeLevel, cells.far_water);
      b.ground({water.x0, land.y0, land.x0, land.y1}, kLakeLevel, cells.far_water);
      b.ground({land.x1, land.y0, water.x1, land.y1}, kLakeLevel, cells.far_water);
      build_island(b, land, cells.town);
      b.ground(land, 0, cells.town);
      for (const Adobe& a : places_on(land, seed, (index + 1) * 1000)) {
        Random random(a.seed, kMaizeKind, 0);
        if (random.chance(55)) {
          build_adobe_shell(b, a);
          build_adobe_details(b, a);
        } else {
          const Length beds = random.between(2, 4);
          for (Length k = 0; k < beds; ++k) {
            build_maize(b, {a.foot.x - m(3), a.foot.y - m(4) + k * m(2.4), 0}, Random(random.next()));
          }
        }
      }
    }
  }
}

}  // namespace

void build_tenochtitlan(Builder& b, std::uint64_t seed, const Route& route, std::size_t target) {
  const std::size_t budget = target > b.size() ? target - b.size() : 0;
  const Cells cells = cells_for(budget);
  build_water(b, route, cells);
  build_island(b, kIsland, cells.far_water);
  build_pavement(b, route, kPrecinct, 0, cells.plaza, cells.parts);
  const Rect walled = kPrecinct.inset(-kWallThickness);
  b.ground({kIsland.x0, kIsland.y0, kIsland.x1, walled.y0}, 0, cells.town);
  b.ground({kIsland.x0, walled.y1, kIsland.x1, kIsland.y1}, 0, cells.town);
  build_pavement(b, route, {kIsland.x0, walled.y0, walled.x0, walled.y1}, 0, cells.town, cells.parts);
  build_pavement(b, route, {walled.x1, walled.y0, kIsland.x1, walled.y1}, 0, cells.town, cells.parts);
  for (const Length x : {walled.x0, kPrecinct.x1}) {  // under the gates
    b.ground({x, -kGateHalfWidth, x + kWallThickness, kGateHalfWidth}, 0, m(1.2));
  }
  build_wall(b);
  const std::vector<Pyramid> all = pyramids();
  for (const Pyramid& p : all) build_pyramid_shell(b, p);
  build_courts(b);
  build_aqueducts(b);

  const std::vector<Adobe> houses = town(seed, route);
  const std::vector<std::size_t> order = shuffled(houses.size(), Random(seed, kOrderKind, 0));
  for (const Adobe& house : houses) build_adobe_shell(b, house);
  const Length stones = budget >= 45'000 ? 8 : 1;
  for (const Pyramid& p : all) {
    if (b.size() >= target) return;
    build_stairs(b, p, p.flights == 2 ? stones : (stones + 1) / 2);
  }
  for (const Run& run : wall_runs()) {
    if (b.size() >= target) return;
    decorate_wall(b, run);
  }
  for (const std::size_t i : order) {
    if (b.size() >= target) return;
    build_adobe_details(b, houses[i]);
  }
  build_skulls(b, seed, target);
  build_chinampas(b, seed, cells, target);
}

}  // namespace occlude::render::city
