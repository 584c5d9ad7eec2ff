// SPDX-License-Identifier: MIT
#include <array>

#include "buildings.h"
#include "facade.h"
#include "nature.h"

namespace occlude::render::city {
namespace {

constexpr Length kNaveLength = m(30);
constexpr Length kNaveWidth = m(13);
constexpr Length kNaveWall = m(10);
constexpr Length kNaveRidge = m(17);
constexpr Length kTowerWidth = m(8);
constexpr Length kTowerWall = m(24);
constexpr Length kSpire = m(42);

/// The frame of the church. The nave runs along x, with its west end at the origin; the tower is west of it.
Frame site(const Rect& yard) {
  return {{(yard.x0 + yard.x1) / 2 - kNaveLength / 2 + kTowerWidth / 2, (yard.y0 + yard.y1) / 2, 0}, 1, 0};
}

}  // namespace

void build_church_shell(Builder& b, const Rect& yard) {
  const Frame f = site(yard);
  constexpr Length kHalf = kNaveWidth / 2;
  b.facing(f, 0, kNaveLength, m(-0.4), kNaveWall, kHalf);
  b.facing(f, 0, kNaveLength, m(-0.4), kNaveWall, -kHalf);
  for (const Length along : {Length{0}, kNaveLength}) {
    const std::array gable{f.at(along, kHalf, m(-0.4)), f.at(along, kHalf, kNaveWall), f.at(along, 0, kNaveRidge),
                           f.at(along, -kHalf, kNaveWall), f.at(along, -kHalf, m(-0.4))};
    b.polygon(gable);
  }
  for (const Length side : {Length{1}, Length{-1}}) {
    b.quad(f.at(-m(0.3), side * (kHalf + m(0.3)), kNaveWall), f.at(kNaveLength + m(0.3), side * (kHalf + m(0.3)), kNaveWall),
           f.at(kNaveLength + m(0.3), 0, kNaveRidge + m(0.1)), f.at(-m(0.3), 0, kNaveRidge + m(0.1)));
  }
  constexpr Length kHalfTower = kTowerWidth / 2;
  // The tower pierces the west end of the nave: two solids in one place.
  b.box(f, {-kTowerWidth + m(1), m(1), -kHalfTower, kHalfTower, m(-0.4), kTowerWall}, kOnGround);
  const Point tip = f.at(m(1) - kHalfTower, 0, kSpire);
  const std::array foot{
      f.at(m(0.6), kHalfTower - m(0.4), kTowerWall), f.at(m(1.4) - kTowerWidth, kHalfTower - m(0.4), kTowerWall),
      f.at(m(1.4) - kTowerWidth, m(0.4) - kHalfTower, kTowerWall), f.at(m(0.6), m(0.4) - kHalfTower, kTowerWall)};
  for (std::size_t i = 0; i < 4; ++i) b.triangle(foot[i], foot[(i + 1) % 4], tip);
}

void build_church_details(Builder& b, const Rect& yard, Random random) {
  const Frame f = site(yard);
  constexpr WindowStyle kLancet{m(1.4), m(5), 4, 12, true};
  const std::array sides{f.moved(0, kNaveWidth / 2, 0), f.moved(kNaveLength, -kNaveWidth / 2, 0, 2)};
  for (const Frame& side : sides) {
    for (Length i = 0; i < 6; ++i) {
      const Length along = m(2) + i * m(4.8);
      for (const WindowPart part : {WindowPart::blind, WindowPart::surround, WindowPart::panes}) {
        add_window(b, side, along, m(2.5), kLancet, part);
      }
      b.box(side, {along + m(2.7), along + m(3.4), 0, m(0.9), m(-0.3), m(7)}, kFront | kLeft | kRight | kTop);
    }
  }
  const Frame door = f.moved(m(1) - kTowerWidth, -kTowerWidth / 2, 0, 3);
  add_door(b, door, kTowerWidth / 2 - kDoorWidth / 2, m(0.1), false);
  add_door(b, door, kTowerWidth / 2 - kDoorWidth / 2, m(0.1), true);
  // Louvres of the bell chamber, on the two long sides of the tower.
  for (Length i = 0; i < 12; ++i) {
    const Length up = m(18) + i * m(0.35);
    b.facing(f, m(-5), m(-1), up, up + m(0.2), kTowerWidth / 2 + m(0.06));
    b.facing(f, m(-5), m(-1), up, up + m(0.2), -kTowerWidth / 2 - m(0.06));
  }
  // Gravestones in rows between the church and the wall, each with a plinth.
  const Rect church{f.origin.x - m(10), f.origin.y - m(9), f.origin.x + kNaveLength + m(3), f.origin.y + m(9)};
  for (Length y = yard.y0 + m(4); y < yard.y1 - m(4); y += m(3)) {
    for (Length x = yard.x0 + m(4); x < yard.x1 - m(4); x += m(1.9)) {
      const Length dx = random.between(-m(0.2), m(0.2));
      const Length height = random.between(m(0.6), m(1.3));
      if (random.chance(30) || church.meets({x, y, x, y})) continue;
      const Frame g{{x + dx, y, m(0.08)}, 0, 1};
      b.box(g, {-m(0.35), m(0.35), -m(0.14), m(0.14), 0, m(0.18)}, kOnGround);
      b.box(g, {-m(0.28), m(0.28), -m(0.06), m(0.06), m(0.18), height}, kOnGround);
    }
  }
  for (Length i = 0; i < 14; ++i) {
    const Length x = yard.x0 + m(3) + random.below(yard.width() - m(6));
    const Length y = yard.y0 + m(3) + random.below(yard.depth() - m(6));
    const Random tree(random.next());
    if (!church.meets({x, y, x, y})) add_tree(b, {x, y, 0}, 30, tree);
  }
}

}  // namespace occlude::render::city
