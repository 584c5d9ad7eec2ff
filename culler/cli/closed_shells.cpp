// SPDX-License-Identifier: MIT
#include "closed_shells.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <iterator>
#include <map>
#include <span>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/parallel_sort.h"
#include "model/adjacency.h"
#include "model/bounds.h"

namespace occlude::cli {
namespace {

using Polygons = std::vector<std::uint32_t>;

struct Side {
  std::uint32_t low, high;  ///< welded corners
  std::uint32_t polygon;

  auto operator<=>(const Side&) const = default;
};

/// Polygons that hang together by edges along which no third one runs.
struct Patch {
  kernel::Aabb box = culler::empty_box();
  Polygons polygons;
  std::vector<std::uint32_t> rim;  ///< other edges along which an odd number of its sides run, ascending
};

/// The numbers that are in one of two ascending lists, and not in both.
std::vector<std::uint32_t> sum(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::vector<std::uint32_t> result;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(result));
  return result;
}

/// Patches without which each edge has an even number of sides: the first of them, as far as there is a choice. Gauss's
/// elimination of numbers modulo 2.
std::vector<std::uint32_t> patches_to_leave_out(const std::vector<Patch>& patches) {
  struct Sum {
    std::vector<std::uint32_t> edges, patches;
  };
  std::map<std::uint32_t, Sum> basis;  // by the last edge
  const auto reduced = [&](Sum rest) {
    while (!rest.edges.empty()) {
      const auto found = basis.find(rest.edges.back());
      if (found == basis.end()) break;
      rest = {sum(rest.edges, found->second.edges), sum(rest.patches, found->second.patches)};
    }
    return rest;
  };
  Sum all;
  for (std::uint32_t i = 0; i < patches.size(); ++i) {
    all.edges = sum(all.edges, patches[i].rim);
    Sum rest = reduced({patches[i].rim, {i}});
    if (!rest.edges.empty()) basis.emplace(rest.edges.back(), std::move(rest));
  }
  return reduced(std::move(all)).patches;
}

/// The sides of the polygons, by their edges. Of polygons with the same corners only one counts.
std::vector<Side> sides_of(culler::SoupView soup, const culler::Checkpoint& checkpoint) {
  const std::vector<std::uint32_t> weld = culler::welded(soup.vertices, checkpoint);
  const std::vector<bool> is_repeated = culler::find_repeated(soup, weld, checkpoint);
  std::vector<Side> sides;
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    checkpoint.at(p);
    if (!soup.is_opaque(p) || is_repeated[p]) continue;
    const std::span<const std::uint32_t> loop = soup.loop(p);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = weld[loop[i]], b = weld[loop[(i + 1) % loop.size()]];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), p});
    }
  }
  culler::parallel_sort(sides, checkpoint);
  return sides;
}

/// Calls take(edge, sides) for each edge: its number, and the sides along it.
template <class Take>
void for_each_edge(std::span<const Side> sides, const Take& take) {
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    take(static_cast<std::uint32_t>(i), sides.subspan(i, end - i));
  }
}

/// What is left of these patches; nothing if it would take seconds to find.
Polygons shell_of(std::map<std::uint32_t, Patch> by_root) {
  constexpr double kMostWork = 0x1p32;  // numbers in sums, at about a nanosecond each
  Polygons shell;
  double rims = 0;
  for (const auto& [root, patch] : by_root) rims += static_cast<double>(patch.rim.size());
  if (std::pow(static_cast<double>(by_root.size()), 2) * rims > kMostWork) return shell;
  std::vector<Patch> patches;
  for (auto& [root, patch] : by_root) patches.push_back(std::move(patch));
  // A wall is smaller than the surfaces between which it stands, which could be left out as well.
  std::ranges::stable_sort(patches, {}, [](const Patch& patch) { return culler::half_area(patch.box); });
  for (const std::uint32_t i : patches_to_leave_out(patches)) patches[i].polygons.clear();
  for (const Patch& patch : patches) shell.insert(shell.end(), patch.polygons.begin(), patch.polygons.end());
  std::ranges::sort(shell);
  return shell;
}

}  // namespace

std::vector<Polygons> closed_shells(culler::SoupView soup, const culler::Checkpoint& checkpoint) {
  const std::vector<Side> sides = sides_of(soup, checkpoint);
  culler::DisjointSets smooth(soup.size()), joined(soup.size());  // patches, and what hangs together by any edges
  Polygons polygons;
  for_each_edge(sides, [&](std::uint32_t, std::span<const Side> along) {
    const std::uint32_t first = along[0].polygon;
    if (along.size() == 2) smooth.join(smooth.find(first), smooth.find(along[1].polygon));
    for (const Side& side : along) {
      joined.join(joined.find(first), joined.find(side.polygon));
      polygons.push_back(side.polygon);
    }
  });
  std::ranges::sort(polygons);
  polygons.erase(std::ranges::unique(polygons).begin(), polygons.end());

  std::map<std::uint32_t, std::map<std::uint32_t, Patch>> parts;
  const auto patch_of = [&](std::uint32_t p) -> Patch& { return parts[joined.find(p)][smooth.find(p)]; };
  for (const std::uint32_t p : polygons) {
    Patch& patch = patch_of(p);
    patch.polygons.push_back(p);
    culler::grow(patch.box, soup.box(p));
  }
  for_each_edge(sides, [&](std::uint32_t edge, std::span<const Side> along) {
    if (along.size() == 2) return;
    for (const Side& side : along) {
      std::vector<std::uint32_t>& rim = patch_of(side.polygon).rim;
      const bool is_even = !rim.empty() && rim.back() == edge;
      is_even ? rim.pop_back() : rim.push_back(edge);
    }
  });
  std::vector<Polygons> shells;
  for (auto& [root, patches] : parts) {
    checkpoint();
    shells.push_back(shell_of(std::move(patches)));
  }
  std::erase_if(shells, [](const Polygons& shell) { return shell.empty(); });
  return shells;
}

}  // namespace occlude::cli
