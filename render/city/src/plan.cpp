// SPDX-License-Identifier: MIT
#include "plan.h"

#include <array>
#include <span>

namespace occlude::render::city {
namespace {

constexpr Length kAvenue = m(12);      // carriageways: between columns,
constexpr Length kCrossStreet = m(8);  // between rows,
constexpr Length kSideStreet = m(7);   // inside a row
constexpr Length kColumnWidth = m(176);
constexpr Length kHalfColumn = m(84);  // one block wide

/// Cuts one column into rows of two blocks, or one if the column is too narrow. `cuts` are the middles of its cross streets,
/// from south to north; the side street of row i lies `shift` (alternating) off the middle of the column.
void add_column(LondonPlan& plan, const Rect& column, std::span<const Length> cuts, Length shift) {
  Length south = column.y0;
  const Length middle = (column.x0 + column.x1) / 2;
  for (std::size_t row = 0; row <= cuts.size(); ++row) {
    const bool last = row == cuts.size();
    const Length north = last ? column.y1 : cuts[row] - kCrossStreet / 2;
    const Length side = middle + (row % 2 == 0 ? shift : -shift);
    if (column.width() <= kHalfColumn) {
      plan.blocks.push_back({{column.x0, south, column.x1, north}});
    } else {
      plan.blocks.push_back({{column.x0, south, side - kSideStreet / 2, north}});
      plan.blocks.push_back({{side + kSideStreet / 2, south, column.x1, north}});
      plan.carriageways.push_back({side - kSideStreet / 2, south, side + kSideStreet / 2, north});
    }
    if (last) break;
    south = north + kCrossStreet;
    plan.carriageways.push_back({column.x0, north, column.x1, south});
  }
}

}  // namespace

LondonPlan plan_london(Length extra_columns, Length extra_rows) {
  LondonPlan plan;
  const Rect all = kLondon;
  // The cross streets of neighbouring columns are offset, so that none continues beyond an avenue.
  constexpr std::array<Length, 3> kFarWest{m(-80), m(30), m(140)};
  constexpr std::array<Length, 3> kWest{m(-110), m(0), m(110)};
  constexpr std::array<Length, 4> kMiddle{m(-165), m(-55), m(55), m(165)};
  constexpr std::array<Length, 3> kEast{m(-130), m(-20), m(90)};
  constexpr Length kStep = kColumnWidth + kAvenue;
  constexpr Length kFirst = kHalfColumn + kAvenue;
  add_column(plan, {all.x0, all.y0, all.x0 + kHalfColumn, all.y1}, kFarWest, 0);
  add_column(plan, {all.x0 + kFirst, all.y0, all.x0 + kFirst + kColumnWidth, all.y1}, kWest, m(9));
  add_column(plan, {all.x0 + kFirst + kStep, all.y0, all.x0 + kFirst + kStep + kColumnWidth, all.y1}, kMiddle, m(6));
  add_column(plan, {all.x0 + kFirst + 2 * kStep, all.y0, all.x1, all.y1}, kEast, m(8));
  for (Length i = 0; i < 3; ++i) {
    const Length east = all.x0 + kFirst + i * kStep;
    plan.carriageways.push_back({east - kAvenue, all.y0, east, all.y1});
  }
  // A ring road and the quay close the core.
  plan.carriageways.push_back({all.x0 - kRingRoad, all.y0 - kRingRoad, all.x0, all.y1 + kRingRoad});
  plan.carriageways.push_back({all.x0, all.y1, kQuayEast, all.y1 + kRingRoad});
  plan.carriageways.push_back({all.x0, all.y0 - kRingRoad, kQuayEast, all.y0});
  plan.carriageways.push_back({all.x1, all.y0, kQuayEast, all.y1});

  // Garden squares and churchyards take the place of some blocks. The columns have 4, 8, 10 and 8 blocks.
  plan.blocks[12 + 2 * 3].use = BlockUse::garden_square;  // in the middle column, on the camera's route
  plan.blocks[4 + 2 * 3].use = BlockUse::garden_square;
  plan.blocks[4 + 2 * 1 + 1].use = BlockUse::church;
  plan.blocks[22 + 1].use = BlockUse::church;
  plan.core_blocks = plan.blocks.size();
  plan.core_carriageways = plan.carriageways.size();

  // The suburbs repeat the pattern to the west. Rows are 100 m.
  constexpr Length kRow = m(100);
  Length east = all.x0 - kRingRoad;
  for (Length c = 0; c < extra_columns; ++c) {
    const Rect column{east - kColumnWidth, -kRow * extra_rows / 2, east, kRow * extra_rows / 2};
    std::vector<Length> cuts;
    for (Length r = 1; r < extra_rows; ++r) cuts.push_back(column.y0 + kRow * r + (c % 2 == 0 ? m(22) : m(-20)));
    const std::size_t before = plan.blocks.size();
    add_column(plan, column, cuts, m(5 + 3 * static_cast<double>(c % 2)));
    for (std::size_t i = before + 4; i < plan.blocks.size(); i += 13) {
      plan.blocks[i].use = (i % 2 == 0) ? BlockUse::garden_square : BlockUse::church;
    }
    plan.carriageways.push_back({column.x0 - kAvenue, column.y0, column.x0, column.y1});
    east = column.x0 - kAvenue;
  }
  return plan;
}

}  // namespace occlude::render::city
