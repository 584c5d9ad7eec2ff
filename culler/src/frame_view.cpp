// SPDX-License-Identifier: MIT
#include "frame_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "bounds.h"
#include "negligible.h"
#include "occlude/kernel/validity.h"
#include "single_precision.h"

namespace occlude::culler {
namespace {

/// The same half-space, or a slightly larger one, in numbers that are legal for the kernel. Coordinates up to 2^100 have
/// offsets up to 2^103, and what is left of an offset after cancellation may be arbitrarily small.
HalfSpace legal(const glm::dvec3& normal, double offset) {
  if (std::fabs(offset) > kernel::kMaxMagnitude) return {normal * 0x1p-4, offset * 0x1p-4};
  if (offset != 0 && std::fabs(offset) < kernel::kMinMagnitude) return {normal, kernel::kMinMagnitude};
  return {normal, offset};
}

/// The half-space beyond `point` in the direction `inward`. It is moved outwards by the margin and by more than its offset
/// is rounded by: three products |normal_k| |point_k|, each with at most four roundings and a dropped coefficient. The
/// roundings of the normal tilt the plane at `depth` by far less than the margin.
HalfSpace half_space(const glm::dvec3& inward, const glm::dvec3& point, double depth) {
  const glm::dvec3 normal = without_negligible(inward / glm::length(inward));
  const double size = std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z);
  return legal(normal, -glm::dot(normal, point) + 0x1p-48 * size + kDepthMargin * depth);
}

}  // namespace

FrameView::FrameView(const Camera& of, double reach)
    : camera(of),
      depth(reach),
      axes(of.axes()),
      viewpoint(of.viewpoint()),
      half_height(of.projection == Projection::perspective ? std::tan(glm::radians(of.fov_y_deg) / 2) : of.height / 2),
      near(of.near + kDepthMargin * reach) {}

void FrameView::append_half_spaces(std::vector<HalfSpace>& planes) const {
  const auto& [right, up, forward] = axes;
  const auto append = [&](const glm::dvec3& inward, const glm::dvec3& point) {
    planes.push_back(half_space(inward, point, depth));
  };
  const double y = half_height, x = y * camera.aspect;
  for (const auto& [half, across] : {std::pair{x, right}, {x, -right}, {y, up}, {y, -up}}) {
    if (camera.projection == Projection::perspective) {
      append(half * forward + across, camera.eye);
    } else {
      append(across, camera.eye - half * across);
    }
  }
  append(forward, camera.eye + camera.near * forward);
  if (std::isfinite(camera.far)) append(-forward, camera.eye + camera.far * forward);
}

bool FrameView::may_clip(std::span<const kernel::Vec3> vertices) const {
  return std::ranges::any_of(vertices,
                             [&](const kernel::Vec3& v) { return glm::dot(to_glm(v) - camera.eye, axes.forward) < near; });
}

}  // namespace occlude::culler
