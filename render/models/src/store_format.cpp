// SPDX-License-Identifier: MIT
#include "store_format.h"

#include <xxhash.h>

#include <algorithm>

#include "base/parallel.h"
#include "occlude/culler/parts.h"
#include "occlude/render/progress.h"

namespace occlude::render {
namespace {

static_assert(kStoreAlignment % culler::kPartAlignment == 0);

/// Large enough that starting is nothing, small enough to be divided among processors. Part of the format.
constexpr std::size_t kPiece = std::size_t{1} << 20U;

std::size_t pieces_of(std::size_t bytes) { return (bytes + kPiece - 1) / kPiece; }

}  // namespace

std::uint64_t hash_of(const StoreHeader& header, std::span<const StoreSection> table) {
  const std::array<std::uint64_t, 2> hashes{XXH3_64bits(&header, offsetof(StoreHeader, hash)),
                                            XXH3_64bits(table.data(), table.size_bytes())};
  return XXH3_64bits(hashes.data(), sizeof hashes);
}

std::vector<std::uint64_t> hashes_of(std::span<const std::span<const std::byte>> sections,
                                     const std::function<void(std::span<const std::byte>)>& touch) {
  std::vector<std::span<const std::byte>> pieces;
  for (const auto& section : sections) {
    for (std::size_t at = 0; at < section.size(); at += kPiece) {
      pieces.push_back(section.subspan(at, std::min(kPiece, section.size() - at)));
    }
  }
  std::vector<std::uint64_t> of_pieces(pieces.size());
  const auto hash_piece = [&](std::size_t i) {
    if (touch) touch(pieces[i]);
    of_pieces[i] = XXH3_64bits(pieces[i].data(), pieces[i].size());
  };
  culler::parallel_for(pieces.size(), hash_piece, check_interrupt);
  std::vector<std::uint64_t> hashes;
  const std::uint64_t* next = of_pieces.data();
  for (const auto& section : sections) {
    const std::size_t count = pieces_of(section.size());
    hashes.push_back(XXH3_64bits(next, count * sizeof *next));
    next += count;
  }
  return hashes;
}

}  // namespace occlude::render
