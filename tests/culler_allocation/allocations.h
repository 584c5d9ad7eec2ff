// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// How many times this program has allocated memory from the heap so far. The tests that use it are a separate executable.
[[nodiscard]] std::size_t allocations();
