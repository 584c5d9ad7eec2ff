// SPDX-License-Identifier: MIT
// A folder for output files.
#pragma once

#include <filesystem>
#include <vector>

#include "occlude/render/interrupt.h"

namespace occlude::render {

/// Creates the folder and its parents. The destructor removes those that it created and that are still empty.
class OutputFolder {
 public:
  /// Throws InputError, naming the folder, when it cannot be created.
  explicit OutputFolder(const std::filesystem::path& path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

 private:
  void remove_empty();

  /// The folders created, the outermost first.
  std::vector<Leftover> made_;
};

}  // namespace occlude::render
