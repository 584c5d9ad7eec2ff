// SPDX-License-Identifier: MIT
// What the system lets this process have.
#pragma once

#include <sys/resource.h>

#include <cstdint>

namespace occlude::render {

/// Bytes. More than what is used of it: it counts what is set aside.
[[nodiscard]] std::uint64_t address_space_in_use();

/// Bytes of that which can be written to and is this process's own.
[[nodiscard]] std::uint64_t data_in_use();

/// Whether there are so many bytes more to be had.
[[nodiscard]] bool can_have_memory(std::uint64_t bytes);

/// Sets the limit that can be changed again, no higher than the one that cannot.
void limit_resource(int resource, rlim_t value);

}  // namespace occlude::render
