// SPDX-License-Identifier: MIT
// Which materials of an OBJ file let light through.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace occlude::render::obj {

class Materials {
 public:
  /// REQUIRES: the name of the OBJ file outlives the object.
  explicit Materials(const std::filesystem::path& file) : file_(file) {}

  /// Reads the material files of a statement `mtllib`: one name, which may have blanks, or several. One that cannot be read
  /// is a warning.
  void read(std::string_view names);
  /// Whether the material of a statement `usemtl` is opaque. It is not where its dissolve (d) is below 1, its transparency
  /// (Tr) above 0, or it has a picture of either. One that is not described is.
  [[nodiscard]] bool is_opaque(std::string_view name) const { return !see_through_.contains(name); }

  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void read_file(const std::filesystem::path& file);

  const std::filesystem::path& file_;
  std::set<std::string, std::less<>> see_through_;
  std::set<std::string, std::less<>> read_;  ///< names of files
  std::vector<std::string> warnings_;
};

}  // namespace occlude::render::obj
