// SPDX-License-Identifier: MIT
#include "page_model.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "bytes.h"
#include "occlude/render/polygon_area.h"

namespace occlude::render {
namespace {

constexpr double kSteps = 65535;

/// Whether each polygon is among the `most` largest.
std::vector<bool> largest(const culler::PolygonSoup& soup, std::size_t most) {
  std::vector<bool> chosen(soup.size(), soup.size() <= most);
  if (soup.size() <= most) return chosen;
  std::vector<std::pair<double, std::uint32_t>> by_area;
  for (std::uint32_t p = 0; p < soup.size(); ++p) by_area.emplace_back(-glm::length(doubled_area(soup, p)), p);
  std::ranges::nth_element(by_area, by_area.begin() + static_cast<std::ptrdiff_t>(most));
  for (std::size_t i = 0; i < most; ++i) chosen[by_area[i].second] = true;
  return chosen;
}

/// Vertices that fall on one point of the grid become one; they are numbered by their first use.
class Vertices {
 public:
  std::uint32_t number_of(const std::array<std::uint16_t, 3>& point) {
    const std::uint64_t key =
        static_cast<std::uint64_t>(point[0]) << 32 | static_cast<std::uint64_t>(point[1]) << 16 | point[2];
    const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(point);
    return found->second;
  }
  [[nodiscard]] const std::vector<std::array<std::uint16_t, 3>>& points() const { return points_; }

 private:
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  std::vector<std::array<std::uint16_t, 3>> points_;
};

/// For x, then y, then z: of each point the difference from the point before, modulo 2^16, with the sign in the lowest bit;
/// first all low bytes, then all high bytes.
std::string pack_vertices(const std::vector<std::array<std::uint16_t, 3>>& points) {
  std::string bytes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::string low, high;
    std::uint16_t before = 0;
    for (const auto& point : points) {
      const auto difference = static_cast<std::int16_t>(static_cast<std::uint16_t>(point[axis] - before));
      const unsigned folded =
          difference < 0 ? ~(static_cast<unsigned>(difference) << 1) : static_cast<unsigned>(difference) << 1;
      low += static_cast<char>(folded & 0xFFU);
      high += static_cast<char>(folded >> 8 & 0xFFU);
      before = point[axis];
    }
    bytes += low + high;
  }
  return bytes;
}

}  // namespace

PageGrid::PageGrid(std::span<const glm::dvec3> points) {
  if (points.empty()) return;
  low = points[0];
  glm::dvec3 high = low;
  for (const glm::dvec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (high[axis] > low[axis]) step[axis] = (high[axis] - low[axis]) / kSteps;
  }
}

std::array<std::uint16_t, 3> PageGrid::at(const glm::dvec3& point) const {
  std::array<std::uint16_t, 3> result{};
  for (int axis = 0; axis < 3; ++axis) {
    const double steps = std::clamp(std::round((point[axis] - low[axis]) / step[axis]), 0.0, kSteps);
    result[static_cast<std::size_t>(axis)] = static_cast<std::uint16_t>(steps);
  }
  return result;
}

PageModel::PageModel(const culler::Hierarchy& hierarchy, std::size_t most)
    : grid_(hierarchy.soup().vertices), place_(hierarchy.soup().size(), kNone) {
  const culler::PolygonSoup& soup = hierarchy.soup();
  const std::vector<bool> is_chosen = largest(soup, most);
  Vertices vertices;
  Bytes leaf_sizes, sides, corners, numbers;
  std::int64_t number_before = 0;
  std::vector<std::uint32_t> leaf;
  const auto add = [&](std::uint32_t p) {
    place_[p] = static_cast<std::uint32_t>(polygons_++);
    numbers.difference(hierarchy.original(p) - number_before);
    number_before = hierarchy.original(p);
    sides.number(soup.loop(p).size());
    for (const std::uint32_t index : soup.loop(p)) {
      const std::size_t unused = vertices.points().size();
      corners.number(unused - vertices.number_of(grid_.at(soup.vertices[index])));
    }
  };
  for (const culler::HierarchyNode& node : hierarchy.nodes()) {
    if (!node.is_leaf()) continue;
    leaf_first_.push_back(node.first);
    leaf.clear();
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
      if (is_chosen[p]) leaf.push_back(p);
    }
    std::ranges::sort(leaf, {}, [&](std::uint32_t p) { return hierarchy.original(p); });
    leaf_sizes.number(leaf.size());
    for (const std::uint32_t p : leaf) add(p);
  }
  vertices_ = pack_vertices(vertices.points());
  leaf_sizes_ = leaf_sizes.text();
  sides_ = sides.text();
  corners_ = corners.text();
  numbers_ = numbers.text();
}

std::pair<std::uint32_t, std::uint32_t> PageModel::leaves_of(const culler::HierarchyNode& node) const {
  const auto first = std::ranges::lower_bound(leaf_first_, node.first);
  const auto end = std::ranges::lower_bound(first, leaf_first_.end(), node.first + node.count);
  return {static_cast<std::uint32_t>(first - leaf_first_.begin()), static_cast<std::uint32_t>(end - first)};
}

}  // namespace occlude::render
