// SPDX-License-Identifier: MIT
// Flaws built in on purpose: a third of the party walls exist twice, exactly equal; a wall piece above the street wall
// of a taller house overlaps the party wall's edge; chimney stacks and dormers pierce the roofs; railings are slivers.
#include "terrace.h"

#include <algorithm>
#include <array>

#include "route.h"

namespace occlude::render::city {
namespace {

constexpr Length kFooting = m(-0.4);      // walls begin below the ground, so no light comes through under them
constexpr Length kGroundFloor = m(0.45);  // three steps up
constexpr Length kParapet = m(0.6);
constexpr Length kRidgeRise = m(3.2);
constexpr Length kMansardSetback = m(1.2);
constexpr Length kMansardRise = m(2.6);
constexpr Length kWindowSill = m(0.75);

Length floor_level(const Terrace& t, Length storey) {
  return storey == 0 ? kGroundFloor : kGroundFloor + t.ground_storey + (storey - 1) * t.storey;
}

Length eaves_of(const Terrace& t, Length storeys) { return floor_level(t, storeys) + kParapet; }

/// The height of a house's roof in the middle of its depth, which is the top of its party walls.
Length ridge_of(const House& h) {
  switch (h.roof) {
    case House::Roof::pitched:
      return h.eaves + kRidgeRise;
    case House::Roof::mansard:
      return h.eaves + kMansardRise + m(0.5);
    case House::Roof::butterfly:
      return h.eaves;
  }
  return h.eaves;
}

/// The wall between two houses, or a gable end: up to the higher of the two roofs.
void party_wall(Builder& b, const Terrace& t, Length along, const House& h) {
  const Frame& f = t.frame;
  const Length back = -t.depth;
  if (h.roof == House::Roof::butterfly) {
    b.across(f, along, back, 0, kFooting, h.eaves);
    return;
  }
  if (h.roof == House::Roof::mansard) {
    const Length top = h.eaves + kMansardRise;
    const std::array loop{f.at(along, 0, kFooting),
                          f.at(along, 0, h.eaves),
                          f.at(along, -kMansardSetback, top),
                          f.at(along, back / 2, top + m(0.5)),
                          f.at(along, back + kMansardSetback, top),
                          f.at(along, back, h.eaves),
                          f.at(along, back, kFooting)};
    b.polygon(loop);
    return;
  }
  const std::array loop{f.at(along, 0, kFooting), f.at(along, 0, h.eaves), f.at(along, back / 2, ridge_of(h)),
                        f.at(along, back, h.eaves), f.at(along, back, kFooting)};
  b.polygon(loop);
}

void roof(Builder& b, const Terrace& t, const House& h) {
  const Frame& f = t.frame;
  const Length a0 = h.along0;
  const Length a1 = h.along1;
  const Length back = -t.depth;
  const auto slope = [&](Length out0, Length up0, Length out1, Length up1) {
    b.quad(f.at(a0, out0, up0), f.at(a1, out0, up0), f.at(a1, out1, up1), f.at(a0, out1, up1));
  };
  switch (h.roof) {
    case House::Roof::pitched:
      slope(0, h.eaves, back / 2, ridge_of(h));
      slope(back / 2, ridge_of(h), back, h.eaves);
      break;
    case House::Roof::mansard: {
      const Length top = h.eaves + kMansardRise;
      slope(0, h.eaves, -kMansardSetback, top);
      slope(-kMansardSetback, top, back / 2, top + m(0.5));
      slope(back / 2, top + m(0.5), back + kMansardSetback, top);
      slope(back + kMansardSetback, top, back, h.eaves);
      break;
    }
    case House::Roof::butterfly: {
      // The London roof: two slopes down to a valley that runs from front to back, hidden behind the parapet.
      const Length middle = (a0 + a1) / 2;
      const Length valley = h.eaves - m(1.2);
      const Length rim = h.eaves - m(0.2);
      b.quad(f.at(a0, 0, rim), f.at(middle, 0, valley), f.at(middle, back, valley), f.at(a0, back, rim));
      b.quad(f.at(middle, 0, valley), f.at(a1, 0, rim), f.at(a1, back, rim), f.at(middle, back, valley));
      break;
    }
  }
}

Length bay_left(const House& h, Length bay, Length width) {
  const Length span = (h.along1 - h.along0) / h.bays;
  return h.along0 + span * bay + (span - width) / 2;
}

/// Windows from the second upper floor on are lower.
WindowStyle style_of(const Terrace& t, const House& h, Length storey) {
  WindowStyle s = t.windows;
  if (storey >= 2) s.height = s.height * 4 / 5;
  s.arched_head = h.stucco_arches && storey == 1;
  return s;
}

void front_windows(Builder& b, const Terrace& t, const House& h, WindowPart part) {
  for (Length storey = 0; storey < h.storeys; ++storey) {
    const WindowStyle style = style_of(t, h, storey);
    for (Length bay = 0; bay < h.bays; ++bay) {
      if (storey == 0 && bay == h.door_bay) continue;
      add_window(b, t.frame, bay_left(h, bay, style.width), floor_level(t, storey) + kWindowSill, style, part);
    }
  }
}

/// Windows of a plain wall: the back of a house or a gable end, from `along0` to `along1` of `f`.
void plain_windows(Builder& b, const Frame& f, const Terrace& t, Length along0, Length along1, Length storeys) {
  WindowStyle style{m(1), m(1.5), 2, 2, false};
  for (Length storey = 0; storey < storeys; ++storey) {
    for (Length i = 0; i < 2; ++i) {
      const Length middle = along0 + (along1 - along0) * (2 * i + 1) / 4;
      const Length up = floor_level(t, storey) + kWindowSill + m(0.1);
      add_window(b, f, middle - style.width / 2, up, style, WindowPart::blind);
      add_window(b, f, middle - style.width / 2, up, style, WindowPart::panes);
      b.box(f, {middle - m(0.6), middle + m(0.6), 0, kSillOut, up - m(0.1), up}, kFront | kTop | kBottom);
    }
  }
}

void openings(Builder& b, const Terrace& t, const House& h) {
  front_windows(b, t, h, WindowPart::blind);
  add_door(b, t.frame, bay_left(h, h.door_bay, kDoorWidth), kGroundFloor, false);
  const Length foot = h.eaves - m(1.5);
  const Length top = ridge_of(h) + m(1.8);
  b.box(t.frame, {h.along0 + m(0.25), h.along0 + m(0.95), -t.depth * 3 / 4, -t.depth * 3 / 4 + m(2.2), foot, top},
        kOnGround);
}

void surrounds(Builder& b, const Terrace& t, const House& h) {
  front_windows(b, t, h, WindowPart::surround);
  const Length door = bay_left(h, h.door_bay, kDoorWidth);
  add_door(b, t.frame, door, kGroundFloor, true);
  // A cornice and a string course. The cornice has end faces, which show beside a lower neighbour.
  b.box(t.frame, {h.along0, h.along1, 0, m(0.3), h.eaves - m(0.6), h.eaves - m(0.32)}, kOnWall);
  const Length course = kGroundFloor + t.ground_storey - m(0.15);
  b.box(t.frame, {h.along0, h.along1, 0, m(0.08), course, course + m(0.2)}, kFront | kTop | kBottom);
  // Three steps up to the door, each one a block in front of the higher one.
  for (Length i = 0; i < 3; ++i) {
    b.box(t.frame, {door - m(0.2), door + kDoorWidth + m(0.2), 0, m(0.9) - i * m(0.28), m(0.15) * i, m(0.15) * (i + 1)},
          kFront | kTop | kLeft | kRight);
  }
}

void backs(Builder& b, const Terrace& t, const House& h) {
  Random random(h.seed, 3, 0);
  const Frame back = t.frame.moved(t.length, -t.depth, 0, 2);
  const Length a0 = t.length - h.along1;
  const Length a1 = t.length - h.along0;
  plain_windows(b, back, t, a0, a1, h.storeys);
  if (t.open_left && h.along0 == 0) plain_windows(b, t.frame.moved(0, -t.depth, 0, 3), t, 0, t.depth, h.storeys);
  if (t.open_right && h.along1 == t.length) plain_windows(b, t.frame.moved(t.length, 0, 0, 1), t, 0, t.depth, h.storeys);
  // Kitchen extension, garden wall to the neighbour, shed.
  if (t.garden < m(6) || h.along0 < t.garden_from || h.along1 > t.garden_to) return;
  const Length garden = t.garden;
  b.box(back, {a1 - m(0.24), a1, 0, garden, m(-0.2), m(1.9)}, kOnGround);
  b.box(back, {a0, a1 - m(0.24), garden - m(0.24), garden, m(-0.2), m(1.9)}, kOnGround);
  if (random.chance(60)) {
    const Length reach = m(3) + random.below(m(1.5));
    const Length wide = (a1 - a0) * 2 / 5;
    const Length left = a0 + m(0.4);
    b.box(back, {left, left + wide, 0, reach, kFooting, m(2.7)}, kSides);
    b.quad(back.at(left, 0, m(3.5)), back.at(left + wide, 0, m(3.5)), back.at(left + wide, reach, m(2.7)),
           back.at(left, reach, m(2.7)));
    b.facing(back, left + m(0.4), left + wide - m(0.4), m(1), m(2.2), reach + kBlindOut);
  }
  if (random.chance(55) && garden > m(10)) {
    const Length left = a0 + m(0.5) + random.below(m(1.5));
    const Length far = garden - m(0.8);
    const Frame shed = back.moved(left, far, 0);
    b.box(shed, {0, m(2.2), -m(1.8), 0, 0, m(2)}, kSides);
    b.quad(shed.at(-m(0.1), m(0.1), m(2)), shed.at(m(2.3), m(0.1), m(2)), shed.at(m(2.3), -m(1.9), m(2.5)),
           shed.at(-m(0.1), -m(1.9), m(2.5)));
    b.facing(shed, m(0.6), m(1.4), m(0.05), m(1.85), -m(1.84));
  }
}

void fittings(Builder& b, const Terrace& t, const House& h, const Route& route) {
  Random random(h.seed, 4, 0);
  const Frame& f = t.frame;
  // Chimney pots: four-sided, open at the top.
  const Length top = ridge_of(h) + m(1.8);
  for (Length i = 0; i < 4; ++i) {
    const Length out = -t.depth * 3 / 4 + m(0.2) + i * m(0.5);
    b.box(f, {h.along0 + m(0.45), h.along0 + m(0.75), out, out + m(0.3), top, top + m(0.6)}, kSides);
  }
  // Floors and ceilings.
  for (Length storey = 1; storey <= h.storeys; ++storey) {
    b.level(f, h.along0 + m(0.05), h.along1 - m(0.05), -t.depth + m(0.05), -m(0.05), floor_level(t, storey) - m(0.3));
  }
  if (h.roof == House::Roof::mansard) {
    // Dormers stand on the lower slope.
    for (Length i = 0; i < 2; ++i) {
      const Length middle = h.along0 + (h.along1 - h.along0) * (2 * i + 1) / 4;
      const Frame d = f.moved(middle, -m(0.2), h.eaves + m(0.35));
      b.box(d, {-m(0.6), m(0.6), -m(1.6), 0, 0, m(1.6)}, kFront | kLeft | kRight);
      b.facing(d, -m(0.4), m(0.4), m(0.2), m(1.4), kBlindOut);
      b.quad(d.at(-m(0.7), m(0.1), m(1.6)), d.at(0, m(0.1), m(2)), d.at(0, -m(1.6), m(2)), d.at(-m(0.7), -m(1.6), m(1.6)));
      b.quad(d.at(m(0.7), m(0.1), m(1.6)), d.at(0, m(0.1), m(2)), d.at(0, -m(1.6), m(2)), d.at(m(0.7), -m(1.6), m(1.6)));
      b.triangle(d.at(-m(0.6), 0, m(1.6)), d.at(m(0.6), 0, m(1.6)), d.at(0, 0, m(1.94)));
    }
  }
  if (!t.railings) return;
  // Area railings beside the steps: thin upright bars under a rail.
  const Length door = bay_left(h, h.door_bay, kDoorWidth);
  const auto run = [&](Length a0, Length a1) {
    if (a1 - a0 < m(0.8)) return;
    const Point p = f.at(a0, m(0.95), 0);
    const Point q = f.at(a1, m(0.95), 0);
    if (route.crosses({std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)})) return;
    b.box(f, {a0, a1, m(0.915), m(0.985), m(1.05), m(1.1)}, kFront | kTop | kBack);
    const Length bars = (a1 - a0) / m(0.28);
    for (Length i = 0; i < bars; ++i) {
      const Length along = a0 + (a1 - a0) * (2 * i + 1) / (2 * bars);
      b.facing(f, along - m(0.012), along + m(0.012), m(0.15), m(1.3), m(0.95));
    }
  };
  run(h.along0 + m(0.05), door - m(0.3));
  run(door + kDoorWidth + m(0.3), h.along1 - m(0.05));
}

}  // namespace

void design_terrace(Terrace& t, Random random) {
  t.ground_storey = random.between(m(3.5), m(4.2));
  t.storey = random.between(m(2.9), m(3.4));
  const Length storeys = random.chance(50) ? 3 : 4;
  t.eaves = eaves_of(t, storeys);
  t.railings = random.chance(70);
  // Georgian sashes of many panes, Victorian ones of few.
  const bool georgian = random.chance(40);
  t.windows = {random.between(m(0.95), m(1.15)), random.between(m(1.7), m(1.9)), georgian ? 3 : 2, georgian ? 4 : 2, false};
  const bool arches = random.chance(40);
  const Length count = std::max<Length>(1, t.length / random.between(m(7.6), m(9.6)));
  const Length door_side = random.below(2);
  const auto usual_roof = static_cast<House::Roof>(random.below(3));
  for (Length i = 0; i < count; ++i) {
    House h;
    h.along0 = t.length * i / count;
    h.along1 = t.length * (i + 1) / count;
    h.seed = random.next();
    h.bays = h.along1 - h.along0 > m(8.5) ? 3 : 2;
    h.door_bay = door_side * (h.bays - 1);
    h.storeys = storeys + (random.chance(25) ? 1 : 0);
    h.eaves = eaves_of(t, h.storeys);
    h.roof = random.chance(75) ? usual_roof : static_cast<House::Roof>(random.below(3));
    h.stucco_arches = arches;
    t.houses.push_back(h);
  }
}

void build_shell(Builder& b, const Terrace& t) {
  b.facing(t.frame, 0, t.length, kFooting, t.eaves, 0);
  b.facing(t.frame, 0, t.length, kFooting, t.eaves, -t.depth);
  for (std::size_t i = 0; i < t.houses.size(); ++i) {
    const House& h = t.houses[i];
    if (h.eaves > t.eaves) {
      b.facing(t.frame, h.along0, h.along1, t.eaves, h.eaves, 0);
      b.facing(t.frame, h.along0, h.along1, t.eaves, h.eaves, -t.depth);
    }
    roof(b, t, h);
    const House& left = i > 0 ? t.houses[i - 1] : h;
    party_wall(b, t, h.along0, ridge_of(left) > ridge_of(h) ? left : h);
    if (i % 3 == 1) party_wall(b, t, h.along0, ridge_of(left) > ridge_of(h) ? left : h);
  }
  party_wall(b, t, t.length, t.houses.back());
}

void build_house(Builder& b, const Terrace& t, const House& h, HouseLayer layer, const Route& route) {
  switch (layer) {
    case HouseLayer::openings:
      openings(b, t, h);
      break;
    case HouseLayer::surrounds:
      surrounds(b, t, h);
      break;
    case HouseLayer::glazing:
      front_windows(b, t, h, WindowPart::panes);
      break;
    case HouseLayer::back:
      backs(b, t, h);
      break;
    case HouseLayer::fittings:
      fittings(b, t, h, route);
      break;
  }
}

}  // namespace occlude::render::city
