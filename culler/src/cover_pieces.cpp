// SPDX-License-Identifier: MIT
#include "cover_pieces.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "bounds.h"
#include "disjoint_sets.h"
#include "occlude/culler/adjacency.h"
#include "parallel_sort.h"

namespace occlude::culler {
namespace {

/// Of polygons about a mesh: one of more sides is not among them, nor are those at a corner where more meet, nor what would
/// make them more than so many triangles for each of its own. So all meshes together are at most nine times the model.
constexpr std::size_t kMostSides = 64, kMostAtCorner = 64, kMostAround = 8;

/// A surface is closed, or nearly so, when at most this share of its edges is not between two polygons turned alike, and of
/// its area is not made up for by what is turned the other way.
constexpr double kOpenShare = 0.25;

/// An edge along which a polygon goes.
struct Side {
  std::uint32_t from, to;  ///< from < to
  std::uint32_t polygon;   ///< or triangle
  bool ascends;

  [[nodiscard]] bool is_along(const Side& other) const { return from == other.from && to == other.to; }
  auto operator<=>(const Side&) const = default;
};

Side side(std::uint32_t a, std::uint32_t b, std::uint32_t polygon) {
  return {std::min(a, b), std::max(a, b), polygon, a < b};
}

/// Which polygons have a vertex.
class Incidence {
 public:
  Incidence(const PolygonSoup& soup, std::span<const std::uint32_t> weld)
      : first_(soup.vertices.size() + 1), polygons_(soup.indices.size()) {
    for (const std::uint32_t v : soup.indices) ++first_[weld[v] + std::size_t{1}];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t p = 0; p < soup.size(); ++p) {
      for (const std::uint32_t v : soup.loop(p)) polygons_[next[weld[v]]++] = p;
    }
  }
  [[nodiscard]] std::span<const std::uint32_t> polygons_at(std::uint32_t vertex) const {
    return std::span(polygons_).subspan(first_[vertex], first_[vertex + std::size_t{1}] - first_[vertex]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> polygons_;
};

/// What tells whether a surface is closed and turned outwards.
struct Surface {
  std::uint32_t edges = 0, open_edges = 0;
  double area = 0, volume = 0;  ///< some times as much
  glm::dvec3 turned{0, 0, 0};   ///< the sum of its areas along their normals: 0 of a closed one

  [[nodiscard]] bool is_closed() const {
    return open_edges <= kOpenShare * edges && glm::length(turned) <= kOpenShare * area && volume > 0;
  }
};

/// Of each polygon whether the surface that it is connected to is closed, or nearly so, and turned outwards: up to rounding.
std::vector<bool> find_closed(const PolygonSoup& soup, std::span<const std::uint32_t> weld, const Checkpoint& checkpoint) {
  DisjointSets surfaces(soup.vertices.size());
  std::vector<Side> sides;
  sides.reserve(soup.indices.size());
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    checkpoint.at(p);
    const auto loop = soup.loop(p);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = weld[loop[i]], b = weld[loop[(i + 1) % loop.size()]];
      if (a == b) continue;
      sides.push_back(side(a, b, p));
      const std::uint32_t one = surfaces.find(a), other = surfaces.find(b);
      if (one != other) surfaces.join(std::min(one, other), std::max(one, other));
    }
  }
  parallel_sort(sides, checkpoint);
  std::vector<Surface> all(soup.vertices.size());
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    checkpoint.at(i);
    int sum = 0;
    for (; end < sides.size() && sides[end].is_along(sides[i]); ++end) sum += sides[end].ascends ? 1 : -1;
    Surface& surface = all[surfaces.find(sides[i].from)];
    ++surface.edges;
    if (sum != 0) ++surface.open_edges;
  }
  const auto surface_of = [&](std::uint32_t p) { return surfaces.find(weld[soup.loop(p)[0]]); };
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    const std::uint32_t id = surface_of(p);
    Surface& surface = all[id];
    const glm::dvec3 turned = doubled_area(soup, soup.loop(p));
    surface.area += glm::length(turned);
    surface.turned += turned;
    surface.volume += glm::dot(turned, soup.vertices[soup.loop(p)[0]] - soup.vertices[id]);
  }
  std::vector<bool> result(soup.size());
  for (std::uint32_t p = 0; p < soup.size(); ++p) result[p] = all[surface_of(p)].is_closed();
  return result;
}

}  // namespace

class CoverPieces::Finder {
 public:
  Finder(const PolygonSoup& soup, CoverPieces& result, const Checkpoint& checkpoint)
      : soup_(soup),
        result_(result),
        weld_(welded(soup.vertices, checkpoint)),
        incidence_(soup, weld_),
        is_closed_(find_closed(soup, weld_, checkpoint)),
        taken_by_(soup.size(), kNone) {
    result.mesh_of_.resize(soup.size());
  }

  /// Makes the mesh of the polygons from `first` on.
  void add(std::uint32_t first, std::uint32_t count) {
    polygons_.clear();
    const auto mesh = static_cast<std::uint32_t>(result_.size());
    for (std::uint32_t p = first; p < first + count; ++p) {
      result_.mesh_of_[p] = mesh;
      take(p);
    }
    add_around(first, count);
    append_triangles();
    append_edges();
    result_.begins_.push_back(
        {result_.vertices_.size(), result_.triangles_.size(), result_.edges_.size(), result_.uses_.size()});
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  void take(std::uint32_t polygon) {
    taken_by_[polygon] = static_cast<std::uint32_t>(result_.size());
    polygons_.push_back(polygon);
  }

  void add_around(std::uint32_t first, std::uint32_t count) {
    std::size_t left = kMostAround * (soup_.first[first + count] - soup_.first[first] - 2 * std::size_t{count});
    for (std::uint32_t p = first; p < first + count; ++p) {
      for (const std::uint32_t v : soup_.loop(p)) {
        const auto at_corner = incidence_.polygons_at(weld_[v]);
        if (at_corner.size() > kMostAtCorner) continue;
        for (const std::uint32_t other : at_corner) {
          if (taken_by_[other] == result_.size() || soup_.loop(other).size() > kMostSides) continue;
          if (soup_.triangles(other) > left) return;
          left -= soup_.triangles(other);
          take(other);
        }
      }
    }
  }

  /// The fans of the polygons, without triangles that have a corner twice.
  void append_triangles() {
    corners_.clear();
    for (const std::uint32_t p : polygons_) {
      for (const std::uint32_t v : soup_.loop(p)) corners_.push_back(weld_[v]);
    }
    std::ranges::sort(corners_);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    for (const std::uint32_t v : corners_) result_.vertices_.push_back(soup_.vertices[v]);
    const auto own = [&](std::uint32_t v) {
      return static_cast<std::uint32_t>(std::ranges::lower_bound(corners_, weld_[v]) - corners_.begin());
    };
    for (const std::uint32_t p : polygons_) {
      const auto loop = soup_.loop(p);
      const std::uint32_t a = own(loop[0]);
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const std::uint32_t b = own(loop[i]), c = own(loop[i + 1]);
        if (a == b || b == c || c == a) continue;
        result_.triangles_.push_back({a, b, c});
        result_.polygons_.push_back(p);
        result_.is_closed_.push_back(is_closed_[p] ? 1 : 0);
      }
    }
  }

  void append_edges() {
    const std::size_t first = result_.begins_.back().triangle;
    sides_.clear();
    for (std::size_t t = first; t < result_.triangles_.size(); ++t) {
      const CoverMesh::Triangle& corners = result_.triangles_[t];
      for (std::size_t i = 0; i < 3; ++i) {
        sides_.push_back(side(corners[i], corners[(i + 1) % 3], static_cast<std::uint32_t>(t - first)));
      }
    }
    std::ranges::sort(sides_);
    for (std::size_t i = 0, end = 0; i < sides_.size(); i = end) {
      for (; end < sides_.size() && sides_[end].is_along(sides_[i]); ++end) {
        result_.uses_.push_back({sides_[end].polygon & 0x7FFFFFFFU, sides_[end].ascends ? 1U : 0U});
      }
      result_.edges_.push_back(
          {sides_[i].from, sides_[i].to, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(end)});
    }
  }

  const PolygonSoup& soup_;
  CoverPieces& result_;
  const std::vector<std::uint32_t> weld_;
  const Incidence incidence_;
  const std::vector<bool> is_closed_;
  std::vector<std::uint32_t> taken_by_;  ///< of each polygon, the last mesh that it is in
  std::vector<std::uint32_t> polygons_;  ///< of the mesh that is being made
  std::vector<std::uint32_t> corners_;
  std::vector<Side> sides_;
};

CoverPieces CoverPieces::find(const PolygonSoup& soup, std::span<const HierarchyNode> nodes, const Checkpoint& checkpoint) {
  CoverPieces result;
  Finder finder(soup, result, checkpoint);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    checkpoint.at(n);
    const HierarchyNode& node = nodes[n];
    if (node.count > kMost && !node.is_leaf()) continue;
    finder.add(node.first, node.count);
    while (n + 1 < nodes.size() && nodes[n + 1].first < node.first + node.count) ++n;  // what is below it
  }
  return result;
}

CoverMesh CoverPieces::operator[](std::size_t mesh) const {
  const Begin &begin = begins_[mesh], &end = begins_[mesh + 1];
  const auto part = [](const auto& all, std::size_t from, std::size_t to) {
    return std::span(all).subspan(from, to - from);
  };
  return {.vertices = part(vertices_, begin.vertex, end.vertex),
          .triangles = part(triangles_, begin.triangle, end.triangle),
          .edges = part(edges_, begin.edge, end.edge),
          .uses = part(uses_, begin.use, end.use),
          .is_closed = part(is_closed_, begin.triangle, end.triangle)};
}

}  // namespace occlude::culler
