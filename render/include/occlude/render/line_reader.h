// SPDX-License-Identifier: MIT
// Text files line by line, also from pipes and terminals.
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

namespace occlude::render {

/// "-" is standard input. The wish to stop ends a read that waits. Throws InputError, naming the file, for what cannot be
/// opened or read, and Interrupted.
class LineReader {
 public:
  explicit LineReader(const std::string& file);

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
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  struct Free {
    void operator()(char* text) const { std::free(text); }
  };

  [[noreturn]] void fail(const char* what) const;

  std::string name_;
  std::unique_ptr<std::FILE, Close> opened_;
  std::FILE* file_ = nullptr;
  std::unique_ptr<char, Free> buffer_;
  std::size_t capacity_ = 0, number_ = 0, read_ = 0, size_ = 0;
};

}  // namespace occlude::render
