// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Gives the prover the witness lines of a forger who may write anything in the file. The scenes are small. The cameras have
/// all angles, shapes, near and far planes and both projections. Planes cut off little or much of the view, overflow or
/// vanish. Boxes, occluders, near planes, ranges, frames, parts and margins are true or false. A case is a line: `inside`
/// means that the prover accepts it, `outside` that it does not. By exact visibility, nothing that an accepted line culls
/// may show.
void run_forgeries(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
