// SPDX-License-Identifier: MIT
// A file of `occlude walk --witness`, line by line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "occlude/render/line_reader.h"

namespace occlude::cli {

/// A witness and where it comes from.
struct Place {
  std::string line, name;
  std::size_t number;                     ///< the number of its line, from 1
  std::optional<std::size_t> frame = {};  ///< if it is known before the line is read
};

/// The lines that are not blank. The first is read at once, because it tells the tree; so a pipe will do. Throws InputError
/// as LineReader does.
class WitnessFile {
 public:
  /// Throws InputError, with the place, also if the first line is no witness.
  explicit WitnessFile(const std::string& name);

  /// Hierarchy::leaf_size() of the tree that the first line is about. Of an empty file: of any tree.
  [[nodiscard]] std::uint32_t leaf_size() const { return leaf_size_; }
  /// The next witness, none at the end.
  [[nodiscard]] std::optional<Place> next();
  /// Bytes read so far, and the size of the file; the size of a pipe is 0.
  [[nodiscard]] std::size_t read() const { return lines_.read(); }
  [[nodiscard]] std::size_t size() const { return lines_.size(); }

 private:
  [[nodiscard]] std::optional<Place> read_next();

  render::LineReader lines_;
  std::optional<Place> next_;
  std::uint32_t leaf_size_ = 1;
};

}  // namespace occlude::cli
