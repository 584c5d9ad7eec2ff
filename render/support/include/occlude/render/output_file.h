// SPDX-License-Identifier: MIT
// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "occlude/render/interrupt.h"
#include "occlude/render/output_place.h"

namespace occlude::render {

/// A file that is written without a name, or under a temporary one where the file system has only files with names. close()
/// gives it a temporary name in the same folder, and commit() the final one. Without commit() it is removed.
/// A symbolic link stays a link, to the new file. A device or pipe (/dev/stdout) is written directly.
/// Throws InputError, naming the file, when it cannot be created or written, and Interrupted when Ctrl-C ends a write that
/// waits.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The path as the user gave it.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void write(std::string_view text);
  /// Writes what is still buffered and closes the file. A command with several files closes all of them before the first
  /// commit().
  void close();
  /// Closes the file and renames it to its final name.
  void commit();

 private:
  void open_named();
  void give_name();
  /// Gives the file an unused name in the folder by make(name), which returns false and sets errno if it cannot. The name is
  /// short: that of the output may have the longest length.
  void make_temporary(const std::function<bool(const char* name)>& make);
  void flush();
  void send(std::string_view text) const;
  [[noreturn]] void fail(const char* what, int error) const;

  std::filesystem::path path_;
  OutputPlace place_;
  std::optional<Leftover> temporary_;  ///< none while it has no name, for a device, and after commit()
  int descriptor_ = -1;
  std::string buffer_;
};

}  // namespace occlude::render
