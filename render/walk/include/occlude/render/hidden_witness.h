// SPDX-License-Identifier: MIT
// The proof that polygons are hidden from everywhere in boxes of eyes, or from outside, for independent checks: claims, and
// after them what proves them. One line of JSON each, without line break; docs/formats.md says what they mean.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/kernel/types.h"

namespace occlude::render {

/// So many numbers of polygons fit into a line of at most kMostJson bytes, beside all else.
inline constexpr std::size_t kMostInLine = std::size_t{1} << 18U;

/// The claim that faces of the model are hidden from everywhere in all of these boxes, in one line or more. `faces` has a
/// value for each.
[[nodiscard]] std::vector<std::string> claims_from(std::span<const kernel::Aabb> boxes, const std::vector<bool>& faces);

/// The claim that they are hidden from everywhere outside of the hull of the model, which is in the box. If they may touch
/// what hides them, that is claimed but for points of the borders of their triangles.
[[nodiscard]] std::vector<std::string> claims_outside(const kernel::Aabb& box, bool may_touch,
                                                      const std::vector<bool>& faces);

/// What hides polygons in the box of the cover from all eyes in `from`. `drawn` is the half-space in which sheets count.
/// REQUIRES: the camera has these eyes, and the cover is of its frame.
[[nodiscard]] std::string hidden_witness(const culler::Hierarchy& hierarchy, std::span<const std::uint32_t> polygons,
                                         const kernel::Aabb& from, const culler::Camera& camera,
                                         const std::array<double, 4>& drawn, const culler::CoverWitness& cover);

/// The closed shell of polygons that has the triangles inside.
[[nodiscard]] std::string shell_witness(const culler::Hierarchy& hierarchy, std::span<const culler::FanTriangle> triangles,
                                        std::span<const std::uint32_t> shell);

}  // namespace occlude::render
