// SPDX-License-Identifier: MIT
// How a box would be found in the last frame of a view. Reading order: 9.
#pragma once

namespace occlude::culler {

enum class Visibility {
  visible,      ///< neither of the other two could be shown
  occluded,     ///< all of it is in the shadow of one occluder, or of a pair of CullResult::pairs, or behind the cover
  out_of_view,  ///< all of it is beyond one half-space of the view
};

}  // namespace occlude::culler
