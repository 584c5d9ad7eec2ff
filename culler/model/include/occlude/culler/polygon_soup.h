// SPDX-License-Identifier: MIT
// The model: an arbitrary set of polygons without adjacency, as section 3 of the paper takes it; and faces of any shape, as
// what a soup draws. Reading order: 1.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// A run of polygons [first, first + count).
struct PolygonRange {
  std::uint32_t first = 0, count = 0;

  friend bool operator==(const PolygonRange&, const PolygonRange&) = default;
};

/// For each of `count` polygons, whether it is in one of the ranges. REQUIRES: no range ends beyond `count`.
[[nodiscard]] std::vector<bool> polygons_of(std::span<const PolygonRange> ranges, std::size_t count);

/// Polygons as loops of vertex indices, where they lie. Polygon p is drawn as the fan of triangles (v0, vi, vi+1) of its
/// loop, whatever its shape: faces that may be concave or have openings are for PolygonSoup::add_face(). Both sides are
/// opaque, unless it is see-through: then it hides nothing, and is hidden as all others are. Coordinates are doubles in the
/// model's own units, right-handed, Z up by convention of the tools.
///
/// A soup is well formed if
/// 1. `first` begins with 0, never descends and ends with indices.size();
/// 2. each polygon has at least three corners, which may repeat;
/// 3. all indices are below vertices.size();
/// 4. `faces` is empty, or has a number for each polygon: 0, and then the one before it or the next;
/// 5. `see_through` is empty, or has 0 or 1 for each polygon.
/// Culler, OccluderMesh, preprocess(), find_inner_boxes() and simplified_occluders() refuse a soup that is not; everything
/// else REQUIRES that it is. Polygon numbers are not checked.
struct SoupView {
  /// `first` where there is no polygon.
  static constexpr std::array<std::uint32_t, 1> kNoPolygon = {0};

  std::span<const glm::dvec3> vertices;
  std::span<const std::uint32_t> indices;             ///< the loops of all polygons, one after another
  std::span<const std::uint32_t> first = kNoPolygon;  ///< polygon p owns indices [first[p], first[p + 1])
  std::span<const std::uint32_t> faces = {};          ///< the face of which polygon p is a piece; empty: each is a face
  std::span<const std::uint8_t> see_through = {};     ///< 1 where polygon p hides nothing; empty: nowhere

  /// The face that polygon p is, or of which it is a piece.
  [[nodiscard]] std::uint32_t face(std::size_t p) const { return faces.empty() ? static_cast<std::uint32_t>(p) : faces[p]; }
  [[nodiscard]] bool is_opaque(std::size_t p) const { return see_through.empty() || see_through[p] == 0; }

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] PolygonRange all() const { return {0, static_cast<std::uint32_t>(size())}; }

  /// The vertex indices of polygon p, in loop order.
  [[nodiscard]] std::span<const std::uint32_t> loop(std::size_t p) const {
    return indices.subspan(first[p], first[p + 1] - first[p]);
  }
  /// Number of triangles in the fan of polygon p.
  [[nodiscard]] std::size_t triangles(std::size_t p) const { return first[p + 1] - first[p] - 2; }

  /// The smallest axis-aligned box that holds polygon p.
  [[nodiscard]] kernel::Aabb box(std::size_t p) const;
};

/// Whether the soup is well formed.
[[nodiscard]] bool is_well_formed(SoupView soup, const Checkpoint& checkpoint = {});

/// How a face is drawn.
enum class FaceShape {
  fan,       ///< as one polygon
  pieces,    ///< as triangles: its fan would leave it
  crossing,  ///< as the fan of its loop, and see-through: it crosses itself, or its triangles take too long to find
};

/// A soup that grows: the arrays of SoupView, in memory of its own. An empty one has no polygon.
struct PolygonSoup {
  std::vector<glm::dvec3> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> first = {0};
  std::vector<std::uint32_t> faces;
  std::vector<std::uint8_t> see_through;

  /// What reads a soup takes this one as well, as long as it is there and does not grow.
  operator SoupView() const { return {vertices, indices, first, faces, see_through}; }  // NOLINT: the same polygons

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] PolygonRange all() const { return SoupView(*this).all(); }
  [[nodiscard]] std::span<const std::uint32_t> loop(std::size_t p) const { return SoupView(*this).loop(p); }
  [[nodiscard]] std::size_t triangles(std::size_t p) const { return SoupView(*this).triangles(p); }
  [[nodiscard]] kernel::Aabb box(std::size_t p) const { return SoupView(*this).box(p); }
  [[nodiscard]] std::uint32_t face(std::size_t p) const { return SoupView(*this).face(p); }
  [[nodiscard]] bool is_opaque(std::size_t p) const { return SoupView(*this).is_opaque(p); }
  [[nodiscard]] std::size_t face_count() const { return empty() ? 0 : face(size() - 1) + std::size_t{1}; }

  /// Adds a vertex and returns its index. Throws std::length_error, and adds nothing, if 32 bits cannot hold the index.
  std::uint32_t add_vertex(const glm::dvec3& v) {
    const std::uint32_t index = narrowed(vertices.size());
    vertices.push_back(v);
    return index;
  }
  /// Adds a polygon over existing vertices that is drawn as its fan, and is a face. Throws std::length_error, and adds
  /// nothing, if 32 bits cannot hold the number of all indices. REQUIRES, not checked: at least three indices, all below
  /// vertices.size().
  void add_polygon(std::span<const std::uint32_t> polygon) {
    const std::uint32_t end = narrowed(indices.size() + polygon.size());
    for (const std::uint32_t index : polygon) indices.push_back(index);  // faster than insert(): polygons are short
    first.push_back(end);
    if (!faces.empty()) faces.push_back(faces.back() + 1);
    if (!see_through.empty()) see_through.push_back(0);
  }
  /// Adds a face of any shape (below) over existing vertices: as one polygon, or as several that are its pieces. Throws and
  /// REQUIRES as add_polygon(), and legal coordinates.
  FaceShape add_face(std::span<const std::uint32_t> loop) {
    if (loop.size() > 3) return add_large_face(loop);
    add_polygon(loop);
    return FaceShape::fan;
  }
  /// Makes the polygons from `p` on see-through.
  void see_through_from(std::size_t p);
  /// Adds the box from `low` to `high` as six quadrilaterals over eight vertices of its own, counter-clockwise from outside.
  /// Throws as the two above.
  void add_box(const glm::dvec3& low, const glm::dvec3& high);

  /// The same number in 32 bits. Throws std::length_error if it does not fit.
  [[nodiscard]] static std::uint32_t narrowed(std::size_t number);

 private:
  FaceShape add_large_face(std::span<const std::uint32_t> loop);
};

/// A soup that copies share.
struct SharedSoup {
  SoupView view;
  std::shared_ptr<const void> keep;  ///< what the view refers to is there as long as this is

  SharedSoup() = default;
  SharedSoup(const SoupView& soup, std::shared_ptr<const void> kept) : view(soup), keep(std::move(kept)) {}
  /// Takes the soup.
  explicit SharedSoup(PolygonSoup soup) {
    auto owned = std::make_shared<const PolygonSoup>(std::move(soup));
    view = *owned;
    keep = std::move(owned);
  }
};

// A face is a loop of vertices, its corners: each is joined to the next by an edge, and the last to the first. It lies in a
// plane, or nearly. It may be concave, and its edges may touch. An opening is joined to the outline by an edge that is
// passed twice, a keyhole. Corners may repeat or lie on a line with their neighbours.
//
// What is said of a face below holds in its picture: the face as it is seen along the coordinate axis that is closest to its
// normal. A corner there is where it is in the file, so all of this is exact. A face whose corners do not lie in a plane is
// the surface of its triangles.
//
// REQUIRES, here and below: all indices of the loop are below vertices.size(); legal coordinates, and rounding to nearest
// (occlude/kernel/validity.h).

/// The vertices of a triangle.
using FaceTriangle = std::array<std::uint32_t, 3>;

/// Triangles that are the face:
/// 1. their corners are the face's;
/// 2. none is turned over;
/// 3. their directed edges are those of the loop, once each, and others, once in each direction (but for triangles without
///    area and edges without length, which are left out).
/// So they cover each point as often as the loop winds round it: once inside of a face, not at all outside and in openings.
/// None where the loop winds round a point the other way, as it does where a face crosses itself; for some loops that cross
/// themselves and wind one way everywhere; and where finding them would take more than kFaceWork steps a corner.
[[nodiscard]] std::optional<std::vector<FaceTriangle>> triangles_of_face(std::span<const glm::dvec3> vertices,
                                                                         std::span<const std::uint32_t> loop);

/// Whether the fan (v0, vi, vi+1) of the loop is the face in the same sense. It always has properties 1 and 3.
[[nodiscard]] bool fan_is_face(std::span<const glm::dvec3> vertices, std::span<const std::uint32_t> loop);

/// Enough for faces with a hundred concave corners of any shape, and for outlines of 100,000 corners like those of coasts. A
/// step takes some three nanoseconds, so a face costs at most about 10 us a corner.
inline constexpr std::uint64_t kFaceWork = 4096;

}  // namespace occlude::culler
