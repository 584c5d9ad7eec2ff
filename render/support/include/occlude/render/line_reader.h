// SPDX-License-Identifier: MIT
// Text files line by line, also from pipes and terminals.
#pragma once

#include <cstddef>
#include <string>

namespace occlude::render {

/// "-" is standard input. Throws InputError, naming the file, if it cannot be opened or read or has a line longer than
/// kMostJson. Throws Interrupted on Ctrl-C, also from a read that waits.
class LineReader {
 public:
  explicit LineReader(const std::string& file);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// Reads the next line, without its line break. False at the end.
  [[nodiscard]] bool next(std::string& line);

  /// The name of the file in error messages.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The number of the last line read, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Bytes read so far, and the size of the file; the size of a pipe is 0.
  [[nodiscard]] std::size_t read() const { return read_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  /// Reads the next block, waiting if necessary. False at the end.
  bool refill();
  [[noreturn]] void fail(const char* what) const;

  std::string name_;
  int file_;
  std::string buffer_;    ///< the last block read
  std::size_t used_ = 0;  ///< bytes of it already returned in lines
  std::size_t number_ = 0, read_ = 0, size_ = 0;
};

}  // namespace occlude::render
