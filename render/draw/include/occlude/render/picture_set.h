// SPDX-License-Identifier: MIT
// Pictures of a folder of which each run makes others.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <string>

#include "occlude/render/image.h"
#include "occlude/render/output_file.h"

namespace occlude::render {

/// The pictures of one kind in a folder. Those of this run take the place of those of an earlier one, which would be taken
/// for its own; what the program did not make stays.
class PictureSet {
 public:
  using IsSuch = std::function<bool(const std::string& name)>;

  /// `is_such` knows the names of the kind. Throws InputError where a file of such a name cannot be replaced: it is read by
  /// this command, it is another output, a folder or read-only.
  PictureSet(std::filesystem::path folder, IsSuch is_such);

  /// The picture is whole, and has its name once all are there.
  void add(const std::string& name, const Image& image);
  void commit();

 private:
  std::filesystem::path folder_;
  IsSuch is_such_;
  std::deque<OutputFile> files_;
};

}  // namespace occlude::render
