// SPDX-License-Identifier: MIT
// Structs that begin with their size, of this version or an older one.
#pragma once

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>

#include "layout.h"
#include "occlude.h"
#include "status.h"

namespace occlude::c {

/// The size that a caller's struct of `most` bytes says. Structs grow by whole words, and none ends in padding (layout.h),
/// so all members of an older version are whole.
[[nodiscard]] inline std::size_t said_size(const void* given, std::size_t most, const char* name) {
  require(given, name);
  std::size_t size = 0;
  std::memcpy(&size, given, sizeof size);
  if (size < sizeof size || size % sizeof size != 0) {
    throw std::invalid_argument(std::string(name) + ": its size is " + std::to_string(size) + ", which is of no version");
  }
  if (size > most) throw std::invalid_argument(std::string(name) + " is of a newer version than the library");
  return size;
}

/// A struct of the caller, with defaults for what an older version does not have.
template <class Struct>
[[nodiscard]] Struct read(const Struct* given, Struct defaults, const char* name) {
  std::memcpy(&defaults, given, said_size(given, sizeof defaults, name));
  return defaults;
}

/// The same of options, which may be null. What is reserved, if anything, is 0.
template <class Struct>
[[nodiscard]] Struct read_options(const Struct* given, const Struct& defaults, const char* name) {
  const Struct options = given == nullptr ? defaults : read(given, defaults, name);
  if constexpr (requires { options.reserved; }) {
    if (options.reserved != 0) throw std::invalid_argument(std::string(name) + ": reserved is not 0");
  }
  return options;
}

/// Fills in what the caller's struct has room for, but for its size.
template <class Struct>
void write(const Struct& values, Struct* to, const char* name) {
  const std::size_t size = said_size(to, sizeof values, name);
  constexpr std::size_t kHead = sizeof values.size;
  std::memcpy(reinterpret_cast<std::byte*>(to) + kHead, reinterpret_cast<const std::byte*>(&values) + kHead, size - kHead);
}

}  // namespace occlude::c
