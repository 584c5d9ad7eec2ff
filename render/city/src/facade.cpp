// SPDX-License-Identifier: MIT
#include "facade.h"

namespace occlude::render::city {

void add_window(Builder& b, const Frame& f, Length along, Length up, const WindowStyle& style, WindowPart part) {
  const Length right = along + style.width;
  const Length top = up + style.height;
  constexpr Length kJamb = m(0.14);
  switch (part) {
    case WindowPart::blind:
      b.facing(f, along, right, up, top, kBlindOut);
      break;
    case WindowPart::surround: {
      // Reveals face into the opening; the lower ends of the jambs stand on the sill.
      b.box(f, {along - kJamb, along, 0, kSurroundOut, up, top}, kFront | kLeft | kRight);
      b.box(f, {right, right + kJamb, 0, kSurroundOut, up, top}, kFront | kLeft | kRight);
      b.box(f, {along - kJamb, right + kJamb, 0, kSurroundOut, top, top + m(0.2)}, kFront | kTop | kBottom);
      b.box(f, {along - m(0.2), right + m(0.2), 0, kSillOut, up - m(0.12), up}, kFront | kTop | kBottom);
      if (style.arched_head) {
        const Length base = top + m(0.2);
        b.triangle(f.at(along - kJamb, kSurroundOut, base), f.at(right + kJamb, kSurroundOut, base),
                   f.at((along + right) / 2, kSurroundOut, base + m(0.3)));
      }
      break;
    }
    case WindowPart::panes: {
      constexpr Length kBar = m(0.035);
      for (Length j = 0; j < style.pane_rows; ++j) {
        for (Length i = 0; i < style.pane_columns; ++i) {
          b.facing(f, along + style.width * i / style.pane_columns + kBar,
                   along + style.width * (i + 1) / style.pane_columns - kBar, up + style.height * j / style.pane_rows + kBar,
                   up + style.height * (j + 1) / style.pane_rows - kBar, kPaneOut);
        }
      }
      break;
    }
  }
}

void add_door(Builder& b, const Frame& f, Length along, Length up, bool with_detail) {
  const Length right = along + kDoorWidth;
  if (!with_detail) {
    b.facing(f, along, right, up, up + kDoorHeight, kBlindOut);
    b.facing(f, along, right, up + kDoorHeight + m(0.06), up + kDoorHeight + m(0.5), kBlindOut);  // fanlight
    return;
  }
  // Pilasters and a hood on them.
  b.box(f, {along - m(0.25), along, 0, kSurroundOut, up, up + kDoorHeight + m(0.55)}, kFront | kLeft | kRight);
  b.box(f, {right, right + m(0.25), 0, kSurroundOut, up, up + kDoorHeight + m(0.55)}, kFront | kLeft | kRight);
  b.box(f, {along - m(0.35), right + m(0.35), 0, m(0.45), up + kDoorHeight + m(0.55), up + kDoorHeight + m(0.75)}, kOnWall);
  // Panels, a letter box.
  for (Length i = 0; i < 2; ++i) {
    const Length left = along + m(0.12) + i * m(0.44);
    b.facing(f, left, left + m(0.36), up + m(0.2), up + m(0.85), kPaneOut);
    b.facing(f, left, left + m(0.36), up + m(1.15), up + m(2.05), kPaneOut);
  }
  b.facing(f, along + m(0.38), right - m(0.38), up + m(0.95), up + m(1.05), kPaneOut);
}

}  // namespace occlude::render::city
