// SPDX-License-Identifier: MIT
#include <array>

#include "buildings.h"
#include "facade.h"

namespace occlude::render::city {
namespace {

constexpr Length kHalfLength = m(5);
constexpr Length kHalfDepth = m(3);
constexpr Length kWall = m(3.1);
constexpr Length kRidge = m(6);
constexpr Length kFooting = m(-3);  // the ground falls away under a house on a slope

}  // namespace

void build_cottage_shell(Builder& b, const Frame& f) {
  b.facing(f, -kHalfLength, kHalfLength, kFooting, kWall, kHalfDepth);
  b.facing(f, -kHalfLength, kHalfLength, kFooting, kWall, -kHalfDepth);
  for (const Length along : {-kHalfLength, kHalfLength}) {
    const std::array gable{f.at(along, kHalfDepth, kFooting), f.at(along, kHalfDepth, kWall), f.at(along, 0, kRidge),
                           f.at(along, -kHalfDepth, kWall), f.at(along, -kHalfDepth, kFooting)};
    b.polygon(gable);
  }
  constexpr Length kOverhang = m(0.4);
  for (const Length side : {Length{1}, Length{-1}}) {
    const Length out = side * (kHalfDepth + kOverhang);
    b.quad(f.at(-kHalfLength - kOverhang, out, kWall - m(0.2)), f.at(kHalfLength + kOverhang, out, kWall - m(0.2)),
           f.at(kHalfLength + kOverhang, 0, kRidge + m(0.15)), f.at(-kHalfLength - kOverhang, 0, kRidge + m(0.15)));
  }
}

void build_cottage_details(Builder& b, const Frame& f, Random random) {
  constexpr WindowStyle kCasement{m(1.2), m(1.1), 4, 4, false};
  const std::array sides{f.moved(0, kHalfDepth, 0), f.moved(0, -kHalfDepth, 0, 2)};
  for (const Frame& side : sides) {
    for (const Length along : {-m(4), -m(1.9), m(0.4), m(2.6)}) {
      if (along == m(0.4)) {
        add_door(b, side, along, m(0.05), false);
        add_door(b, side, along, m(0.05), true);
        continue;
      }
      for (const WindowPart part : {WindowPart::blind, WindowPart::surround, WindowPart::panes}) {
        add_window(b, side, along, m(1), kCasement, part);
      }
    }
  }
  // A chimney at one gable.
  const Length along = random.chance(50) ? kHalfLength - m(1) : -kHalfLength + m(0.1);
  b.box(f, {along, along + m(0.9), -m(0.5), m(0.5), m(4), kRidge + m(1.5)}, kOnGround);
  for (const Length out : {-m(0.35), m(0.1)}) {
    b.box(f, {along + m(0.3), along + m(0.6), out, out + m(0.25), kRidge + m(1.5), kRidge + m(2)}, kSides);
  }
  // A lean-to, its roof sloping off the gable wall; a water butt.
  b.box(f, {kHalfLength, kHalfLength + m(2.5), -m(2), m(2), kFooting, m(2.1)}, kSides);
  b.quad(f.at(kHalfLength, -m(2.2), m(3)), f.at(kHalfLength, m(2.2), m(3)), f.at(kHalfLength + m(2.7), m(2.2), m(2.1)),
         f.at(kHalfLength + m(2.7), -m(2.2), m(2.1)));
  b.box(f, {-kHalfLength + m(0.2), -kHalfLength + m(0.8), kHalfDepth + m(0.15), kHalfDepth + m(0.8), -m(0.5), m(1)},
        kOnGround);
  // Thatch battens in rows along the roof, 10 cm above it.
  for (Length i = 1; i < 6; ++i) {
    for (const Length side : {Length{1}, Length{-1}}) {
      const Length out = side * (kHalfDepth + m(0.4)) * i / 6;
      const Length up = kRidge + m(0.25) - (kRidge + m(0.35) - kWall) * i / 6;
      b.quad(f.at(-kHalfLength - m(0.3), out, up), f.at(kHalfLength + m(0.3), out, up),
             f.at(kHalfLength + m(0.3), out + side * m(0.12), up - m(0.11)),
             f.at(-kHalfLength - m(0.3), out + side * m(0.12), up - m(0.11)));
    }
  }
}

void build_unfinished_cottage(Builder& b, const Frame& f, Random random) {
  // Walls in pieces of uneven height; the doorway is a gap in the front.
  const auto wall = [&](const Frame& side, Length from, Length to) {
    for (Length along = from; along < to; along += m(1.7)) {
      const Length end = along + m(1.7) < to ? along + m(1.7) : to;
      b.box(side, {along, end, -m(0.3), 0, kFooting, random.between(m(1.2), kWall)}, kOnGround);
    }
  };
  const Frame front = f.moved(0, kHalfDepth, 0);
  const Frame back = f.moved(0, -kHalfDepth, 0, 2);
  wall(front, -kHalfLength, m(0.4));
  wall(front, m(1.6), kHalfLength);
  wall(back, -kHalfLength, kHalfLength);
  wall(f.moved(kHalfLength, 0, 0, 1), -kHalfDepth + m(0.3), kHalfDepth - m(0.3));
  wall(f.moved(-kHalfLength, 0, 0, 3), -kHalfDepth + m(0.3), kHalfDepth - m(0.3));
  // Bare rafters in pairs, each a board of two faces, on wall plates.
  for (const Length out : {kHalfDepth, -kHalfDepth}) {
    b.box(f, {-kHalfLength, kHalfLength, out - m(0.08), out + m(0.08), kWall, kWall + m(0.15)}, kAllFaces);
  }
  const Length pairs = random.between(7, 12);
  for (Length i = 0; i < pairs; ++i) {
    const Length along = -kHalfLength + m(0.3) + (2 * kHalfLength - m(0.7)) * i / pairs;
    for (const Length side : {Length{1}, Length{-1}}) {
      for (const Length face : {along, along + m(0.08)}) {
        b.quad(f.at(face, side * kHalfDepth, kWall), f.at(face, 0, kRidge), f.at(face, 0, kRidge + m(0.2)),
               f.at(face, side * kHalfDepth, kWall + m(0.2)));
      }
    }
  }
  // Scaffold poles and planks along the back.
  for (Length i = 0; i < 5; ++i) {
    const Length along = -m(4.8) + i * m(2.4);
    b.box(back, {along - m(0.05), along + m(0.05), m(1), m(1.1), -m(2), m(4.5)}, kSides);
  }
  for (const Length up : {m(1.8), m(3.6)}) b.box(back, {-m(5), m(5), m(0.35), m(1), up, up + m(0.06)}, kAllFaces);
}

}  // namespace occlude::render::city
