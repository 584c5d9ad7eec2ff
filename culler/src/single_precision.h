// SPDX-License-Identifier: MIT
// What a renderer in single precision has points out by.
#pragma once

namespace occlude::culler {

/// The share of `depth` by which such a renderer may misjudge how far a point lies from a plane of its view; `depth` is how
/// far the model reaches from the eye, in the sum of the axes. On each axis a coordinate relative to the model's middle
/// rounds by 2^-24 of the depth, taking away the two parts of the eye by as much twice, the row of the matrix by as much, a
/// product by as much, and the sum of the row three times. Near or far, which the row is compared with, is no larger than
/// the depth where it cuts the model, and rounds once: nine roundings, and a tenth for their second order.
inline constexpr double kSinglePrecision = 10 * 0x1p-24;

/// The share of `depth` by which the planes of a view lie outside of the camera's, and what occludes lies beyond its near
/// plane: more than what single precision has points out by, half as much again, for those who hold them against it.
inline constexpr double kDepthMargin = 0x1p-20;
static_assert(kDepthMargin > 1.5 * kSinglePrecision);

}  // namespace occlude::culler
