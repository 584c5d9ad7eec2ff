// SPDX-License-Identifier: MIT
// What a camera shows, in exact numbers. The half-spaces are derived independently of the culler's view frustum, which they
// check.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <variant>

#include "occlude/culler/camera.h"
#include "occlude/oracle/questions.h"
#include "occlude/oracle/region.h"
#include "occlude/oracle/visibility.h"

namespace occlude::proof {

/// A camera of any kind. REQUIRES, of each function below: it has no fault.
using AnyCamera = std::variant<culler::Camera, culler::MatrixCamera>;

/// The eye, or the direction of parallel rays: the doubles that the camera computes, taken as exact.
[[nodiscard]] oracle::Viewpoint viewpoint_of(const AnyCamera& camera);

/// Where the eye of a camera may be, in the model: at its own place, or anywhere in a region. The functions below take other
/// eyes than the camera's own, if there are any: a region to which its eye belongs.
using Eyes = std::optional<oracle::EyeRegion>;
[[nodiscard]] Eyes eyes_of(const AnyCamera& camera);

/// The picture of the camera: with the axes that it computes in doubles, or the clip volume of its matrix. Each half-space
/// is moved outward by `outward`, and by a little more than its numbers may be wrong by rounding. So the camera's own
/// picture lies in this one. A negative `outward` moves the half-spaces inward, and this picture lies in the camera's own.
/// Of a camera with several eyes, the pictures of all of them lie in this one, or this one in all of those.
[[nodiscard]] oracle::Picture picture_of(const AnyCamera& camera, double outward, const Eyes& eyes = {});

/// A bound on the distance from an eye to any point of the model's box, summed over the axes.
[[nodiscard]] double depth_of(const oracle::Aabb& model, const AnyCamera& camera, const Eyes& eyes = {});

/// A renderer in single precision may misjudge the distance of a point to a half-space of the picture by this share of the
/// depth. There are nine roundings of 2^-24 on each axis. One is the coordinate's, relative to the model's middle. Two come
/// from subtracting the eye. The matrix and its products round once each, and their sum three times. The last is that of
/// near or far. The tenth 2^-24 covers the second-order terms.
inline constexpr double kRendererRounds = 10 * 0x1p-24;
/// Where the culler cuts sheets: beyond the near plane by 2^-20 of the depth (Camera, ../../culler/README.md).
inline constexpr double kSheetsBegin = 0x1p-20;

/// Whether the renderer may draw a point of `model` at which a x + b y + c z + d <= 0. REQUIRES: the coordinates of the box
/// are in the legal range; the numbers of the plane are finite.
[[nodiscard]] bool may_draw_beyond(const std::array<double, 4>& plane, const AnyCamera& camera, const oracle::Aabb& model,
                                   const Eyes& eyes = {});

/// Whether the renderer certainly clips no point of `model` in the half-space at its near plane, of those that are within
/// the sides of its picture. REQUIRES: as above.
[[nodiscard]] bool draws_all_in(const oracle::HalfSpaceCoefficients& half_space, const AnyCamera& camera,
                                const oracle::Aabb& model, const Eyes& eyes = {});

/// Whether the near plane of the renderer may clip one of the points of `model`. REQUIRES: as above.
[[nodiscard]] bool may_clip(const AnyCamera& camera, const oracle::Aabb& model, std::span<const oracle::Point> points,
                            const Eyes& eyes = {});

/// The half-space whose points in `model` the near plane of the renderer certainly does not clip. Its numbers are in the
/// legal range. REQUIRES: as above.
[[nodiscard]] oracle::HalfSpaceCoefficients drawn(const AnyCamera& camera, const oracle::Aabb& model, const Eyes& eyes = {});

/// A half-space in that one, in which the sheets of windows are looked at. Any does: what is left out only hides less. But
/// where a sheet is cut is border, and border that shows in a window proves nothing. So this begins where the culler cuts
/// sheets.
[[nodiscard]] oracle::HalfSpaceCoefficients drawn_of_sheets(const AnyCamera& camera, const oracle::Aabb& model,
                                                            const Eyes& eyes = {});

}  // namespace occlude::proof
