// SPDX-License-Identifier: MIT
#include "cover/cover_sheets.h"

#include <algorithm>
#include <array>

namespace occlude::culler {

void CoverSheets::reserve(std::size_t triangles) {
  sets_.reserve(triangles);
  is_inner_.reserve(3 * triangles);
  sheet_of_.reserve(triangles);
  triangles_.reserve(triangles);
  begins_.reserve(triangles + 1);
  next_.reserve(triangles);
}

void CoverSheets::part(const CoverMesh& mesh, std::span<const std::int8_t> signs) {
  const auto count = static_cast<std::uint32_t>(signs.size());
  sets_.reset(count);
  is_inner_.assign(3 * std::size_t{count}, 0);
  for (std::uint32_t side = 0; side < 3 * count; ++side) {
    if (mesh.next_of(side) > side) join_ring(mesh, signs, side);  // else it is alone, or not the first
  }
  // Orders sheets by their first triangles, and the triangles of a sheet by number.
  sheet_of_.assign(count, 0);
  begins_.assign(1, 0);
  for (std::uint32_t t = 0; t < count; ++t) {
    if (signs[t] == 0) continue;
    const std::uint32_t root = sets_.find(t);
    if (root == t) {
      sheet_of_[t] = static_cast<std::uint32_t>(size());
      begins_.push_back(0);
    }
    ++begins_[sheet_of_[root] + 1];
  }
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  next_.assign(begins_.begin(), begins_.end() - 1);
  triangles_.resize(begins_.back());
  for (std::uint32_t t = 0; t < count; ++t) {
    if (signs[t] != 0) triangles_[next_[sheet_of_[sets_.find(t)]]++] = t;
  }
}

void CoverSheets::join(std::uint32_t triangle, std::uint32_t other) {
  const std::uint32_t a = sets_.find(triangle), b = sets_.find(other);
  sets_.join(std::min(a, b), std::max(a, b));
}

/// Joins the triangles of a ring of several two by two. Does so only when `first` is the first side of the ring.
void CoverSheets::join_ring(const CoverMesh& mesh, std::span<const std::int8_t> signs, std::uint32_t first) {
  const std::uint32_t second = mesh.next_of(first);
  if (mesh.next_of(second) == first) {
    const std::uint32_t a = first / 3, b = second / 3;
    const bool is_along = mesh.triangles[a][first % 3] == mesh.triangles[b][second % 3];
    if (signs[a] * signs[b] != (is_along ? -1 : 1)) return;
    is_inner_[first] = is_inner_[second] = 1;
    join(a, b);
    return;
  }
  std::array<std::uint32_t, kMostInRing> ring{};
  std::size_t count = 0;
  for (std::uint32_t side = first; count == 0 || side != first; side = mesh.next_of(side)) {
    if (side < first) return;
    ring[count++] = side;
  }
  const std::uint32_t from = mesh.triangles[first / 3][first % 3];
  std::array<std::uint32_t, kMostInRing> alone{};  // triangles without a partner so far, all turned the same way
  std::size_t left = 0;
  int way = 0;
  for (const std::uint32_t side : std::span(ring).first(count)) {
    const std::uint32_t triangle = side / 3;
    const int turned = mesh.triangles[triangle][side % 3] == from ? signs[triangle] : -signs[triangle];
    if (turned == 0) continue;
    if (left > 0 && turned == -way) {
      join(alone[--left], triangle);
    } else {
      alone[left++] = triangle;
      way = turned;
    }
  }
}

}  // namespace occlude::culler
