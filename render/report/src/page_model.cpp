// SPDX-License-Identifier: MIT
#include "page_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "bytes.h"
#include "model/bounds.h"

namespace occlude::render {
namespace {

constexpr double kMostSteps = (std::uint32_t{1} << PageGrid::kBits) - 1;

/// Whether each polygon is among the `most` largest.
std::vector<bool> largest(culler::SoupView soup, std::size_t most) {
  std::vector<bool> chosen(soup.size(), soup.size() <= most);
  if (soup.size() <= most) return chosen;
  std::vector<std::pair<double, std::uint32_t>> by_area;
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    by_area.emplace_back(-glm::length(culler::doubled_area(soup, soup.loop(p))), p);
  }
  std::ranges::nth_element(by_area, by_area.begin() + static_cast<std::ptrdiff_t>(most));
  for (std::size_t i = 0; i < most; ++i) chosen[by_area[i].second] = true;
  return chosen;
}

/// Vertices that fall on one point of the grid become one; they are numbered by their first use.
class Vertices {
 public:
  std::uint32_t number_of(const GridPoint& point) {
    const auto [found, is_new] = numbers_.try_emplace(point, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(point);
    return found->second;
  }
  [[nodiscard]] const std::vector<GridPoint>& points() const { return points_; }

 private:
  struct Hash {
    std::size_t operator()(const GridPoint& point) const {
      constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;
      const std::uint64_t high = (std::uint64_t{point[0]} << 32U | point[1]) * kGolden;
      return static_cast<std::size_t>((high ^ high >> 32U ^ point[2]) * kGolden);
    }
  };
  std::unordered_map<GridPoint, std::uint32_t, Hash> numbers_;
  std::vector<GridPoint> points_;
};

/// For x, then y, then z: the folded difference of each point from the point before, in planes of bytes.
std::string pack_vertices(const std::vector<GridPoint>& points) {
  constexpr std::size_t kBytesEach = 4;
  std::string bytes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::uint64_t before = 0;
    append_planes(bytes, points.size(), kBytesEach,
                  [&](std::size_t i) { return folded(points[i][axis] - std::exchange(before, points[i][axis])); });
  }
  return bytes;
}

/// The coarsest power of two, at least `finest`, of which all coordinates are multiples, counted from `low`; `finest` if
/// there is none.
double common_step(std::span<const glm::dvec3> points, const glm::dvec3& low, double finest) {
  std::uint32_t bits = 0;  // set in some number of finest steps
  for (const glm::dvec3& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      const double steps = (point[axis] - low[axis]) / finest;
      if (steps != std::floor(steps)) return finest;
      bits |= static_cast<std::uint32_t>(steps);
    }
  }
  return bits == 0 ? finest : std::ldexp(finest, std::countr_zero(bits));
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
  const glm::dvec3 sides = high - low;
  const double size = std::max({sides.x, sides.y, sides.z});
  if (size == 0) return;
  step = common_step(points, low, std::exp2(std::ceil(std::log2(size / kMostSteps))));
  steps = at(high);
}

GridPoint PageGrid::at(const glm::dvec3& point) const {
  GridPoint result{};
  for (int axis = 0; axis < 3; ++axis) {
    const double nearest = std::clamp(std::round((point[axis] - low[axis]) / step), 0.0, kMostSteps);
    result[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(nearest);
  }
  return result;
}

PageModel::PageModel(const culler::Hierarchy& hierarchy, std::size_t most)
    : grid_(hierarchy.soup().vertices), place_(hierarchy.soup().size(), kNone) {
  const culler::SoupView soup = hierarchy.soup();
  const std::vector<bool> is_chosen = largest(soup, most);
  Vertices vertices;
  Bytes leaf_sizes, sides, corners, numbers;
  std::int64_t number_before = 0;
  std::vector<std::uint32_t> leaf;
  const auto add = [&](std::uint32_t p) {
    place_[p] = static_cast<std::uint32_t>(polygons_++);
    numbers.difference(hierarchy.face(p) - number_before);
    number_before = hierarchy.face(p);
    sides.number(2 * soup.loop(p).size() + (soup.is_opaque(p) ? 0 : 1));
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

std::pair<std::uint32_t, std::uint32_t> PageModel::leaves_of(const culler::PolygonRange& polygons) const {
  const auto first = std::ranges::lower_bound(leaf_first_, polygons.first);
  const auto end = std::ranges::lower_bound(first, leaf_first_.end(), polygons.first + polygons.count);
  return {static_cast<std::uint32_t>(first - leaf_first_.begin()), static_cast<std::uint32_t>(end - first)};
}

std::uint32_t PageModel::leaf_of(std::uint32_t p) const {
  return static_cast<std::uint32_t>(std::ranges::upper_bound(leaf_first_, p) - leaf_first_.begin() - 1);
}

}  // namespace occlude::render
