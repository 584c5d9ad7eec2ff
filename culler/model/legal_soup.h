// SPDX-License-Identifier: MIT
// The checks of models and of the rounding mode.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

#include "base/part_checks.h"
#include "base/rounding.h"
#include "model/bounds.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// Whether they can be the faces of so many polygons: none, or 0, and then the one before or the next.
[[nodiscard]] inline bool are_faces(std::span<const std::uint32_t> faces, std::size_t polygons) {
  if (faces.empty()) return true;
  const auto does_not_follow = [](std::uint32_t before, std::uint32_t face) { return face - before > 1; };
  return faces.size() == polygons && faces[0] == 0 && std::ranges::adjacent_find(faces, does_not_follow) == faces.end();
}

/// Whether they can tell of so many polygons which are see-through.
[[nodiscard]] inline bool are_marks(std::span<const std::uint8_t> marks, std::size_t polygons) {
  return marks.empty() ||
         (marks.size() == polygons && std::ranges::all_of(marks, [](std::uint8_t mark) { return mark <= 1; }));
}

/// Throws std::invalid_argument, with the polygon and the reason, unless the soup is well formed (polygon_soup.h).
inline void require_well_formed(SoupView soup) {
  const auto refuse = [](std::size_t polygon, const std::string& reason) {
    throw std::invalid_argument("polygon " + std::to_string(polygon) + ": " + reason);
  };
  if (soup.first.empty() || soup.first[0] != 0) throw std::invalid_argument("the soup's `first` does not begin with 0");
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const std::size_t begin = soup.first[p], end = soup.first[p + 1];
    if (end < begin || end > soup.indices.size()) refuse(p, "its corners are not among the indices");
    if (end - begin < 3) refuse(p, "fewer than 3 corners");
    for (std::size_t i = begin; i < end; ++i) {
      if (soup.indices[i] >= soup.vertices.size()) {
        refuse(p, "corner " + std::to_string(i - begin) + " is vertex " + std::to_string(soup.indices[i]) + " of " +
                      std::to_string(soup.vertices.size()));
      }
    }
  }
  if (soup.first.back() != soup.indices.size()) throw std::invalid_argument("the soup has indices after its last polygon");
  if (!are_faces(soup.faces, soup.size())) throw std::invalid_argument("the soup's `faces` do not number its polygons");
  if (!are_marks(soup.see_through, soup.size()))
    throw std::invalid_argument("the soup's `see_through` is not 0 or 1 for each polygon");
}

/// Throws what the two functions above throw, and std::invalid_argument, with the vertex and the reason, for a coordinate
/// that is not finite or out of the kernel's legal range.
inline void require_legal(SoupView soup) {
  require_rounding();
  require_well_formed(soup);
  for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
    if (const auto refusal = kernel::check(to_kernel(soup.vertices[v])); refusal != kernel::Refusal::none) {
      throw std::invalid_argument("vertex " + std::to_string(v) + ": " + std::string(kernel::to_string(refusal)));
    }
  }
}

/// Whether require_legal() would throw nothing about the soup. In parallel.
[[nodiscard]] inline bool is_legal(SoupView soup, const Checkpoint& checkpoint) {
  const auto is_point = [&](std::size_t v) { return kernel::check(to_kernel(soup.vertices[v])) == kernel::Refusal::none; };
  return is_well_formed(soup, checkpoint) && are_all(soup.vertices.size(), is_point, checkpoint);
}

}  // namespace occlude::culler
