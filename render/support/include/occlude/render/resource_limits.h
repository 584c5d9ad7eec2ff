// SPDX-License-Identifier: MIT
// What the system lets this process have, so that no input takes the machine down.
#pragma once

#include <sys/resource.h>

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

/// Whether there are so many bytes more to be had.
[[nodiscard]] bool can_have_memory(std::uint64_t bytes);

/// Bytes. More than what is used of it: it counts what is set aside.
[[nodiscard]] std::uint64_t address_space_in_use();

/// Bytes of that which can be written to and is this process's own.
[[nodiscard]] std::uint64_t data_in_use();

/// Sets the limit that can be changed again, no higher than the one that cannot.
void limit_resource(int resource, rlim_t value);

}  // namespace occlude::render
