// SPDX-License-Identifier: MIT
#include <array>

#include "buildings.h"

namespace occlude::render::city {
namespace {

constexpr Length kBatter = m(0.8);  // how far a tier's wall leans back
constexpr Length kLedge = m(1.9);
constexpr Length kSetback = kBatter + kLedge;
constexpr Length kProud = m(2.5);  // the stairs stand this far in front of the slope through the edges of the tiers
constexpr Length kBalustrade = m(0.9);

/// Where the stairs end, at the edge of the topmost level.
Length stairs_head(const Pyramid& p) { return -(p.tiers * kSetback - kLedge); }

Length flight_width(const Pyramid& p) { return p.width * 2 / (5 * p.flights); }

Length flight_middle(const Pyramid& p, Length i) { return p.flights == 1 ? 0 : (2 * i - 1) * p.width / 5; }

void temple(Builder& b, const Pyramid& p, Length middle) {
  const Length top = p.tiers * p.tier_height;
  const Length half = flight_width(p) * 2 / 5;
  const Length front = stairs_head(p) - m(3);
  const Length depth = half * 3 / 2;
  const Frame f = p.frame.moved(middle, front, top);
  const Length wall = half * 4 / 5 + m(1);
  b.box(f, {-half, half, -depth, 0, -m(0.2), wall}, kSides);
  b.facing(f, -half / 3, half / 3, 0, wall * 3 / 4, m(0.05));
  b.box(f, {-half - m(0.3), half + m(0.3), -depth - m(0.3), m(0.3), wall, wall + m(0.5)}, kAllFaces);
  // The high hipped roof: four trapezoids and a lid.
  const Length low = wall + m(0.5);
  const Length high = low + half;
  const Length in = half / 4;
  const std::array foot{f.at(-half, 0, low), f.at(half, 0, low), f.at(half, -depth, low), f.at(-half, -depth, low)};
  const std::array head{f.at(in - half, -in, high), f.at(half - in, -in, high), f.at(half - in, in - depth, high),
                        f.at(in - half, in - depth, high)};
  for (std::size_t i = 0; i < 4; ++i) b.quad(foot[i], foot[(i + 1) % 4], head[(i + 1) % 4], head[i]);
  b.polygon(head);
}

}  // namespace

void build_pyramid_shell(Builder& b, const Pyramid& p) {
  const auto ring = [&](Length inset, Length up) {
    const Length half = p.width / 2 - inset;
    return std::array{p.frame.at(-half, -inset, up), p.frame.at(half, -inset, up), p.frame.at(half, inset - p.depth, up),
                      p.frame.at(-half, inset - p.depth, up)};
  };
  for (Length tier = 0; tier < p.tiers; ++tier) {
    const auto foot = ring(tier * kSetback, tier * p.tier_height - (tier == 0 ? m(0.3) : 0));
    const auto edge = ring(tier * kSetback + kBatter, (tier + 1) * p.tier_height);
    const auto next = ring((tier + 1) * kSetback, (tier + 1) * p.tier_height);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      b.quad(foot[i], foot[j], edge[j], edge[i]);
      b.quad(edge[i], edge[j], next[j], next[i]);
    }
  }
  // The uppermost floor is paved: as one polygon it would look like a good occluder but hide only sky.
  const Length inset = p.tiers * kSetback;
  const Length half = p.width / 2 - inset;
  const Length floor = p.depth - 2 * inset;
  const Length columns = divide_up(2 * half, m(4));
  const Length rows = divide_up(floor, m(4));
  for (Length j = 0; j < rows; ++j) {
    for (Length i = 0; i < columns; ++i) {
      b.level(p.frame, -half + 2 * half * i / columns, -half + 2 * half * (i + 1) / columns, -inset - floor * (j + 1) / rows,
              -inset - floor * j / rows, p.tiers * p.tier_height);
    }
  }
  for (Length i = 0; i < p.flights; ++i) temple(b, p, flight_middle(p, i));
}

void build_stairs(Builder& b, const Pyramid& p, Length stones) {
  const Length rise = p.tiers * p.tier_height;
  const Length head = stairs_head(p);
  const Length run = p.tiers * kSetback + kProud;
  const Length foot = head + run;
  const Length steps = rise / m(0.3);
  for (Length flight = 0; flight < p.flights; ++flight) {
    const Frame f = p.frame.moved(flight_middle(p, flight), 0, 0);
    const Length half = flight_width(p) / 2;
    for (Length k = 0; k < steps; ++k) {
      const Length out0 = foot - run * k / steps;
      const Length out1 = foot - run * (k + 1) / steps;
      const Length up0 = rise * k / steps;
      const Length up1 = rise * (k + 1) / steps;
      for (Length s = 0; s < stones; ++s) {
        const Length a0 = -half + 2 * half * s / stones;
        const Length a1 = -half + 2 * half * (s + 1) / stones;
        b.facing(f, a0, a1, up0, up1, out0);
        b.level(f, a0, a1, out1, out0, up1);
      }
    }
    for (const Length side : {-half - kBalustrade, half}) {
      const Length a0 = side;
      const Length a1 = side + kBalustrade;
      const Length lip = m(0.6);
      for (const Length along : {a0, a1}) {
        b.quad(f.at(along, foot + kBalustrade, 0), f.at(along, foot + kBalustrade, lip), f.at(along, head, rise + lip),
               f.at(along, head, 0));
      }
      b.quad(f.at(a0, foot + kBalustrade, lip), f.at(a1, foot + kBalustrade, lip), f.at(a1, head, rise + lip),
             f.at(a0, head, rise + lip));
      b.facing(f, a0, a1, 0, lip, foot + kBalustrade);
      b.facing(f, a0, a1, rise, rise + lip, head);
    }
  }
}

}  // namespace occlude::render::city
