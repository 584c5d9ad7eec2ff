// SPDX-License-Identifier: MIT
// Windows and doors. They are in front of the wall, which stays one uncut rectangle.
#pragma once

#include "builder.h"

namespace occlude::render::city {

/// The parts of a window, from the plainest on; a small model leaves the later ones out.
enum class WindowPart {
  blind,     ///< one rectangle, the sash frames and what hangs behind them
  surround,  ///< jambs, head and sill
  panes      ///< the single panes of glass
};

/// How the windows of a house look.
struct WindowStyle {
  Length width, height;
  Length pane_columns, pane_rows;
  bool arched_head;  ///< a triangular pediment over the head
};

/// One part of the window with its lower left corner at (along, up) of the wall `f`.
void add_window(Builder& b, const Frame& f, Length along, Length up, const WindowStyle& style, WindowPart part);

/// A front door with its frame and fanlight. Its threshold is at `up`.
void add_door(Builder& b, const Frame& f, Length along, Length up, bool with_detail);

/// Distances of the layers from the wall; they are at least 3 cm apart, so that none flickers.
inline constexpr Length kBlindOut = m(0.04);
inline constexpr Length kPaneOut = m(0.075);
inline constexpr Length kSurroundOut = m(0.13);
inline constexpr Length kSillOut = m(0.18);

inline constexpr Length kDoorWidth = m(1.05);
inline constexpr Length kDoorHeight = m(2.2);

}  // namespace occlude::render::city
