// SPDX-License-Identifier: MIT
// A folder that files are written to.
#pragma once

#include <filesystem>

namespace occlude::render {

/// A folder that exists from now on; if it is new and nothing has come into it, it goes again.
class OutputFolder {
 public:
  /// Throws InputError, naming the folder, when it cannot be created.
  explicit OutputFolder(std::filesystem::path path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  std::filesystem::path path_;
  bool is_new_ = false;
};

}  // namespace occlude::render
