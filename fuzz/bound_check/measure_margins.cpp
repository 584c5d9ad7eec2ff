// SPDX-License-Identifier: MIT
#include "measure_culler.h"
namespace occlude::bound_check {
std::vector<Measured> measure_margins(int, std::uint64_t) { return {}; }
}
