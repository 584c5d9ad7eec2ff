// SPDX-License-Identifier: MIT
// The pictures in a folder that each run replaces.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <string>

#include "occlude/render/image.h"
#include "occlude/render/output_file.h"

namespace occlude::render {

/// The pictures of one kind in a folder. Those of an earlier run are removed, so that nobody takes them for pictures of this
/// run. Files that this program did not make stay.
class PictureSet {
 public:
  using IsSuch = std::function<bool(const std::string& name)>;

  /// `is_such` recognises names of the kind. Throws InputError if a file with such a name cannot be replaced: it is an
  /// input, another output, a folder or read-only.
  PictureSet(std::filesystem::path folder, IsSuch is_such);

  /// Writes a picture under a temporary name; commit() renames all pictures and removes the old ones.
  void add(const std::string& name, const Image& image);
  void commit();

 private:
  std::filesystem::path folder_;
  IsSuch is_such_;
  std::deque<OutputFile> files_;
};

}  // namespace occlude::render
