// SPDX-License-Identifier: MIT
// What a prepared model consists of, as bytes that can be kept and used again where they lie. Reading order: 10.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace occlude::culler {

/// An array of the model, in the byte order and the layout of this machine. `name` is a literal.
struct Part {
  std::string_view name;
  std::size_t element = 0;  ///< bytes of one of its elements
  std::span<const std::byte> bytes;
};

/// Every array of a prepared model: Culler::parts(). The layout of elements is the same on all little-endian machines with
/// IEEE doubles, but may change from version to version of this library: kPartsVersion tells.
struct Parts {
  std::vector<Part> parts;
  std::shared_ptr<const void> keep;  ///< what the bytes are in. They are there, and stay as they are, as long as it is.
  std::uint64_t left_out = 0;        ///< bytes of the parts that the model has beside these
};

inline constexpr unsigned kPartsVersion = 3;
/// The bytes of each part begin at a multiple of this.
inline constexpr std::size_t kPartAlignment = 64;

}  // namespace occlude::culler
