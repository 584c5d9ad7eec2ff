// SPDX-License-Identifier: MIT
#include "frusta/closed_parts.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/disjoint_sets.h"

namespace occlude::culler {

std::vector<std::vector<std::uint32_t>> find_parts(SoupView soup, std::span<const std::uint32_t> weld,
                                                   const Checkpoint& checkpoint) {
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::uint32_t> polygon_at(soup.vertices.size(), kNone);  // of each welded corner, the first
  DisjointSets sets(soup.size());
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    checkpoint.at(p);
    for (const std::uint32_t index : soup.loop(p)) {
      std::uint32_t& other = polygon_at[weld[index]];
      if (other == kNone) other = p;
      sets.join(sets.find(other), sets.find(p));
    }
  }
  std::vector<std::vector<std::uint32_t>> parts;
  sets.for_each_set([&](std::span<const std::uint32_t> part) { parts.emplace_back(part.begin(), part.end()); });
  std::ranges::sort(parts, {}, [](const std::vector<std::uint32_t>& part) { return part.front(); });
  return parts;
}

bool is_closed(SoupView soup, std::span<const std::uint32_t> weld, std::span<const std::uint32_t> part) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const std::uint32_t p : part) {
    if (!soup.is_opaque(p)) return false;
    const std::span<const std::uint32_t> loop = soup.loop(p);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = weld[loop[i]], b = weld[loop[(i + 1) % loop.size()]];
      if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  if (edges.size() % 2 != 0) return false;
  std::ranges::sort(edges);
  // Each run of equal edges is even if its edges pair up one after another.
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    if (edges[i] != edges[i + 1]) return false;
  }
  return true;
}

}  // namespace occlude::culler
