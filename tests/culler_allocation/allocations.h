// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// How often this program has taken memory from the heap so far. The tests that ask are an executable of their own.
[[nodiscard]] std::size_t allocations();
