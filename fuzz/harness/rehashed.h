// SPDX-License-Identifier: MIT
// Right hashes for a changed store, so that readers get past them.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "store_format.h"

namespace occlude::harness {

/// Gives a store (render/store.h) the hashes that its bytes have, as far as its table can be followed.
inline void rehash(std::span<std::byte> store) {
  render::StoreHeader header;
  if (store.size() < sizeof header) return;
  std::memcpy(&header, store.data(), sizeof header);
  if (header.sections > (store.size() - sizeof header) / sizeof(render::StoreSection)) return;
  std::vector<render::StoreSection> table(header.sections);
  const std::span place = store.subspan(sizeof header, table.size() * sizeof(render::StoreSection));
  if (!place.empty()) std::memcpy(table.data(), place.data(), place.size());
  for (render::StoreSection& section : table) {
    if (section.offset > store.size() || section.bytes > store.size() - section.offset) continue;
    const std::span<const std::byte> bytes = store.subspan(section.offset, section.bytes);
    section.hash = render::hashes_of(std::span(&bytes, 1)).front();
  }
  header.hash = hash_of(header, table);
  std::memcpy(store.data(), &header, sizeof header);
  if (!place.empty()) std::memcpy(place.data(), table.data(), place.size());
}

}  // namespace occlude::harness
