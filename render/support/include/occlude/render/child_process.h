// SPDX-License-Identifier: MIT
// Runs work that may crash, hang or use any amount of memory in a child process.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>

namespace occlude::render {

struct ChildLimits {
  std::uint64_t memory_bytes;  ///< address space beyond what is in use, and size of the file that it writes
  std::uint64_t seconds;       ///< processor time
};

/// The child failed. The message says how: "crashes", "exceeds its memory limit".
struct ChildFailure : std::runtime_error {
  ChildFailure(const char* what, bool limit) : runtime_error(what), at_limit(limit) {}
  bool at_limit;  ///< it reached one of its limits
};

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Runs work(file) in a fork of this process and returns the file, rewound, once the child has ended. The child prints
/// nothing, and its changes to memory are lost. The other threads of this process do not exist in it, but their locks stay
/// locked. Throws ChildFailure, std::system_error, Interrupted.
[[nodiscard]] File run_in_child(const ChildLimits& limits, const std::function<void(std::FILE*)>& work);

/// Called by the work: changes the limits of the child.
void change_limits(const ChildLimits& limits);

}  // namespace occlude::render
