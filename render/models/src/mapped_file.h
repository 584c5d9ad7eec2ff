// SPDX-License-Identifier: MIT
// Files that are read where the system keeps them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace occlude::render {

/// The bytes of a file, for reading, as long as the object exists. A file that is replaced under its name stays what it was.
/// One that is made shorter in place ends the program when its bytes are read (SIGBUS).
class MappedFile {
 public:
  /// Throws InputError, naming the file, unless it is a regular file that can be read.
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }
  /// Makes a range of the bytes readable without a fault for each page. Only speed depends on it.
  static void populate(std::span<const std::byte> range);

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace occlude::render
