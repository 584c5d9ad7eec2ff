// SPDX-License-Identifier: MIT
#include "simplify/inset_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "frusta/closed_parts.h"
#include "frusta/solid.h"
#include "model/adjacency.h"
#include "model/bounds.h"
#include "occlude/kernel/orientation.h"
#include "occlude/kernel/validity.h"
#include "simplify/flat_mesh.h"
#include "simplify/triangles_apart.h"

namespace occlude::culler {
namespace {

using kernel::Vec3;

/// How much farther inwards a plane is moved than it must be, over the largest coordinate: what rounding may move a corner
/// by, with some bits to spare.
constexpr double kSpare = 0x1p-47;
/// Planes that meet at right angles are met at once, others within a few times.
constexpr int kRounds = 30;
/// No closed surface has fewer triangles, but one that lies on itself.
constexpr std::size_t kLeastPart = 4;
/// Triangles of a region turn by less than 60 degrees against the first of them.
constexpr double kLeastCosine = 0.5;

/// The points x with normal . x <= offset.
struct Inner {
  glm::dvec3 normal;
  double offset;
};

/// A part as triangles of different corners, and regions of it that are nearly flat.
class Regions {
 public:
  Regions(SoupView soup, std::span<const std::uint32_t> weld, std::span<const std::uint32_t> polygons, double inset)
      : inset_(inset) {
    for (const std::uint32_t p : polygons) {
      const auto loop = soup.loop(p);
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        add(soup, {weld[loop[0]], weld[loop[i]], weld[loop[i + 1]]});
      }
    }
    region_.assign(part_.size(), kNone);
    find_neighbours();
    std::vector<std::uint32_t> order(part_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::uint32_t t) { return area_[t]; });
    for (const std::uint32_t t : order) {
      if (region_[t] == kNone) grow_from(t);
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> of_triangles() const { return region_; }

  /// The part, each corner moved to where the planes of its regions meet.
  [[nodiscard]] PolygonSoup moved() const {
    std::vector<std::vector<std::uint32_t>> at(part_.vertices.size());
    for (std::uint32_t t = 0; t < part_.size(); ++t) {
      for (const std::uint32_t v : part_.loop(t)) at[v].push_back(region_[t]);
    }
    PolygonSoup result = part_;
    for (std::size_t v = 0; v < at.size(); ++v) {
      std::ranges::sort(at[v]);
      at[v].erase(std::unique(at[v].begin(), at[v].end()), at[v].end());
      glm::dvec3& x = result.vertices[v];
      for (int round = 0; round < kRounds; ++round) {
        for (const std::uint32_t r : at[v]) {
          x -= std::max(glm::dot(planes_[r].normal, x) - planes_[r].offset, 0.0) * planes_[r].normal;
        }
      }
      for (int axis = 0; axis < 3; ++axis) x[axis] = kernel::flushed(x[axis]);
    }
    return result;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  void add(SoupView soup, const FaceTriangle& corners) {
    const auto at = [&](std::size_t i) { return soup.vertices[corners[i]]; };
    const glm::dvec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
    const double area = glm::length(normal);
    if (!(area > 0)) return;
    std::array<std::uint32_t, 3> own{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [found, is_new] = numbers_.try_emplace(corners[i], 0U);
      if (is_new) found->second = part_.add_vertex(at(i));
      own[i] = found->second;
      for (int axis = 0; axis < 3; ++axis) most_ = std::max(most_, std::fabs(at(i)[axis]));
    }
    part_.add_polygon(own);
    normal_.push_back(normal / area);
    area_.push_back(area);
  }

  void find_neighbours() {
    struct Side {
      std::uint32_t low, high, side;
      auto operator<=>(const Side&) const = default;
    };
    std::vector<Side> sides;
    for (std::uint32_t t = 0; t < part_.size(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(part_.loop(t)[i], part_.loop(t)[(i + 1) % 3]);
        sides.push_back({low, high, 3 * t + i});
      }
    }
    std::ranges::sort(sides);
    neighbour_.assign(sides.size(), kNone);
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
      if (end - i != 2) continue;
      neighbour_[sides[i].side] = sides[i + 1].side / 3;
      neighbour_[sides[i + 1].side] = sides[i].side / 3;
    }
  }

  void grow_from(std::uint32_t first) {
    const auto number = static_cast<std::uint32_t>(planes_.size());
    const glm::dvec3 normal = normal_[first];
    const double level = glm::dot(normal, part_.vertices[part_.loop(first)[0]]);
    std::vector<std::uint32_t> found{first};
    region_[first] = number;
    for (std::size_t k = 0; k < found.size(); ++k) {
      for (std::uint32_t side = 3 * found[k]; side < 3 * found[k] + 3; ++side) {
        const std::uint32_t t = neighbour_[side];
        if (t == kNone || region_[t] != kNone || !(glm::dot(normal, normal_[t]) > kLeastCosine)) continue;
        const auto is_near = [&](std::uint32_t v) {
          return std::fabs(glm::dot(normal, part_.vertices[v]) - level) <= inset_ / 2;
        };
        if (!std::ranges::all_of(part_.loop(t), is_near)) continue;
        region_[t] = number;
        found.push_back(t);
      }
    }
    planes_.push_back(plane_before(found));
  }

  /// The plane across the mean normal of triangles that has them all beyond it.
  [[nodiscard]] Inner plane_before(std::span<const std::uint32_t> triangles) const {
    glm::dvec3 sum(0);
    for (const std::uint32_t t : triangles) sum += area_[t] * normal_[t];
    const glm::dvec3 normal = glm::normalize(sum);
    double lowest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t t : triangles) {
      for (const std::uint32_t v : part_.loop(t)) lowest = std::min(lowest, glm::dot(normal, part_.vertices[v]));
    }
    return {normal, lowest - kSpare * most_};
  }

  double inset_, most_ = 0;
  PolygonSoup part_;
  std::map<std::uint32_t, std::uint32_t> numbers_;  ///< of corners in the part, by those in the soup
  std::vector<glm::dvec3> normal_;                  ///< of each triangle
  std::vector<double> area_;
  std::vector<std::uint32_t> neighbour_, region_;
  std::vector<Inner> planes_;
};

bool has_area(const SolidTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return kernel::turn(0, a, b, c) != 0 || kernel::turn(1, a, b, c) != 0 || kernel::turn(2, a, b, c) != 0;
}

bool is_proven(const Solid& solid, const SolidTriangle& triangle) {
  const auto is_legal = [](const Vec3& v) { return kernel::check(v) == kernel::Refusal::none; };
  const auto is_apart = [&](const SolidTriangle& of_part) { return are_apart(triangle, of_part); };
  return std::ranges::all_of(triangle.corners, is_legal) && has_area(triangle) &&
         std::ranges::all_of(solid.triangles, is_apart) && is_inside(solid, triangle.corners[0]);
}

std::vector<std::array<glm::dvec3, 3>> triangles_in(SoupView soup, std::span<const std::uint32_t> weld,
                                                    std::span<const std::uint32_t> polygons, double inset, std::size_t most,
                                                    const Checkpoint& checkpoint) {
  const Regions regions(soup, weld, polygons, inset);
  const PolygonSoup moved = regions.moved();
  FlatMesh mesh(moved, regions.of_triangles(), checkpoint);
  mesh.simplify(checkpoint);
  if (mesh.size() > most) return {};
  const Solid solid(soup, polygons);
  std::vector<std::array<glm::dvec3, 3>> result;
  for (const FlatTriangle& triangle : mesh.triangles()) {
    checkpoint();
    SolidTriangle own{{}, empty_box()};
    for (std::size_t i = 0; i < 3; ++i) {
      own.corners[i] = to_kernel(moved.vertices[triangle.corners[i]]);
      grow(own.box, own.corners[i]);
    }
    if (!is_proven(solid, own)) return {};
    result.push_back({to_glm(own.corners[0]), to_glm(own.corners[1]), to_glm(own.corners[2])});
  }
  return result;
}

}  // namespace

std::vector<InsetPart> inset_parts(SoupView soup, double inset, std::span<const std::size_t> needed,
                                   const Checkpoint& checkpoint) {
  const std::vector<std::uint32_t> weld = welded(soup.vertices, checkpoint);
  std::vector<std::vector<std::uint32_t>> parts = find_parts(soup, weld, checkpoint);
  std::vector<InsetPart> results(parts.size());
  const auto work = [&](std::size_t i) {
    std::size_t all = 0;
    for (const std::uint32_t p : parts[i]) all += needed[p];
    if (all / 2 < kLeastPart || !is_closed(soup, weld, parts[i])) return;
    results[i].triangles = triangles_in(soup, weld, parts[i], inset, all / 2, checkpoint);
    results[i].polygons = std::move(parts[i]);
  };
  parallel_for(parts.size(), work, checkpoint);
  std::erase_if(results, [](const InsetPart& part) { return part.triangles.empty(); });
  return results;
}

}  // namespace occlude::culler
