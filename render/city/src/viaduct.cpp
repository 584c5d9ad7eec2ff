// SPDX-License-Identifier: MIT
#include <array>

#include "buildings.h"

namespace occlude::render::city {
namespace {

constexpr Length kHeight = m(8.5);
constexpr Length kDepth = m(9);
constexpr Length kStretch = m(56);  // between expansion joints
constexpr Length kBay = m(8);

}  // namespace

void build_viaduct_shell(Builder& b, const Frame& f, Length length) {
  const Length stretches = divide_up(length, kStretch);
  for (Length i = 0; i < stretches; ++i) {
    const Length a0 = length * i / stretches;
    const Length a1 = length * (i + 1) / stretches;
    b.facing(f, a0, a1, -m(0.4), kHeight, 0);
    b.facing(f, a0, a1, -m(0.4), kHeight, -kDepth);
    b.level(f, a0, a1, -kDepth, 0, kHeight - m(0.8));
    b.across(f, a0, -kDepth, 0, -m(0.4), kHeight - m(0.8));
  }
  b.across(f, length, -kDepth, 0, -m(0.4), kHeight - m(0.8));
}

void build_viaduct_details(Builder& b, const Frame& f, Length length) {
  const Length bays = length / kBay;
  for (Length i = 0; i < bays; ++i) {
    const Length a0 = length * i / bays;
    const Length left = a0 + m(1.2);
    const Length right = length * (i + 1) / bays;
    const Length middle = (left + right) / 2;
    b.box(f, {a0, left, 0, m(0.5), -m(0.2), kHeight - m(1.2)}, kFront | kLeft | kRight | kTop);
    const Length crown = m(6.4);
    const std::array arch{f.at(left + m(0.4), m(0.05), 0),
                          f.at(right - m(0.4), m(0.05), 0),
                          f.at(right - m(0.4), m(0.05), crown - m(2.4)),
                          f.at(right - m(1.2), m(0.05), crown - m(0.8)),
                          f.at(middle, m(0.05), crown),
                          f.at(left + m(1.2), m(0.05), crown - m(0.8)),
                          f.at(left + m(0.4), m(0.05), crown - m(2.4))};
    b.polygon(arch);
    b.facing(f, middle - m(1.4), middle + m(1.4), 0, m(3), m(0.09));
  }
  b.box(f, {0, length, 0, m(0.3), kHeight - m(1.1), kHeight - m(0.8)}, kFront | kTop | kBottom);
}

}  // namespace occlude::render::city
