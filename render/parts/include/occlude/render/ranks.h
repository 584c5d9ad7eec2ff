// SPDX-License-Identifier: MIT
// The processes that mpirun has started together. The first reads and writes; the others help it, and print nothing.
#pragma once

#include <cstddef>
#include <string>

namespace occlude::render {

/// Whether mpirun has started this process.
[[nodiscard]] bool is_of_mpirun();

/// The number of processes: 1 without mpirun.
[[nodiscard]] std::size_t ranks();

[[nodiscard]] bool is_first_rank();

/// Whether the standard error of mpirun, to which it copies that of the ranks, is a terminal.
[[nodiscard]] bool mpirun_has_terminal();

/// From now on the end of mpirun, or that of another rank before its time, interrupts this process, as Ctrl-C does. Does
/// nothing without mpirun. REQUIRES: interrupts are caught.
void follow_mpirun();

/// Of a helper that cannot go on: the first rank will fail with this message. Does nothing on the first rank.
void tell_first_rank(const std::string& fault);

/// The end of every rank that was not interrupted: helpers wait for the first rank. Throws Interrupted if a helper is while
/// it waits; mpirun then ends the others.
void leave_ranks();

}  // namespace occlude::render
