// SPDX-License-Identifier: MIT
// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "occlude/render/output_place.h"

namespace occlude::render {

/// A file written under a temporary name beside its own and renamed by commit(); without commit() it vanishes. A link stays
/// one, to the new file. A device or pipe (/dev/stdout) is written directly.
/// Throws InputError, naming the file, when it cannot be created or written, Interrupted when it waits and the user wishes
/// to stop.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// As the user calls it.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void write(std::string_view text);
  /// All that was written is in the file from here on. Who writes several files closes all of them before the first
  /// commit().
  void close();
  /// Closes the file and gives it its own name.
  void commit();

 private:
  void flush();
  void send(std::string_view text) const;
  [[noreturn]] void fail(const char* what, int error) const;

  std::filesystem::path path_;
  OutputPlace place_;
  std::filesystem::path temporary_;  ///< empty for a device, and once there is no such file any more
  int descriptor_ = -1;
  std::string buffer_;
};

}  // namespace occlude::render
