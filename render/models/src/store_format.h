// SPDX-License-Identifier: MIT
// The header, the table and the hashes of a store (store.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace occlude::render {

inline constexpr std::string_view kStoreMagic = "occlude preprocess\n";
/// Sections begin at multiples of this, as culler::kPartAlignment asks.
inline constexpr std::size_t kStoreAlignment = 64;

/// `version` is not aligned, because it stands where all versions have it.
struct StoreHeader {
  std::array<char, 19> magic{};
  std::array<std::uint8_t, 4> version{};
  std::uint8_t unused_byte = 0;
  std::uint32_t sections = 0, unused_word = 0;
  std::uint64_t bytes = 0;
  std::array<std::uint64_t, 2> unused{};
  std::uint64_t hash = 0;
};
static_assert(sizeof(StoreHeader) == kStoreAlignment);

struct StoreSection {
  std::array<char, 32> name{};
  std::uint32_t element = 0, unused = 0;
  std::uint64_t offset = 0, bytes = 0, hash = 0;
};
static_assert(sizeof(StoreSection) == kStoreAlignment);

/// The next multiple of kStoreAlignment. REQUIRES: bytes < 2^63.
[[nodiscard]] constexpr std::uint64_t aligned(std::uint64_t bytes) {
  return (bytes + kStoreAlignment - 1) / kStoreAlignment * kStoreAlignment;
}

/// StoreHeader::hash.
[[nodiscard]] std::uint64_t hash_of(const StoreHeader& header, std::span<const StoreSection> table);

/// StoreSection::hash of each of these sections. On all processors. Calls touch(piece), if given, before
/// it reads a piece.
[[nodiscard]] std::vector<std::uint64_t> hashes_of(std::span<const std::span<const std::byte>> sections,
                                                   const std::function<void(std::span<const std::byte>)>& touch = {});

}  // namespace occlude::render
