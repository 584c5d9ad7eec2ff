// SPDX-License-Identifier: MIT
// Memory and other resources of this process, limited so that no input can exhaust the machine.
#pragma once

#include <sys/resource.h>

#include <cstdint>

namespace occlude::render {

/// The most memory that one process may take, bytes: three quarters of the machine's, so that some is left for others.
[[nodiscard]] std::uint64_t most_memory();

/// Limits this process and its children to most_memory(), or to a lower limit that the user has set (ulimit -v). Beyond it
/// allocation throws std::bad_alloc.
void limit_memory();

/// The present limit of the address space, bytes.
[[nodiscard]] std::uint64_t memory_limit();

/// Throws InputError if a thread gets less than 1 MiB of stack (ulimit -s): the OpenGL library crashes with much less.
void require_stack();

/// Whether `bytes` more can be allocated.
[[nodiscard]] bool can_have_memory(std::uint64_t bytes);

/// Bytes of address space, including what is reserved but not used.
[[nodiscard]] std::uint64_t address_space_in_use();

/// Bytes of it that are private and writable.
[[nodiscard]] std::uint64_t data_in_use();

/// Sets the soft limit, capped at the hard limit.
void limit_resource(int resource, rlim_t value);

}  // namespace occlude::render
