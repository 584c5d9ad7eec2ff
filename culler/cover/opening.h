// SPDX-License-Identifier: MIT
// Through how many pixels a node is seen.
#pragma once

#include <cstddef>

#include "cover/cover_buffer.h"
#include "cover/cover_descent.h"

namespace occlude::culler {

/// Where a node is in the coarse picture when its block is tested.
struct NodeFootprint {
  CoverBuffer::Footprint own;           ///< of several eyes, in the layer that is focused farther away than the box
  CoverBuffer::Footprint nearer_layer;  ///< of several eyes, in the layer on the other side
  std::size_t groups;                   ///< how many had been drawn by then

  template <class Boxes>
  NodeFootprint(const CoverBuffer& buffer, const TestedBlock<Boxes>& tested, std::size_t i)
      : own(buffer.footprint(tested.seen, i)),
        nearer_layer(buffer.is_of_region() ? buffer.footprint(tested.seen.nearer_layer, i) : own),
        groups(tested.groups) {}
};

/// Where a node is in the coarse picture, and through how many pixels it is seen, as far as that matters.
struct Opening {
  CoverBuffer::Footprint footprint;
  int open;  ///< open pixels, counted up to `enough`. Less means only that there are fewer than that; 0 means none

  /// `groups` is how many have been drawn by now.
  template <class Boxes>
  Opening(const CoverBuffer& buffer, const TestedBlock<Boxes>& tested, std::size_t i, std::size_t groups, int enough)
      : Opening(buffer, {buffer, tested, i}, groups, enough) {}
  Opening(const CoverBuffer& buffer, const NodeFootprint& at, std::size_t groups, int enough) : footprint(at.own) {
    // Nothing was drawn since it was found not to be hidden, so some pixel is open.
    const bool is_too_small = at.groups == groups && footprint.size() < enough;
    open = is_too_small ? 1 : buffer.open(footprint, enough);
    if (!buffer.is_of_region() || open == 0) return;
    const int open_there = buffer.open(at.nearer_layer, enough);
    if (open_there >= open && footprint.is_in_picture) return;
    footprint = at.nearer_layer;
    open = open_there;
  }
  [[nodiscard]] bool is_hidden() const { return open == 0 && footprint.is_in_picture; }
};

}  // namespace occlude::culler
