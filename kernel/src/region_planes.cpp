// SPDX-License-Identifier: MIT
#include "region_planes.h"

#include <algorithm>

#include "plane_coefficients.h"

namespace occlude::kernel {
namespace {

Vec3 negative(const Vec3& v) { return {-v.x, -v.y, -v.z}; }

/// Sign at a corner of the region of a plane through `point` with the normal N: that of N . (corner - point), or for a
/// direction of view d of N . -d.
template <class Plane>
int sign_from(const Plane& plane, const Vec3& point, const RegionCorner& corner) {
  return certified([&]<class A>(A& arithmetic) { return -arithmetic.sign(dot(normal<A>(plane), sight<A>(corner, point))); });
}

int sign_at_point(const SightPlane& plane, const Vec3& x) {
  if (x == plane.point) return 0;
  return certified(
      [&]<class A>(A& arithmetic) { return arithmetic.sign(dot(normal<A>(plane), difference<A>(x, plane.point))); });
}

/// Makes the planes of one occluder for one region.
class Builder {
 public:
  Builder(const OccluderSurface& occluder, const ViewRegion& region, std::pmr::memory_resource& memory)
      : occluder_(occluder), corners_(corners_of(region, memory)), signs_(&memory), planes_(memory), region_(region) {
    signs_.reserve(occluder.faces.size() * corners_.size());
    for (const ExactPlane& face : occluder.faces) {
      for (const RegionCorner& corner : corners_) signs_.push_back(sign_at(face, corner));
    }
  }

  [[nodiscard]] RegionPlanes umbra() {
    for (std::uint32_t face = 0; face < occluder_.faces.size(); ++face) {
      if (is_turned_to_some(face)) planes_.near.emplace_back(occluder_.faces[face]);
    }
    for (const auto& [from, to, left, right] : occluder_.edges) {
      if (is_turned_to_some(left) == is_turned_to_some(right)) continue;
      // Seen from where it is turned, a face has the edge clockwise around it when the sides of its shadow face inwards.
      planes_.sides.emplace_back(is_turned_to_some(left) ? tightest(to, from, left) : tightest(from, to, right));
    }
    return std::move(planes_);
  }

  [[nodiscard]] RegionPlanes penumbra() {
    for (std::uint32_t face = 0; face < occluder_.faces.size(); ++face) {
      const auto [least, greatest] = std::ranges::minmax(signs_of(face));
      if (greatest < 0) planes_.near.emplace_back(occluder_.faces[face]);
      if (greatest == 0) planes_.sides.emplace_back(occluder_.faces[face]);
    }
    for (const auto& edge : occluder_.edges) add_at_edge(edge);
    for (const Vec3& vertex : occluder_.vertices) add_at_vertex(vertex);
    return std::move(planes_);
  }

 private:
  [[nodiscard]] std::span<const int> signs_of(std::uint32_t face) const {
    return std::span(signs_).subspan(face * corners_.size(), corners_.size());
  }
  [[nodiscard]] bool is_turned_to_some(std::uint32_t face) const { return std::ranges::min(signs_of(face)) < 0; }

  /// The side plane of an edge that is tightest beyond the turned face.
  [[nodiscard]] SightPlane tightest(const Vec3& from, const Vec3& to, std::uint32_t face) const {
    SightPlane best{{}, from, to, from};
    bool is_first = true;
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      if (signs_of(face)[c] >= 0) continue;
      if (is_first || sign_from(best, best.point, corners_[c]) < 0) best.corner = corners_[c];
      is_first = false;
    }
    return best;
  }

  [[nodiscard]] bool has_no_eye_within(const SightPlane& plane) const {
    return std::ranges::all_of(corners_,
                               [&](const RegionCorner& corner) { return sign_from(plane, plane.point, corner) <= 0; });
  }

  /// A plane through the edge and a corner touches the occluder if one of the two faces is turned to the corner. Where one
  /// is seen edge-on, it is the plane of that face.
  void add_at_edge(const OccluderSurface::Edge& edge) {
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      const int left = signs_of(edge.left)[c], right = signs_of(edge.right)[c];
      if (left * right >= 0) continue;
      const SightPlane plane = left < 0 ? SightPlane{corners_[c], edge.to, edge.from, edge.to}
                                        : SightPlane{corners_[c], edge.from, edge.to, edge.from};
      if (has_no_eye_within(plane)) planes_.sides.emplace_back(plane);
    }
  }

  void add_at_vertex(const Vec3& vertex) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& half_edge = region_.box.half_edges[k];
      if (half_edge == Vec3{}) continue;
      for (const RegionCorner& corner : corners_) {
        if (corner.moves[k] != half_edge) continue;  // of the two ends of the edge
        for (const Vec3& to : {half_edge, negative(half_edge)}) add_through({corner, vertex, to, {}});
      }
    }
  }

  /// Adds the plane if it separates the occluder from the region.
  void add_through(const SightPlane& plane) {
    int greatest = 0;
    for (const Vec3& vertex : occluder_.vertices) {
      const int sign = sign_at_point(plane, vertex);
      if (sign < 0) return;
      greatest = std::max(greatest, sign);
    }
    if (greatest > 0 && has_no_eye_within(plane)) planes_.sides.emplace_back(plane);
  }

  const OccluderSurface& occluder_;
  std::pmr::vector<RegionCorner> corners_;
  std::pmr::vector<int> signs_;  ///< of each face at each corner
  RegionPlanes planes_;
  const ViewRegion& region_;
};

}  // namespace

std::pmr::vector<RegionCorner> corners_of(const ViewRegion& region, std::pmr::memory_resource& memory) {
  std::pmr::vector<RegionCorner> corners(&memory);
  corners.push_back({region.kind == Viewpoint::Kind::eye, region.box.center, {}});
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& half_edge = region.box.half_edges[k];
    if (half_edge == Vec3{}) continue;
    const std::size_t size = corners.size();
    for (std::size_t i = 0; i < size; ++i) {
      corners.push_back(corners[i]);
      corners.back().moves[k] = half_edge;
      corners[i].moves[k] = negative(half_edge);
    }
  }
  return corners;
}

int sign_at(const ExactPlane& plane, const RegionCorner& corner) { return sign_from(plane, plane.origin, corner); }

RegionPlanes region_planes(const OccluderSurface& occluder, const ViewRegion& region, ShadowKind kind,
                           std::pmr::memory_resource& memory) {
  Builder builder(occluder, region, memory);
  return kind == ShadowKind::umbra ? builder.umbra() : builder.penumbra();
}

}  // namespace occlude::kernel
