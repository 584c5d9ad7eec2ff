// SPDX-License-Identifier: MIT
#include "terrain.h"

#include <algorithm>

#include "random.h"

namespace occlude::render::city {
namespace {

/// Value noise: random heights from 0 to `amplitude` on a lattice of `spacing`, joined smoothly.
Length noise(std::uint64_t seed, Length x, Length y, Length spacing, Length amplitude) {
  constexpr Length kBias = Length{1} << 40;  // moves all coordinates to the positive side, where / rounds down
  const Length column = (x + kBias) / spacing;
  const Length row = (y + kBias) / spacing;
  const auto lattice = [&](Length i, Length j) {
    return Random(seed, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j)).below(1024);
  };
  // 3 t^2 - 2 t^3 in units of 1/1024.
  const auto ease = [](Length t) { return t * t * (3 * 1024 - 2 * t) / (1024 * 1024); };
  const Length u = ease(((x + kBias) % spacing) * 1024 / spacing);
  const Length v = ease(((y + kBias) % spacing) * 1024 / spacing);
  const Length south = lattice(column, row) * (1024 - u) + lattice(column + 1, row) * u;
  const Length north = lattice(column, row + 1) * (1024 - u) + lattice(column + 1, row + 1) * u;
  return (south * (1024 - v) + north * v) / 1024 * amplitude / (1024 * 1024);
}

}  // namespace

Terrain::Terrain(std::uint64_t seed, const Rect& extent, Length cell)
    : extent_(extent),
      cell_(cell),
      columns_(std::max<Length>(1, extent.width() / cell)),
      rows_(std::max<Length>(1, extent.depth() / cell)) {
  extent_.x1 = extent_.x0 + columns_ * cell_;
  extent_.y1 = extent_.y0 + rows_ * cell_;
  for (Length j = 0; j <= rows_; ++j) {
    for (Length i = 0; i <= columns_; ++i) {
      const Length wide = noise(seed + 101, x(i), y(j), m(130), m(30));
      const Length fine = noise(seed + 102, x(i), y(j), m(45), m(2));
      const Length ramp = std::min<Length>(1024, (x(i) - extent_.x0) * 1024 / m(90));
      heights_.push_back((wide + fine) * ramp / 1024);
    }
  }
}

Length Terrain::height(Length px, Length py) const {
  if (px < extent_.x0 || px > extent_.x1 || py < extent_.y0 || py > extent_.y1) return 0;
  const Length i = std::min(columns_ - 1, (px - extent_.x0) / cell_);
  const Length j = std::min(rows_ - 1, (py - extent_.y0) / cell_);
  const Length u = px - x(i);
  const Length v = py - y(j);
  const Length a = node(i, j);
  const Length c = node(i + 1, j + 1);
  // Each cell is cut along its diagonal from south-west to north-east.
  const Length b = u >= v ? node(i + 1, j) : node(i, j + 1);
  const Length rise = u >= v ? (b - a) * u + (c - b) * v : (b - a) * v + (c - b) * u;
  return a + (rise >= 0 ? rise / cell_ : -((-rise) / cell_));
}

}  // namespace occlude::render::city
