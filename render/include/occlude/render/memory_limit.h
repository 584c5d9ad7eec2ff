// SPDX-License-Identifier: MIT
// No input takes the machine down.
#pragma once

#include <cstdint>

namespace occlude::render {

/// What one process takes at most, bytes: three quarters of the machine's memory, so that there is some left for others.
[[nodiscard]] std::uint64_t most_memory();

/// From now on this process, and what it starts, has no more than that, or less where the user says so (ulimit -v). What
/// would need more fails as std::bad_alloc.
void limit_memory();

/// What it has, bytes of address space.
[[nodiscard]] std::uint64_t memory_limit();

/// Throws InputError where a thread gets less than a MiB of stack (ulimit -s): the OpenGL library crashes with much less.
void require_stack();

}  // namespace occlude::render
