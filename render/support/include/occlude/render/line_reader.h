// SPDX-License-Identifier: MIT
// Text files line by line, also from pipes and terminals, and compressed by gzip.
#pragma once

#include <cstddef>
#include <string>

#include "occlude/render/block_reader.h"

namespace occlude::render {

/// "-" is standard input. Throws as BlockReader, and InputError, naming the line, for one longer than kMostJson.
class LineReader {
 public:
  explicit LineReader(const std::string& file) : blocks_(file) {}

  /// Reads the next line, without its line break. False at the end.
  [[nodiscard]] bool next(std::string& line);

  /// The file. Who uses its bytes takes them from the lines.
  [[nodiscard]] BlockReader& blocks() { return blocks_; }
  /// The name of the file in error messages.
  [[nodiscard]] const std::string& name() const { return blocks_.name(); }
  /// The number of the last line read, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Bytes of the file read so far, and its size; the size of a pipe is 0.
  [[nodiscard]] std::size_t read() const { return blocks_.read(); }
  [[nodiscard]] std::size_t size() const { return blocks_.size(); }

 private:
  BlockReader blocks_;
  std::size_t number_ = 0;
};

}  // namespace occlude::render
