// SPDX-License-Identifier: MIT
// What rays of a frame meet in the whole model: quickly in doubles, which may err by rounding, and exactly.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "camera_picture.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/oracle/ray.h"
#include "occlude/render/tree_rays.h"
#include "triangles.h"

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
  [[nodiscard]] static double end_at(const Segment& segment, const oracle::Triangle& triangle);

  const culler::Hierarchy& hierarchy_;
  render::TreeRays rays_;
  const std::vector<bool>& culled_;
  oracle::Viewpoint view_;
  std::vector<oracle::HalfSpaceCoefficients> picture_;  ///< a little smaller than the camera's
  oracle::HalfSpaceCoefficients near_;                  ///< begins a little before the camera's
};

}  // namespace occlude::cli
