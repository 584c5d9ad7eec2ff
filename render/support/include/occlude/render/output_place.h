// SPDX-License-Identifier: MIT
// Where files of a command go. What it reads is not replaced, and no two of its files become one.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace occlude::render {

/// From now on no output may replace this file. It is known by device and inode: through links and other spellings as well.
/// A file that is not there need not be kept. Throws InputError for the one that standard output goes to.
void keep_input(const std::filesystem::path& file);

/// The place that an output is written to, its own as long as this lives.
class OutputPlace {
 public:
  /// Throws InputError, naming the file, for a folder, for a file that is read-only, is read by this command or is
  /// one of its standard streams, and for the place of another output.
  explicit OutputPlace(const std::filesystem::path& file);
  ~OutputPlace();
  OutputPlace(const OutputPlace&) = delete;
  OutputPlace& operator=(const OutputPlace&) = delete;

  /// Beyond all links.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// A device or pipe (/dev/stdout), which takes bytes and cannot be replaced.
  [[nodiscard]] bool is_device() const { return is_device_; }
  /// Of the file that is there.
  [[nodiscard]] std::optional<mode_t> permissions() const { return permissions_; }

 private:
  std::filesystem::path path_;
  bool is_device_ = false;
  std::optional<mode_t> permissions_;
};

/// Throws InputError unless every file of such a name in the folder can be replaced, and no output is to get such a name.
void require_places(const std::filesystem::path& folder, const std::function<bool(const std::string& name)>& is_such);

}  // namespace occlude::render
