// SPDX-License-Identifier: MIT
// What gzip has compressed, block by block (RFC 1952).
#pragma once

#include <string>
#include <string_view>

struct z_stream_s;

namespace occlude::render {

class Gunzip {
 public:
  Gunzip();
  ~Gunzip();
  Gunzip(const Gunzip&) = delete;
  Gunzip& operator=(const Gunzip&) = delete;

  /// Compressed data begin with these bytes.
  static constexpr std::string_view kBegin = "\x1f\x8b";

  /// The next compressed bytes. REQUIRES: the last ones are all used.
  void feed(std::string compressed);
  /// Replaces `block` with the next bytes of what was compressed; none once the bytes fed are used. Returns false if they
  /// are damaged.
  [[nodiscard]] bool next(std::string& block);
  /// Whether the bytes so far are whole.
  [[nodiscard]] bool is_complete() const { return is_complete_; }

 private:
  z_stream_s* stream_;
  std::string compressed_;
  bool is_complete_ = false;
};

}  // namespace occlude::render
