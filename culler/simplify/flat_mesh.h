// SPDX-License-Identifier: MIT
// The triangles of a soup, joined where they are exactly flat, and what is left of them without needless vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// A triangle, and one of the polygons on which it lies.
struct FlatTriangle {
  FaceTriangle corners;
  std::uint32_t polygon;
};

/// Half-edge 3 t + i goes from corner i of triangle t to the next. Corners with equal coordinates are one vertex.
class FlatMesh {
 public:
  /// The triangles with area of the fans of all opaque polygons that repeat none. REQUIRES: a legal soup, which is there as
  /// long as this is.
  FlatMesh(SoupView soup, const Checkpoint& checkpoint) : FlatMesh(soup, {}, checkpoint) {}
  /// The same, where not flat is what lies in a plane, but polygons of one region, and straight where the same regions meet.
  FlatMesh(SoupView soup, std::span<const std::uint32_t> regions, const Checkpoint& checkpoint);

  /// Takes out vertices in flat regions and on straight borders of them, as SimplifiedOccluders says.
  void simplify(const Checkpoint& checkpoint);

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::vector<FlatTriangle> triangles() const;

 private:
  using Vertex = std::uint32_t;
  using HalfEdge = std::uint32_t;
  struct Fan;

  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  [[nodiscard]] Vertex from(HalfEdge h) const { return triangles_[h / 3].corners[h % 3]; }
  [[nodiscard]] Vertex to(HalfEdge h) const { return from(next(h)); }
  [[nodiscard]] static HalfEdge next(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static HalfEdge before(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] bool is_gone(std::uint32_t t) const { return triangles_[t].polygon == kNone; }

  void join(const Checkpoint& checkpoint);
  void join_edge(std::span<const HalfEdge> sides);
  [[nodiscard]] bool is_flat(HalfEdge g, HalfEdge h) const;
  [[nodiscard]] int turn(int axis, Vertex a, Vertex b, Vertex c) const;
  [[nodiscard]] std::uint32_t region(HalfEdge h) const { return regions_[triangles_[h / 3].polygon]; }
  [[nodiscard]] bool is_between(Vertex a, Vertex v, Vertex b) const;

  void put(std::uint32_t t, const FlatTriangle& triangle);
  void remove(std::uint32_t t);
  [[nodiscard]] std::vector<HalfEdge> leaving(Vertex v);
  [[nodiscard]] Fan fan_from(HalfEdge h) const;
  [[nodiscard]] bool may_go(Vertex v, std::span<const Fan> fans) const;
  [[nodiscard]] bool take_out(Vertex v, std::vector<Vertex>& around);
  void replace(const Fan& fan, std::span<const FaceTriangle> triangles);

  std::span<const glm::dvec3> vertices_;
  std::span<const std::uint32_t> regions_;  ///< of polygons; empty: planes decide
  std::vector<FlatTriangle> triangles_;
  std::vector<HalfEdge> twins_;                 ///< the other half of a joined edge; else kNone
  std::vector<std::vector<std::uint32_t>> at_;  ///< of each vertex, its triangles, and perhaps such as were
  std::vector<std::uint32_t> counts_;           ///< of each vertex, how many triangles it has
};

}  // namespace occlude::culler
