// SPDX-License-Identifier: MIT
// Cars and buses that drive along the streets of the town.
#pragma once

#include <vector>

#include "town.h"

namespace occlude::example {

/// Each has an update callback that places it by the simulation time, in seconds, and the data variance DYNAMIC. The first
/// is a bus that drives ahead of who flies along Flight.
[[nodiscard]] std::vector<Thing> make_traffic(int side);

}  // namespace occlude::example
