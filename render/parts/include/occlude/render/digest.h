// SPDX-License-Identifier: MIT
// A number that tells inputs apart.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace occlude::render {

/// FNV-1a of 64 bits (Fowler, Noll, Vo). It finds accidents, not forgeries.
class Digest {
 public:
  Digest& add(std::string_view bytes) {
    for (const char byte : bytes) add_byte(byte);
    add_byte('\0');  // so that "a", "b" is not "ab"
    return *this;
  }
  template <class T>
  Digest& add(std::span<const T> values) requires std::is_trivially_copyable_v<T> {
    return add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  }

  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  void add_byte(char byte) { value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U; }

  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace occlude::render
