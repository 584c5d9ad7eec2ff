// SPDX-License-Identifier: MIT
// What a camera shows, in exact numbers: half-spaces written apart from the culler's view frustum, which they judge.
#pragma once

#include <array>
#include <span>

#include "occlude/culler/camera.h"
#include "occlude/oracle/visibility.h"

namespace occlude::proof {

/// The picture of the camera as the renderer clips it, in the axes that the camera computes in doubles, its opening, near
/// and far plane wider by the share `wider`, and by no more than its numbers are rounded by: what lies in the camera's own
/// picture lies in this one. Narrower where `wider` is negative: what lies in this one lies in the camera's own.
/// REQUIRES: the camera has no fault; |wider| < 1.
[[nodiscard]] oracle::Picture picture_of(const culler::Camera& camera, double wider);

/// The share by which a picture is wider that has all that the renderer draws: twice what single precision moves a point
/// at its border by (2^-22 of its distance), half of what the culler keeps (2^-20).
inline constexpr double kRendererWider = 0x1p-21;

/// Whether the renderer may draw a point of `model` that is on the plane a x + b y + c z + d = 0, or beyond it, where that
/// is negative. REQUIRES: as picture_of(); the coordinates of the box are in the legal range, the plane's numbers finite.
[[nodiscard]] bool may_draw_beyond(const std::array<double, 4>& plane, const culler::Camera& camera,
                                   const oracle::Aabb& model);

/// Whether the renderer may clip one of the points by the near plane. REQUIRES: as above.
[[nodiscard]] bool may_clip(const culler::Camera& camera, std::span<const oracle::Point> points);

}  // namespace occlude::proof
