// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <vector>

#include "buildings.h"
#include "nature.h"
#include "parts.h"
#include "plan.h"
#include "random.h"
#include "terrace.h"

namespace occlude::render::city {
namespace {

// Kinds of random generator, see Random.
constexpr std::uint64_t kTerraceKind = 1;
constexpr std::uint64_t kBlockKind = 2;
constexpr std::uint64_t kOrderKind = 3;

/// Sizes of the pieces of ground. Large pieces near the camera would be chosen as occluders instead of walls, so the pieces
/// are small. A small model cannot afford that.
struct Paving {
  Length flags, street, garden;
  Length parts;  ///< cuts of a piece of street near the camera
};

Paving paving_for(std::size_t budget) {
  if (budget >= 200'000) return {m(1.6), m(5), m(6), 5};
  if (budget >= 60'000) return {m(2.5), m(6), m(8), 4};
  return {m(10), m(12), m(16), 3};
}

struct BuiltBlock {
  Block plan;
  std::uint64_t index = 0;
  std::vector<Terrace> terraces;
};

/// The land inside the pavement.
Rect plot(const Block& block) { return block.land.inset(kPavement); }

/// The terraces of one side of a block. A side of more than 84 m gets two, some with an alley between them.
void line_side(BuiltBlock& block, Terrace side, std::uint64_t seed) {
  constexpr Length kLongest = m(84);
  constexpr Length kAlley = m(2.4);
  Random random(seed, kTerraceKind, block.index * 8 + block.terraces.size());
  if (side.length <= kLongest) {
    design_terrace(side, random);
    block.terraces.push_back(std::move(side));
    return;
  }
  const Length gap = random.chance(40) ? kAlley : 0;
  const Length cut = side.length * random.between(42, 58) / 100;
  Terrace first = side;
  first.length = cut;
  first.garden_to = std::min(side.garden_to, cut);
  first.open_right = gap > 0;
  Terrace second = side;
  second.frame = side.frame.moved(cut + gap, 0, 0);
  second.length = side.length - cut - gap;
  second.garden_from = std::max<Length>(0, side.garden_from - cut - gap);
  second.garden_to = side.garden_to - cut - gap;
  second.open_left = gap > 0;
  design_terrace(first, Random(random.next()));
  design_terrace(second, Random(random.next()));
  block.terraces.push_back(std::move(first));
  block.terraces.push_back(std::move(second));
}

BuiltBlock lay_out(const Block& plan, std::uint64_t index, std::uint64_t seed) {
  BuiltBlock block{plan, index, {}};
  if (plan.use != BlockUse::terraces) return block;
  const Rect r = plot(plan);
  constexpr Length kDepth = kTerraceDepth;
  Terrace side;
  side.depth = kDepth;
  // South and north run from corner to corner; east and west fit between them, so that the corners close.
  side.length = r.width();
  side.open_left = side.open_right = true;
  side.garden = (r.depth() - 2 * kDepth) / 2 - m(1.2);
  side.garden_from = kDepth + m(6);
  side.garden_to = side.length - kDepth - m(6);
  side.frame = {{r.x0, r.y0, 0}, 1, 0};
  line_side(block, side, seed);
  side.frame = {{r.x1, r.y1, 0}, -1, 0};
  line_side(block, side, seed);
  side.length = r.depth() - 2 * kDepth;
  side.open_left = side.open_right = false;
  side.garden = 0;
  if (side.length < m(6)) return block;
  side.frame = {{r.x1, r.y0 + kDepth, 0}, 0, 1};
  line_side(block, side, seed);
  side.frame = {{r.x0, r.y1 - kDepth, 0}, 0, -1};
  line_side(block, side, seed);
  return block;
}

void pave(Builder& b, const Block& block, const Paving& paving) {
  const Rect& l = block.land;
  const Rect r = plot(block);
  b.ground({l.x0, l.y0, l.x1, r.y0}, kPavementLevel, paving.flags);
  b.ground({l.x0, r.y1, l.x1, l.y1}, kPavementLevel, paving.flags);
  b.ground({l.x0, r.y0, r.x0, r.y1}, kPavementLevel, paving.flags);
  b.ground({r.x1, r.y0, l.x1, r.y1}, kPavementLevel, paving.flags);
  // Kerb stones, reaching a little below the carriageway.
  const Length low = m(-0.05);
  const std::array corner{Point{l.x0, l.y0, low}, Point{l.x1, l.y0, low}, Point{l.x1, l.y1, low}, Point{l.x0, l.y1, low}};
  for (std::size_t i = 0; i < 4; ++i) b.band(corner[i], corner[(i + 1) % 4], kPavementLevel - low, paving.flags * 2);
}

/// The parts of a block that every model has.
void build_base(Builder& b, const BuiltBlock& block, const Paving& paving, const Route& route) {
  pave(b, block.plan, paving);
  const Rect r = plot(block.plan);
  switch (block.plan.use) {
    case BlockUse::terraces:
      b.ground(r, m(0.06), paving.garden);  // also under the houses, because alleys lead between them
      for (const Terrace& t : block.terraces) build_shell(b, t);
      break;
    case BlockUse::garden_square:
      build_pavement(b, route, r, kPavementLevel, paving.street, paving.parts);
      break;
    case BlockUse::church:
      b.ground(r, m(0.08), paving.street);
      build_church_shell(b, r);
      break;
  }
}

/// A fence of bars round `r`, with openings where the camera passes.
void fence(Builder& b, const Rect& r, const Route& route) {
  const std::array sides{Frame{{r.x0, r.y0, kPavementLevel}, 1, 0}, Frame{{r.x1, r.y0, kPavementLevel}, 0, 1},
                         Frame{{r.x1, r.y1, kPavementLevel}, -1, 0}, Frame{{r.x0, r.y1, kPavementLevel}, 0, -1}};
  for (std::size_t s = 0; s < 4; ++s) {
    const Length length = s % 2 == 0 ? r.width() : r.depth();
    const Length panels = length / m(3);
    for (Length i = 0; i < panels; ++i) {
      const Length a0 = length * i / panels;
      const Length a1 = length * (i + 1) / panels;
      const Point p = sides[s].at(a0, 0, 0);
      const Point q = sides[s].at(a1, 0, 0);
      if (route.crosses({std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)})) continue;
      b.box(sides[s], {a0, a0 + m(0.1), -m(0.05), m(0.05), 0, m(1.7)}, kOnGround);
      b.box(sides[s], {a0 + m(0.1), a1, -m(0.035), m(0.035), m(1.4), m(1.46)}, kFront | kBack | kTop);
      for (Length k = 1; k < 12; ++k) {
        const Length along = a0 + (a1 - a0) * k / 12;
        b.facing(sides[s], along - m(0.012), along + m(0.012), m(0.05), m(1.6), 0);
      }
    }
  }
}

void build_garden(Builder& b, const Rect& r, const Route& route, Random random) {
  fence(b, r.inset(m(0.6)), route);
  const Point centre{(r.x0 + r.x1) / 2 + m(6), (r.y0 + r.y1) / 2 - m(8), kPavementLevel};
  if (!route.crosses({centre.x - m(3), centre.y - m(3), centre.x + m(3), centre.y + m(3)})) {
    // A statue: a stepped plinth, and a standing figure of three blocks.
    const Frame f{centre, 1, 0};
    for (Length i = 0; i < 4; ++i) {
      b.box(f,
            {-m(2) + i * m(0.4), m(2) - i * m(0.4), -m(2) + i * m(0.4), m(2) - i * m(0.4), i * m(0.25), (i + 1) * m(0.25)},
            kOnGround);
    }
    b.box(f, {-m(0.7), m(0.7), -m(0.7), m(0.7), m(1), m(3.2)}, kOnGround);
    b.box(f, {-m(0.25), m(0.25), -m(0.2), m(0.2), m(3.2), m(4.1)}, kSides);
    b.box(f, {-m(0.35), m(0.35), -m(0.25), m(0.25), m(4.1), m(4.9)}, kAllFaces);
    b.box(f, {-m(0.14), m(0.14), -m(0.14), m(0.14), m(4.9), m(5.25)}, kAllFaces);
  }
  for (Length i = 0; i < 90; ++i) {
    const Point foot{r.x0 + m(3) + random.below(r.width() - m(6)), r.y0 + m(3) + random.below(r.depth() - m(6)),
                     kPavementLevel};
    const Random tree(random.next());
    // A crown is up to 2.7 m wide; the camera keeps to the walks.
    if (!route.crosses({foot.x, foot.y, foot.x, foot.y}, m(4))) add_tree(b, foot, 50, tree);
  }
  for (Length i = 0; i < 24; ++i) {
    const Point foot{r.x0 + m(3) + random.below(r.width() - m(6)), r.y0 + m(3) + random.below(r.depth() - m(6)),
                     kPavementLevel};
    if (!route.crosses({foot.x - m(1), foot.y - m(1), foot.x + m(1), foot.y + m(1)})) add_bench(b, {foot, 1, 0});
  }
}

/// Lamps at the kerb, and the furniture of squares and churchyards.
void build_street_details(Builder& b, const BuiltBlock& block, const Route& route, std::uint64_t seed) {
  const Rect kerb = block.plan.land.inset(m(0.35));
  const Length spacing = m(22);
  const auto lamp = [&](Length x, Length y) {
    if (!route.crosses({x - m(0.2), y - m(0.2), x + m(0.2), y + m(0.2)})) add_lamp(b, {x, y, kPavementLevel});
  };
  for (Length x = kerb.x0 + spacing / 2; x < kerb.x1; x += spacing) {
    lamp(x, kerb.y0);
    lamp(x + spacing / 3, kerb.y1);
  }
  for (Length y = kerb.y0 + spacing / 2; y < kerb.y1; y += spacing) {
    lamp(kerb.x0, y);
    lamp(kerb.x1, y + spacing / 3);
  }
  const Random random(seed, kBlockKind, block.index);
  if (block.plan.use == BlockUse::garden_square) build_garden(b, plot(block.plan), route, random);
  if (block.plan.use == BlockUse::church) build_church_details(b, plot(block.plan), random);
}

/// Trees in the courtyard.
void build_yard_details(Builder& b, const BuiltBlock& block, std::uint64_t seed) {
  if (block.plan.use != BlockUse::terraces) return;
  Random random(seed, kBlockKind, block.index);
  const Rect yard = plot(block.plan).inset(kTerraceDepth + m(3));
  if (yard.width() <= 0 || yard.depth() <= 0) return;
  const Length trees = yard.width() / kUnitsPerMetre * (yard.depth() / kUnitsPerMetre) / 130;
  for (Length i = 0; i < trees; ++i) {
    const Point foot{yard.x0 + random.below(yard.width()), yard.y0 + random.below(yard.depth()), 0};
    const Random tree(random.next());
    add_tree(b, foot, 12, tree);
  }
}

void build_suburb(Builder& b, const BuiltBlock& block, const Paving& paving, const Route& route, std::uint64_t seed) {
  build_base(b, block, paving, route);
  build_street_details(b, block, route, seed);
  for (const Terrace& t : block.terraces) {
    for (const House& h : t.houses) {
      for (int layer = 0; layer < kHouseLayers; ++layer) build_house(b, t, h, static_cast<HouseLayer>(layer), route);
    }
  }
  build_yard_details(b, block, seed);
}

/// The viaducts that close the town to the south and the north.
struct Viaduct {
  Frame frame;
  Length length;
};

std::array<Viaduct, 2> viaducts() {
  const Rect r = kLondon.inset(-kRingRoad);
  const Length length = kQuayEast - r.x0;
  return {{{{{r.x0, r.y1, 0}, 1, 0}, length}, {{{kQuayEast, r.y0, 0}, -1, 0}, length}}};
}

/// A plan with enough suburbs for `budget` polygons: twice the blocks that they need at 9000 polygons per block, in about a
/// square.
LondonPlan plan_for(std::size_t budget) {
  constexpr std::size_t kPolygonsPerBlock = 9000;
  const auto blocks = static_cast<Length>(2 * budget / kPolygonsPerBlock);
  const Length rows = std::max<Length>(6, integer_sqrt(blocks));
  return plan_london(divide_up(blocks, 2 * rows), rows);
}

}  // namespace

void build_london(Builder& b, std::uint64_t seed, const Route& route, std::size_t target) {
  const std::size_t budget = target > b.size() ? target - b.size() : 0;
  const Paving paving = paving_for(budget);
  const LondonPlan plan = plan_for(budget);

  std::vector<BuiltBlock> core;
  for (std::size_t i = 0; i < plan.core_blocks; ++i) core.push_back(lay_out(plan.blocks[i], i, seed));
  for (std::size_t i = 0; i < plan.core_carriageways; ++i) {
    const Rect& street = plan.carriageways[i];
    build_pavement(b, route, street, 0, paving.street, paving.parts);
  }
  for (const BuiltBlock& block : core) build_base(b, block, paving, route);
  for (const Viaduct& v : viaducts()) build_viaduct_shell(b, v.frame, v.length);

  // Each layer of detail goes to the houses in random order, so that it is spread over the whole town wherever it stops.
  struct HouseOf {
    const Terrace* terrace;
    const House* house;
  };
  std::vector<HouseOf> houses;
  for (const BuiltBlock& block : core) {
    for (const Terrace& t : block.terraces) {
      for (const House& h : t.houses) houses.push_back({&t, &h});
    }
  }
  const std::vector<std::size_t> order = shuffled(houses.size(), Random(seed, kOrderKind, 0));
  for (int layer = 0; layer < kHouseLayers; ++layer) {
    for (const std::size_t i : order) {
      if (b.size() >= target) return;
      build_house(b, *houses[i].terrace, *houses[i].house, static_cast<HouseLayer>(layer), route);
    }
    for (const Viaduct& v : viaducts()) {
      if (layer == static_cast<int>(HouseLayer::surrounds) && b.size() < target) build_viaduct_details(b, v.frame, v.length);
    }
    for (const BuiltBlock& block : core) {
      if (b.size() >= target) return;
      if (layer == static_cast<int>(HouseLayer::surrounds)) build_street_details(b, block, route, seed);
      if (layer == static_cast<int>(HouseLayer::glazing)) build_yard_details(b, block, seed);
    }
  }

  std::size_t street = plan.core_carriageways;
  const std::size_t suburbs = plan.blocks.size() - plan.core_blocks;
  for (std::size_t i = 0; i < suburbs && b.size() < target; ++i) {
    const std::size_t streets =
        plan.core_carriageways + (plan.carriageways.size() - plan.core_carriageways) * (i + 1) / suburbs;
    for (; street < streets; ++street) b.ground(plan.carriageways[street], 0, paving.street);
    const std::size_t index = plan.core_blocks + i;
    build_suburb(b, lay_out(plan.blocks[index], index, seed), paving, route, seed);
  }
}

}  // namespace occlude::render::city
