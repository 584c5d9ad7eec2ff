// SPDX-License-Identifier: MIT
// Work that may crash, hang or ask for any amount of memory, done where that harms nobody.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>

namespace occlude::render {

struct ChildLimits {
  std::uint64_t memory_bytes;  ///< address space on top of what the process has already, and of the file that it writes
  std::uint64_t seconds;       ///< of processor time
};

/// The child did not end as it should. The message says how: "crashes", "needs more memory than it may have".
struct ChildFailure : std::runtime_error {
  ChildFailure(const char* what, bool limit) : runtime_error(what), at_limit(limit) {}
  bool at_limit;  ///< it came to one of its limits
};

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Runs work(file) in a copy of this process and returns the file, rewound, once the copy has ended. The copy prints
/// nothing, and whatever it changes in memory is lost; the threads of this process are not in it, nor what they hold locked.
/// Throws ChildFailure, std::system_error, Interrupted.
[[nodiscard]] File run_in_child(const ChildLimits& limits, const std::function<void(std::FILE*)>& work);

/// For such work: it has these limits from now on.
void change_limits(const ChildLimits& limits);

}  // namespace occlude::render
