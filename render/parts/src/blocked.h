// SPDX-License-Identifier: MIT
// Waiting that no check_interrupt() ends.
#pragma once

namespace occlude::render {

/// While one lives, a rank waits for others inside of MPI: an interrupt ends it at once, and not only after the second that
/// commands have to stop by themselves. mpirun hears of that end, and the others wait for nobody.
class Blocked {
 public:
  Blocked();
  ~Blocked();
  Blocked(const Blocked&) = delete;
  Blocked& operator=(const Blocked&) = delete;
};

}  // namespace occlude::render
