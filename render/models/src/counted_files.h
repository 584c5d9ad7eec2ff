// SPDX-License-Identifier: MIT
// The files that the child process of an import reads, and its limits, which follow them.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <set>
#include <utility>

#include "occlude/render/child_process.h"

namespace occlude::render {

/// The limits of a child that reads files with so many bytes that are neither zero nor blank.
[[nodiscard]] ChildLimits import_limits_for(std::uint64_t content);

/// Regular files only, because a pipe would keep a reader waiting. Raises the limits of this process with each file, because
/// a model may refer to larger files. A file counts once, and blanks and zeros do not count: else a file without content, or
/// one that refers to another by many names, could ask for any amount.
class CountedFiles {
 public:
  /// Call this before a file is opened. Throws InputError if it cannot be read.
  void count(const std::filesystem::path& file);

 private:
  std::set<std::pair<dev_t, ino_t>> seen_;
  std::uint64_t content_ = 0;
};

}  // namespace occlude::render
