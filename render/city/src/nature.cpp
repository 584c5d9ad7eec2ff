// SPDX-License-Identifier: MIT
#include "nature.h"

#include <array>
#include <cstddef>

namespace occlude::render::city {
namespace {

struct Direction {
  Length x, y;
};
// A regular hexagon, 1024 units in radius.
constexpr std::array<Direction, 6> kHexagon{{{1024, 0}, {512, 887}, {-512, 887}, {-1024, 0}, {-512, -887}, {512, -887}}};

Point rim(const Point& centre, Length radius, std::size_t i) {
  return {centre.x + kHexagon[i % 6].x * radius / 1024, centre.y + kHexagon[i % 6].y * radius / 1024, centre.z};
}

}  // namespace

void add_tree(Builder& b, const Point& foot, Length leaves, Random random) {
  const Length height = random.between(m(5), m(9));
  const Length radius = height * random.between(20, 30) / 100;
  const Length trunk = m(0.12) + height / 60;
  const Length first = height * random.between(25, 35) / 100;
  b.box({foot, 1, 0}, {-trunk, trunk, -trunk, trunk, -m(0.5), first + height / 6}, kSides);
  const Point low{foot.x, foot.y, foot.z + first};
  const Point middle{foot.x, foot.y, foot.z + first + height / 4};
  const Point top{foot.x, foot.y, foot.z + height};
  for (std::size_t i = 0; i < 6; ++i) {
    b.triangle(low, rim(middle, radius, i + 1), rim(middle, radius, i));
    b.triangle(top, rim(middle, radius, i), rim(middle, radius, i + 1));
  }
  // Leaves: upright parallelograms between the rim and the top.
  for (Length i = 0; i < leaves; ++i) {
    const Length z = random.between(first + height / 12, height * 8 / 10);
    // Within the crown, which narrows to the top.
    const Length spread = radius * (height - z) / height;
    const Length x = random.between(-spread, spread);
    const Length y = random.between(-spread, spread);
    const Length dx = random.between(m(0.25), m(0.6));
    const Length dy = random.between(-m(0.5), m(0.5));
    const Length rise = random.between(m(0.3), m(0.7));
    const Point a{foot.x + x, foot.y + y, foot.z + z};
    b.quad(a, {a.x + dx, a.y + dy, a.z}, {a.x + dx, a.y + dy, a.z + rise}, {a.x, a.y, a.z + rise});
  }
}

void add_lamp(Builder& b, const Point& foot) {
  const Frame f{foot, 1, 0};
  b.box(f, {-m(0.14), m(0.14), -m(0.14), m(0.14), 0, m(0.7)}, kOnGround);
  b.box(f, {-m(0.05), m(0.05), -m(0.05), m(0.05), m(0.7), m(3)}, kSides);
  // Lantern: wider at the top, with a pointed roof.
  const auto ring = [&](Length half, Length up, std::size_t i) {
    static constexpr std::array<Direction, 4> kCorner{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    return f.at(kCorner[i % 4].x * half, kCorner[i % 4].y * half, up);
  };
  for (std::size_t i = 0; i < 4; ++i) {
    b.quad(ring(m(0.1), m(3), i), ring(m(0.1), m(3), i + 1), ring(m(0.2), m(3.4), i + 1), ring(m(0.2), m(3.4), i));
    b.triangle(ring(m(0.23), m(3.4), i), ring(m(0.23), m(3.4), i + 1), f.at(0, 0, m(3.65)));
  }
}

void add_bench(Builder& b, const Frame& f) {
  b.box(f, {-m(0.8), m(0.8), -m(0.2), m(0.25), m(0.4), m(0.45)}, kAllFaces);
  b.box(f, {-m(0.8), m(0.8), -m(0.25), -m(0.2), m(0.55), m(0.9)}, kAllFaces);
  b.box(f, {-m(0.75), -m(0.68), -m(0.2), m(0.2), 0, m(0.4)}, kSides);
  b.box(f, {m(0.68), m(0.75), -m(0.2), m(0.2), 0, m(0.4)}, kSides);
}

}  // namespace occlude::render::city
