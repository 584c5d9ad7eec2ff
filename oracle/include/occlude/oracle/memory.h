// SPDX-License-Identifier: MIT
// What happens when the numbers of the oracle find no memory.
#pragma once

namespace occlude::oracle {

/// From now on GMP and MPFR throw std::bad_alloc where they would end the program. This changes the whole process, so that
/// only a program of ours does it, before it asks the oracle. A question that has thrown leaks what it had.
void throw_when_memory_is_out();

}  // namespace occlude::oracle
