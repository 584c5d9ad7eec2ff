// SPDX-License-Identifier: MIT
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

#include "camera/frame_view.h"
#include "camera/matrix_eye.h"
#include "model/bounds.h"
#include "occlude/culler/camera.h"

namespace occlude::culler {

MatrixCamera MatrixCamera::from_camera(const Camera& camera, ClipDepth depth, Nearer nearer) {
  if (const std::string reason = culler::fault(camera); !reason.empty()) throw std::invalid_argument(reason);
  const bool is_perspective = camera.projection == Projection::perspective;
  if (!is_perspective && std::isinf(camera.far_plane))
    throw std::invalid_argument("parallel rays without a far plane have no matrix");
  if (nearer == Nearer::unsaid) throw std::invalid_argument("which depths are nearer is not said");
  const auto [right, up, forward] = camera.axes();
  const double half = is_perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2;
  // How far a point is from the eye along an axis; and 1, both as functions of the point.
  const auto along = [&](const glm::dvec3& axis) { return glm::dvec4(axis, -glm::dot(axis, camera.eye)); };
  const glm::dvec4 distance = along(forward), one(0, 0, 0, 1);
  // The depth is w at the near plane and 0 at the far plane, and then the other way round if need be.
  const double near = camera.near_plane, far = camera.far_plane;
  const double share = near / (far - near);  // 0 without a far plane
  const glm::dvec4 w = is_perspective ? distance : one;
  glm::dvec4 z = is_perspective ? near * (1 + share) * one - share * distance : (far * one - distance) / (far - near);
  if (nearer == Nearer::less) z = w - z;
  if (depth == ClipDepth::minus_w_to_w) z = 2.0 * z - w;
  const glm::dmat4 rows(along(right) / (half * camera.aspect), along(up) / half, z, w);
  return {.matrix = glm::transpose(rows), .depth = depth, .nearer = nearer, .eyes = camera.eyes};
}

glm::dvec3 MatrixCamera::eye() const { return MatrixEye(*this).eye(); }

kernel::Viewpoint MatrixCamera::viewpoint() const { return FrameView(*this, 0).viewpoint; }

void append_view_frustum(const MatrixCamera& camera, double depth, std::vector<HalfSpace>& planes) {
  FrameView(camera, depth).append_half_spaces(planes);
}

std::string fault(const MatrixCamera& camera) { return std::string(MatrixEye(camera).fault()); }

}  // namespace occlude::culler
