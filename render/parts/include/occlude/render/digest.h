// SPDX-License-Identifier: MIT
// A number that tells inputs apart.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace occlude::render {

/// FNV-1a of 64 bits (Fowler, Noll, Vo), of bytes that may follow others. It finds accidents, not forgeries.
inline constexpr std::uint64_t kFnvOfNothing = 0xcbf29ce484222325U;
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view bytes, std::uint64_t before = kFnvOfNothing) {
  for (const char byte : bytes) before = (before ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return before;
}

/// The same of several inputs, each kept apart from the next.
class Digest {
 public:
  Digest& add(std::string_view bytes) {
    using namespace std::string_view_literals;
    value_ = fnv1a("\0"sv, fnv1a(bytes, value_));  // so that "a", "b" is not "ab"
    return *this;
  }
  template <class T>
  Digest& add(std::span<const T> values) requires std::is_trivially_copyable_v<T> {
    return add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  }

  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = kFnvOfNothing;
};

}  // namespace occlude::render
