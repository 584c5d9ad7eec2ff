// SPDX-License-Identifier: MIT
// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace occlude::render {

/// A file written under a temporary name beside its own and renamed by commit(); without commit() it vanishes. A device or
/// pipe (/dev/stdout) is written directly.
/// Throws InputError, naming the file, when it cannot be created or written.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] std::ostream& stream() { return stream_; }
  void write(std::string_view text) { stream_.write(text.data(), static_cast<std::streamsize>(text.size())); }
  /// Flushes, checks for write errors and gives the file its own name.
  void commit();

 private:
  std::filesystem::path path_, temporary_;
  std::ofstream stream_;
  bool committed_ = false;
};

}  // namespace occlude::render
