// SPDX-License-Identifier: MIT
// What a camera shows, in exact numbers: half-spaces written apart from the culler's view frustum, which they judge.
#pragma once

#include <array>
#include <span>

#include "occlude/culler/camera.h"
#include "occlude/oracle/questions.h"
#include "occlude/oracle/visibility.h"

namespace occlude::proof {

/// The picture of the camera, in the axes that the camera computes in doubles, each half-space moved outward by `outward`,
/// and by no more than its numbers are rounded by: what lies in the camera's own picture lies in this one. Moved inward
/// where `outward` is negative: what lies in this one lies in the camera's own. REQUIRES: the camera has no fault.
[[nodiscard]] oracle::Picture picture_of(const culler::Camera& camera, double outward);

/// No point of the model's box is farther from the eye than this, in the sum of the axes.
[[nodiscard]] double depth_of(const oracle::Aabb& model, const culler::Camera& camera);

/// The share of the depth by which a renderer in single precision may misjudge how far a point of a model lies from a
/// half-space of the picture: nine roundings of 2^-24 on each axis. One is the coordinate's, relative to the model's middle;
/// two take the eye away; the matrix and its products round once each, their sum three times; the last is that of near or
/// far. A tenth is for their second order.
inline constexpr double kRendererRounds = 10 * 0x1p-24;

/// Whether the renderer may draw a point of `model` that is on the plane a x + b y + c z + d = 0, or beyond it, where that
/// is negative. REQUIRES: as picture_of(); the coordinates of the box are in the legal range, the plane's numbers finite.
[[nodiscard]] bool may_draw_beyond(const std::array<double, 4>& plane, const culler::Camera& camera,
                                   const oracle::Aabb& model);

/// Whether the renderer may clip one of the points of `model` by the near plane. REQUIRES: as above.
[[nodiscard]] bool may_clip(const culler::Camera& camera, const oracle::Aabb& model, std::span<const oracle::Point> points);

/// What of `model` the renderer surely draws, as far as its near plane goes, in numbers of the legal range. REQUIRES: as
/// above.
[[nodiscard]] oracle::HalfSpaceCoefficients drawn(const culler::Camera& camera, const oracle::Aabb& model);

}  // namespace occlude::proof
