// SPDX-License-Identifier: MIT
// How far a renderer in single precision moves points.
#pragma once

namespace occlude::culler {

/// The share of `depth` by which such a renderer may misjudge how far a point lies from a plane of its view. `depth` is how
/// far the model reaches from the eye, in the sum of the axes. These are the roundings, each 2^-24 of the depth: on each
/// axis a coordinate relative to the model's middle rounds once, the subtraction of the two parts of the eye twice, the row
/// of the matrix once, a product once, and the sum of the row three times. Near or far, with which the row is compared, is
/// no larger than the depth where it cuts the model, and rounds once. These are nine roundings, and a tenth is for
/// second-order terms.
inline constexpr double kSinglePrecision = 10 * 0x1p-24;

/// The share of `depth` by which the planes of a view lie outside the camera's, and by which occluders lie beyond its near
/// plane. It is more than the error of single precision, and half as much again, which leaves room for checks against it.
inline constexpr double kDepthMargin = 0x1p-20;
static_assert(kDepthMargin > 1.5 * kSinglePrecision);

}  // namespace occlude::culler
