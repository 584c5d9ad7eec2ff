// SPDX-License-Identifier: MIT
// Text files line by line, also from pipes and terminals.
#pragma once

#include <cstddef>
#include <string>

namespace occlude::render {

/// "-" is standard input. The wish to stop ends a read that waits. Throws InputError, naming the file, for what cannot be
/// opened or read and for a line longer than kMostJson, and Interrupted.
class LineReader {
 public:
  explicit LineReader(const std::string& file);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// Reads the next line, without its break; false at the end.
  [[nodiscard]] bool next(std::string& line);

  /// Of the file, as errors call it.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Of the line that was read last, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Bytes read so far, and in all; 0 where nobody knows, of a pipe.
  [[nodiscard]] std::size_t read() const { return read_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  /// Reads what there is, waiting for it if need be; false at the end.
  bool refill();
  [[noreturn]] void fail(const char* what) const;

  std::string name_;
  int file_;
  std::string buffer_;    ///< what was read last,
  std::size_t used_ = 0;  ///< and how much of it is in lines already
  std::size_t number_ = 0, read_ = 0, size_ = 0;
};

}  // namespace occlude::render
