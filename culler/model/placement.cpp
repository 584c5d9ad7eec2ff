// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "occlude/culler/box.h"

namespace occlude::culler {

void Placement::require_affine(double x, double y, double z, double w) {
  // Not so if a number is NaN.
  if (!(x == 0 && y == 0 && z == 0 && w == 1)) {
    throw std::invalid_argument("the matrix of a placement is not affine: its last row must be (0, 0, 0, 1)");
  }
}

}  // namespace occlude::culler
