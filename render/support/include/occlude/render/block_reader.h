// SPDX-License-Identifier: MIT
// Files block by block, also from pipes and terminals. What gzip has compressed is read as what it was.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace occlude::render {

class Gunzip;  // gunzip.h

/// "-" is standard input. Throws InputError, naming the file, if it cannot be opened or read, or has compressed data that
/// are damaged or cut off. Throws Interrupted on Ctrl-C, also from a read that waits.
class BlockReader {
 public:
  explicit BlockReader(const std::string& file);
  ~BlockReader();
  BlockReader(const BlockReader&) = delete;
  BlockReader& operator=(const BlockReader&) = delete;

  /// Some of the bytes that were not used yet; none at the end. Waits if there are none.
  [[nodiscard]] std::string_view ahead();
  /// Uses some of them. REQUIRES: as many are ahead.
  void use(std::size_t bytes) { used_ += bytes; }

  /// The name of the file in error messages.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Bytes of the file read so far, and its size; the size of a pipe is 0.
  [[nodiscard]] std::size_t read() const { return read_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  /// Appends the next bytes of the file, waiting if necessary. False at the end.
  bool refill(std::string& block);
  [[noreturn]] void fail(const char* what) const;

  std::string name_;
  int file_;
  std::string block_;     ///< the last one
  std::size_t used_ = 0;  ///< bytes of it
  std::size_t read_ = 0, size_ = 0;
  std::unique_ptr<Gunzip> gunzip_;  ///< of a compressed file
};

}  // namespace occlude::render
