// SPDX-License-Identifier: MIT
// The plan of the world: where the streets, the lake, the precinct and the hills lie.
#pragma once

#include <cstddef>
#include <vector>

#include "units.h"

namespace occlude::render::city {

// From west to east: London, its quay, the lake with the island of the precinct, the hills.
inline constexpr Rect kLondon{m(-682), m(-220), m(-34), m(220)};
inline constexpr Length kRingRoad = m(12);  ///< round London, beyond it a viaduct to the north and south
inline constexpr Length kQuayEast = m(-18);
inline constexpr Rect kIsland{m(56), m(-160), m(364), m(160)};
inline constexpr Rect kPrecinct{m(90), m(-120), m(330), m(120)};  ///< inner side of the precinct wall
inline constexpr Rect kTemplo{m(212), m(-38), m(284), m(38)};     ///< foot of the great pyramid
inline constexpr Rect kHills{m(400), m(-252), m(856), m(252)};
inline constexpr Length kLakeLevel = m(-0.9);
inline constexpr Length kGateHalfWidth = m(3.4);  ///< gates of the precinct, at y = 0
inline constexpr Length kCausewayHalfWidth = m(5);

/// Face-to-face widths are the carriageway plus two pavements: 13 to 18 m.
inline constexpr Length kPavement = m(2.9);
inline constexpr Length kPavementLevel = m(0.12);
inline constexpr Length kTerraceDepth = m(10);

enum class BlockUse { terraces, garden_square, church };

struct Block {
  Rect land;  ///< up to the kerb, pavement included
  BlockUse use = BlockUse::terraces;
};

struct LondonPlan {
  std::vector<Block> blocks;
  std::vector<Rect> carriageways;
  std::size_t core_blocks = 0;  ///< the first ones, which every model has
  std::size_t core_carriageways = 0;
};

/// The streets. Columns of blocks, divided by avenues, are cut into rows at places that differ from one column to the next,
/// and each row by a short street of its own, so that nearly every street ends at a house front. Beyond the core there are
/// `extra_columns` more to the west, `extra_rows` rows long.
[[nodiscard]] LondonPlan plan_london(Length extra_columns, Length extra_rows);

}  // namespace occlude::render::city
