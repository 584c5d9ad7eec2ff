// SPDX-License-Identifier: MIT
// Numbers on their way from a child process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "occlude/render/child_process.h"

namespace occlude::render {

/// Writes numbers as they are in memory, and arrays as their length and their items. Throws std::runtime_error if the file
/// cannot be written.
class HandoverWriter {
 public:
  explicit HandoverWriter(std::FILE* file) : file_(file) {}

  template <class Items>
  void put(const Items& items) {
    put_number(items.size());
    write(items.data(), items.size() * sizeof(items[0]));
  }
  template <class Number>
  void put_number(const Number& number) {
    write(&number, sizeof(number));
  }
  void put_texts(const std::vector<std::string>& texts) {
    put_number(texts.size());
    for (const std::string& text : texts) put(text);
  }

 private:
  void write(const void* from, std::size_t bytes) {
    if (bytes != 0 && std::fwrite(from, 1, bytes, file_) != bytes)
      throw std::runtime_error("a temporary file cannot be written");
  }

  std::FILE* file_;
};

[[noreturn]] inline void refuse_damage() { throw ChildFailure("returns damaged data", false); }

/// Reads what a HandoverWriter wrote in a child that may have corrupted its own memory. Throws ChildFailure for what is not
/// there.
class HandoverReader {
 public:
  explicit HandoverReader(std::FILE* file) : file_(file) {
    std::fseek(file_, 0, SEEK_END);
    left_ = static_cast<std::uint64_t>(std::ftell(file_));
    std::rewind(file_);
  }

  template <class Items>
  void take(Items& items) {
    std::size_t count = 0;
    take_number(count);
    if (count > left_ / sizeof(items[0])) refuse_damage();
    items.resize(count);
    read(items.data(), items.size() * sizeof(items[0]));
  }
  template <class Number>
  void take_number(Number& number) {
    read(&number, sizeof(number));
  }
  void take_texts(std::vector<std::string>& texts) {
    std::size_t count = 0;
    for (take_number(count); count > 0; --count) take(texts.emplace_back());
  }

 private:
  void read(void* to, std::size_t bytes) {
    if (bytes == 0) return;  // `to` may be null
    if (bytes > left_ || std::fread(to, 1, bytes, file_) != bytes) refuse_damage();
    left_ -= bytes;
  }

  std::FILE* file_;
  std::uint64_t left_;  ///< bytes left in the file
};

}  // namespace occlude::render
