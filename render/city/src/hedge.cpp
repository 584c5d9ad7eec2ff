// SPDX-License-Identifier: MIT

#include "nature.h"

namespace occlude::render::city {
namespace {

constexpr Length kRoot = m(2.5);  // the faces reach this far down, over dips between their ends

/// The level vector of this length, at right angles to a -> b, to its left.
Point left_of(const Point& a, const Point& b, Length length) {
  const Length dx = b.x - a.x;
  const Length dy = b.y - a.y;
  const Length reach = integer_sqrt(dx * dx + dy * dy);
  return {-dy * length / reach, dx * length / reach, 0};
}

Point plus(const Point& p, const Point& d) { return {p.x + d.x, p.y + d.y, p.z + d.z}; }
Point lifted(const Point& p, Length up) { return {p.x, p.y, p.z + up}; }

/// The point at part / whole of the way from a to b.
Point along(const Point& a, const Point& b, Length part, Length whole) {
  return {a.x + (b.x - a.x) * part / whole, a.y + (b.y - a.y) * part / whole, a.z + (b.z - a.z) * part / whole};
}

}  // namespace

void build_boundary_core(Builder& builder, const Boundary& w) {
  const Point across = left_of(w.a, w.b, w.thickness);
  const Point c = plus(w.a, across);
  const Point d = plus(w.b, across);
  builder.quad(lifted(w.a, -kRoot), lifted(w.b, -kRoot), lifted(w.b, w.height), lifted(w.a, w.height));
  builder.quad(lifted(c, -kRoot), lifted(d, -kRoot), lifted(d, w.height), lifted(c, w.height));
  builder.quad(lifted(w.a, w.height), lifted(w.b, w.height), lifted(d, w.height), lifted(c, w.height));
  builder.quad(lifted(w.a, -kRoot), lifted(c, -kRoot), lifted(c, w.height), lifted(w.a, w.height));
  builder.quad(lifted(w.b, -kRoot), lifted(d, -kRoot), lifted(d, w.height), lifted(w.b, w.height));
}

void build_boundary_details(Builder& builder, const Boundary& w, Random random) {
  const Length reach = integer_sqrt((w.b.x - w.a.x) * (w.b.x - w.a.x) + (w.b.y - w.a.y) * (w.b.y - w.a.y));
  const Point across = left_of(w.a, w.b, w.thickness);
  for (const bool left : {false, true}) {
    // The faces are 4 cm outside the core on either side. Stones lie in them, and leaves stick out from there.
    const Point proud = left ? plus(across, left_of(w.a, w.b, m(0.04))) : left_of(w.b, w.a, m(0.04));
    const Point a = plus(w.a, proud);
    const Point b = plus(w.b, proud);
    if (w.stone) {
      const Length courses = w.height / m(0.28);
      const Length stones = reach / m(0.55);
      for (Length j = 0; j < courses; ++j) {
        for (Length i = 0; i < stones; ++i) {
          const Length end = (2 * i + 1 + (j % 2)) * 8 + random.between(-1, 3);
          const Length start = (2 * i - 1 + (j % 2)) * 8 + random.between(5, 8);
          if (start < 0 || end > 16 * stones) continue;
          const Point p = along(a, b, start, 16 * stones);
          const Point q = along(a, b, end, 16 * stones);
          const Length low = w.height * j / courses + m(0.02);
          const Length high = w.height * (j + 1) / courses - m(0.02);
          builder.quad(lifted(p, low), lifted(q, low), lifted(q, high), lifted(p, high));
        }
      }
      continue;
    }
    const Point outwards = left ? left_of(w.a, w.b, m(0.18)) : left_of(w.b, w.a, m(0.18));
    const Length sprays = reach * 5 / 2 / kUnitsPerMetre;
    for (Length i = 0; i < sprays; ++i) {
      const Point p = along(a, b, random.below(1000), 1024);
      const Point q = along(a, b, 24, 1024);
      const Point step{(q.x - a.x), (q.y - a.y), 0};
      const Length low = random.between(m(0.1), w.height - m(0.4));
      const Length rise = random.between(m(0.2), m(0.45));
      const Point base = lifted(p, low);
      // A leafy twig: two triangles, leaning out.
      const Point tip = plus(lifted(base, rise), outwards);
      builder.triangle(base, plus(base, step), tip);
      builder.triangle(lifted(base, m(0.1)), plus(lifted(base, rise / 2), step), plus(tip, step));
    }
    // More twigs on top.
    for (Length i = 0; i < sprays / 3; ++i) {
      const Point p = lifted(plus(along(a, b, random.below(1000), 1024), left ? outwards : Point{}), w.height - m(0.05));
      const Point q = along(a, b, 20, 1024);
      builder.triangle(p, {p.x + q.x - a.x, p.y + q.y - a.y, p.z}, lifted(p, random.between(m(0.15), m(0.4))));
    }
  }
}

void build_gate(Builder& builder, const Point& a, const Point& b) {
  const auto post = [&](const Point& p) {
    builder.box({p, 1, 0}, {-m(0.1), m(0.1), -m(0.1), m(0.1), -m(0.6), m(1.5)}, kOnGround);
  };
  post(a);
  post(b);
  for (Length i = 0; i < 5; ++i) {
    const Length up = m(0.25) + i * m(0.22);
    builder.quad(lifted(a, up), lifted(b, up), lifted(b, up + m(0.1)), lifted(a, up + m(0.1)));
  }
}

}  // namespace occlude::render::city
