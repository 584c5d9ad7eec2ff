// SPDX-License-Identifier: MIT
#include "rays.h"

#include <cmath>

namespace occlude::oracle {

Rays::Rays(const Viewpoint& view) : w_{-view.value[0], -view.value[1], -view.value[2], -1} {
  if (!view.at_infinity) return;
  w_ = {view.value[0], view.value[1], view.value[2], 0};
  dropped_ = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::fabs(w_[i]) > std::fabs(w_[dropped_])) dropped_ = i;
  }
  scale_ = std::fabs(w_[dropped_]);
  towards_ = w_[dropped_] > 0 ? 1 : -1;
}

}  // namespace occlude::oracle
