// SPDX-License-Identifier: MIT
// What rays of a frame meet in the whole model: quickly in doubles, which may err by rounding, and exactly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "camera_picture.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/oracle/ray.h"

namespace occlude::cli {

/// Polygons are those of the tree. Const calls may run on several threads at once.
class FrameRays {
 public:
  /// `culled` tells which polygons the frame's culler culled. REQUIRES: both outlive this object; the camera has no fault.
  FrameRays(const culler::Hierarchy& hierarchy, const proof::AnyCamera& camera, const std::vector<bool>& culled);

  /// The part of a triangle in the picture, up to rounding; empty if there is none.
  [[nodiscard]] std::vector<glm::dvec3> in_picture(const oracle::Triangle& triangle) const;

  /// Where a line meets the polygon, up to rounding.
  [[nodiscard]] std::optional<glm::dvec3> where(const glm::dvec3& from, const glm::dvec3& along,
                                                std::uint32_t polygon) const;

  /// Whether nothing opaque seems to be before a point of the polygon. `hider` is one to try first, and becomes the one
  /// that was found.
  [[nodiscard]] bool seems_clear(const glm::dvec3& point, std::uint32_t polygon, std::uint32_t& hider) const;

  /// Whether the ray through the point meets the polygon within the borders of one of its triangles, in the picture, and
  /// before that no opaque polygon beyond the near plane; and at the same place none that was drawn. Decided exactly.
  [[nodiscard]] bool shows(const glm::dvec3& point, std::uint32_t polygon) const;

 private:
  struct Segment {
    glm::dvec3 from, along;
    double first;  ///< the share of it that is before the near plane
  };
  [[nodiscard]] Segment segment_to(const glm::dvec3& point) const;
  [[nodiscard]] static Segment reaching(const Segment& segment, const oracle::Triangle& triangle);
  /// Calls visit(polygon) for all opaque ones whose leaf the segment meets, or passes by less than rounding, until it
  /// returns true. Returns whether it did.
  template <class Visit>
  bool any_of(const Segment& segment, const Visit& visit) const;
  /// The share of the line at which it meets the polygon, not below `first`; NaN if it does not.
  [[nodiscard]] double meeting(const glm::dvec3& from, const glm::dvec3& along, double first, std::uint32_t polygon) const;

  const culler::Hierarchy& hierarchy_;
  const std::vector<bool>& culled_;
  oracle::Viewpoint view_;
  std::vector<oracle::HalfSpaceCoefficients> picture_;  ///< a little smaller than the camera's
  oracle::HalfSpaceCoefficients near_;                  ///< begins a little before the camera's
  double rounding_;                                     ///< more than coordinates of points on rays are off by
};

/// Calls f(triangle) for each triangle of the fan of a polygon.
template <class F>
void for_each_triangle(const culler::SoupView& soup, std::uint32_t polygon, const F& f) {
  const auto loop = soup.loop(polygon);
  const auto corner = [&](std::size_t i) {
    const glm::dvec3& v = soup.vertices[loop[i]];
    return oracle::Point{v.x, v.y, v.z};
  };
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) f(oracle::Triangle{corner(0), corner(i), corner(i + 1)});
}

}  // namespace occlude::cli
