// SPDX-License-Identifier: MIT
// frames.csv of a walk, read back.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace occlude::render {

/// A row for each frame, in ascending order of the column "frame".
class FrameTable {
 public:
  /// Throws InputError, naming the file and the line, unless it is a header with "frame" and rows of as many numbers,
  /// those of the frames whole and ascending.
  explicit FrameTable(const std::filesystem::path& file);

  /// The column's values; null if there is no such column.
  [[nodiscard]] const std::vector<double>* column(const std::string& name) const;
  [[nodiscard]] const std::vector<double>& frames() const { return columns_.at("frame"); }

 private:
  std::map<std::string, std::vector<double>> columns_;
};

}  // namespace occlude::render
