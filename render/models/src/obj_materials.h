// SPDX-License-Identifier: MIT
// The materials of an OBJ file: which let light through, and their colours.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "model_builder.h"

namespace occlude::render::obj {

class Materials {
 public:
  /// REQUIRES: the name of the OBJ file outlives the object.
  explicit Materials(const std::filesystem::path& file) : file_(file) {}

  /// Reads the material files of a statement `mtllib`: one name, which may have blanks, or several. One that cannot be read
  /// is a warning.
  void read(std::string_view names);
  /// The material of a statement `usemtl`. It is not opaque where its dissolve (d) is below 1, its transparency (Tr) above
  /// 0, or it has a picture of either. Its colour is Kd. One that is not described is opaque and white.
  [[nodiscard]] Surface surface(std::string_view name) const;

  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void read_file(const std::filesystem::path& file);

  const std::filesystem::path& file_;
  std::map<std::string, Surface, std::less<>> surfaces_;
  std::set<std::string, std::less<>> read_;  ///< names of files
  std::vector<std::string> warnings_;
};

}  // namespace occlude::render::obj
