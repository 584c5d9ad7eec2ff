// SPDX-License-Identifier: MIT
// Faults of the numbers of a witness for a region of eyes. Each function returns the fault in one line, or an empty string.
#pragma once

#include <string>

#include "occlude/oracle/region.h"

namespace occlude::oracle {

[[nodiscard]] std::string fault_of(const EyeRegion& eyes);

[[nodiscard]] std::string fault_of(const RegionWitness& witness);

}  // namespace occlude::oracle
