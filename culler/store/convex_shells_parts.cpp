// SPDX-License-Identifier: MIT
// The parts of convex shells, and the checks of parts that are said to be those.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include "base/part_checks.h"
#include "frusta/convex_shells.h"
#include "frusta/shell_limits.h"
#include "frusta/shell_polytopes.h"
#include "model/part_list.h"

namespace occlude::culler {
namespace {

constexpr std::string_view kShellParts = "shell polygons", kShellFirstPart = "shell first polygon", kShellOf = "shell of",
                           kShellMost = "shell limits";

}  // namespace

void ConvexShells::append_parts(PartWriter& parts) const {
  parts.put(kShellParts, parts_);
  parts.put(kShellFirstPart, first_part_);
  parts.put(kShellOf, shell_of_);
  parts.put(kShellMost, std::span(&most_, 1));
}

bool ConvexShells::is_sound(std::uint32_t s, SoupView soup) const {
  const auto polygons = parts(s);
  if (polygons.size() < kLeastFaces || polygons.size() > kMostFaces) return false;
  if (!are_ascending_below(polygons, soup.size())) return false;
  const auto is_of = [&](std::uint32_t p) { return shell_of_[p] == s && soup.is_opaque(p); };
  return std::ranges::all_of(polygons, is_of) && sides_of(soup, polygons) <= kMostSides;
}

ConvexShells ConvexShells::from_parts(const PartReader& parts, SharedSoup shared, const Checkpoint& checkpoint) {
  ConvexShells result;
  result.parts_ = parts.get<std::uint32_t>(kShellParts);
  result.first_part_ = parts.get<std::uint32_t>(kShellFirstPart);
  result.shell_of_ = parts.get<std::uint32_t>(kShellOf);
  const auto most = parts.get<Most>(kShellMost);
  if (most.size() != 1 || most[0].faces > kMostFaces || most[0].edges > kMostSides) refuse_part(kShellMost, "out of range");
  result.most_ = most[0];

  const SoupView soup = shared.view;
  const std::size_t size = result.size();
  const auto is_shell = [&](std::size_t s) { return result.is_sound(static_cast<std::uint32_t>(s), soup); };
  const bool are_ranges =
      result.first_part_.empty() ? result.parts_.empty() : are_starts(result.first_part_, result.parts_.size(), checkpoint);
  if (!are_ranges || result.shell_of_.size() != (size == 0 ? 0 : soup.size()) || !are_all(size, is_shell, checkpoint)) {
    refuse_part(kShellParts, "the shells are not of these polygons");
  }
  // Shells have different polygons, because each of these has one shell. So no polygon has a shell that it is not in.
  if (std::cmp_not_equal(std::ranges::count_if(result.shell_of_, [](std::uint32_t s) { return s != kNone; }),
                         result.parts_.size())) {
    refuse_part(kShellOf, "a polygon is not in its shell");
  }
  result.soup_ = std::move(shared);
  result.polytopes_ = std::make_shared<ShellPolytopes>(size);
  return result;
}

}  // namespace occlude::culler
