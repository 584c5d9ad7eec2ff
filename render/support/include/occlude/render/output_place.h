// SPDX-License-Identifier: MIT
// Where the files of a command go. No output replaces an input, and no two outputs are the same file.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace occlude::render {

/// Registers an input: no output may replace this file. It is identified by device and inode, so links and other spellings
/// count too. A missing file is ignored. Throws InputError if standard output goes to this file.
void keep_input(const std::filesystem::path& file);

/// The place of one output, reserved for the lifetime of the object.
class OutputPlace {
 public:
  /// Throws InputError, naming the file, if it is a folder, is read-only, is an input or a standard stream of this
  /// command, or is the place of another output.
  explicit OutputPlace(const std::filesystem::path& file);
  ~OutputPlace();
  OutputPlace(const OutputPlace&) = delete;
  OutputPlace& operator=(const OutputPlace&) = delete;

  /// The place with all links resolved.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Whether it is a device or pipe (/dev/stdout), which is written to and not replaced.
  [[nodiscard]] bool is_device() const { return is_device_; }
  /// The permissions of the existing file, if any.
  [[nodiscard]] std::optional<mode_t> permissions() const { return permissions_; }

 private:
  std::filesystem::path path_;
  bool is_device_ = false;
  std::optional<mode_t> permissions_;
};

/// Throws InputError unless every file in the folder with a matching name can be replaced and no output has such a name.
void require_places(const std::filesystem::path& folder, const std::function<bool(const std::string& name)>& is_such);

}  // namespace occlude::render
