// SPDX-License-Identifier: MIT
// Names for the three answers, for the kernel and for the oracle.
#pragma once

#include <string>

#include "occlude/kernel/types.h"
#include "occlude/oracle/oracle.h"

namespace occlude::fuzz {

[[nodiscard]] inline std::string text(kernel::Relation relation) { return std::string(kernel::to_string(relation)); }

[[nodiscard]] inline kernel::Relation relation_of(oracle::Relation relation) {
  return relation == oracle::Relation::inside    ? kernel::Relation::inside
         : relation == oracle::Relation::partial ? kernel::Relation::partial
                                                 : kernel::Relation::outside;
}

}  // namespace occlude::fuzz
