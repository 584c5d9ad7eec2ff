// SPDX-License-Identifier: MIT
// What all exact answers need of the processor.
#pragma once

#include <stdexcept>
#include <string>

#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// Throws std::runtime_error while the processor does not round to nearest.
inline void require_rounding() {
  if (const auto refusal = kernel::check_rounding(); refusal != kernel::Refusal::none) {
    throw std::runtime_error(std::string(kernel::to_string(refusal)));
  }
}

}  // namespace occlude::culler
