// SPDX-License-Identifier: MIT
// A folder that files are written to.
#pragma once

#include <filesystem>
#include <vector>

namespace occlude::render {

/// A folder that exists from now on, and so do those it lies in; those that are new go again if nothing has come into them.
class OutputFolder {
 public:
  /// Throws InputError, naming the folder, when it cannot be created.
  explicit OutputFolder(const std::filesystem::path& path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  /// The outmost first.
  std::vector<std::filesystem::path> made_;
};

}  // namespace occlude::render
