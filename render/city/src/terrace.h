// SPDX-License-Identifier: MIT
// A terrace: houses side by side behind one street wall.
#pragma once

#include <vector>

#include "builder.h"
#include "facade.h"
#include "random.h"

namespace occlude::render::city {

class Route;

/// The details of a house, in order of importance.
enum class HouseLayer {
  openings,   ///< windows and doors as plain rectangles, chimney stacks
  surrounds,  ///< window surrounds, cornice, string course, steps
  glazing,    ///< panes
  back,       ///< windows at the back and in gable ends, gardens
  fittings    ///< railings, chimney pots, dormers, floors inside
};
inline constexpr int kHouseLayers = 5;

struct House {
  enum class Roof { pitched, mansard, butterfly };
  Length along0 = 0, along1 = 0;
  Length eaves = 0;
  Length storeys = 0;
  Length bays = 2;
  Length door_bay = 0;
  Roof roof = Roof::pitched;
  bool stucco_arches = false;
  std::uint64_t seed = 0;
};

struct Terrace {
  Frame frame;  ///< origin at the left end of the street wall, on the ground; `out` to the street
  Length length = 0, depth = 0;
  Length eaves = 0;  ///< of the lowest house: the height of the street wall
  Length ground_storey = 0, storey = 0;
  Length garden = 0;                           ///< depth of the gardens behind
  Length garden_from = 0, garden_to = 0;       ///< the stretch of the terrace that has gardens
  bool open_left = false, open_right = false;  ///< ends not covered by a neighbour
  WindowStyle windows{};
  bool railings = false;
  std::vector<House> houses;
};

/// Plans a terrace: heights, widths of houses, style. `frame`, `length`, `depth`, the ends and gardens are given.
void design_terrace(Terrace& terrace, Random random);

/// The walls and roofs, which small models have too.
void build_shell(Builder& b, const Terrace& terrace);

/// One layer of one house.
void build_house(Builder& b, const Terrace& terrace, const House& house, HouseLayer layer, const Route& route);

}  // namespace occlude::render::city
