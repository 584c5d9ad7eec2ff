// SPDX-License-Identifier: MIT
// A file of `occlude walk --witness`, or of `bake` or `prune`, line by line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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
  /// Whether it begins with a claim, as those of `bake` and `prune` do.
  [[nodiscard]] bool has_claims() const { return has_claims_; }
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
  bool has_claims_ = false;
};

/// As many lines as are proved as one part: enough to keep all threads busy, and few enough to keep memory small. None at
/// the end.
[[nodiscard]] std::vector<Place> next_part(const std::function<std::optional<Place>()>& next);

[[nodiscard]] std::string pack_lines(const std::vector<Place>& places);
/// Throws PartError for bytes that are no lines.
[[nodiscard]] std::vector<std::string> unpack_lines(const std::string& bytes);

}  // namespace occlude::cli
