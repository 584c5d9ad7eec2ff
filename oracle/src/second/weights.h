// SPDX-License-Identifier: MIT
// Linear programmes in the weights of the occluder's vertices. A point x is on the line of sight through a point o of the
// occluder when x = o + t (o - V), or x = o + t d for a direction d. It is in the shadow when t >= 0. Let o = sum m_i v_i
// with m_i >= 0 and sum m_i = 1. With the weights l_i = (1 + t) m_i, or l_i = m_i for a direction, this is
//   x = sum l_i v_i - t V, sum l_i = 1 + t,   or   x = sum l_i v_i + t d, sum l_i = 1.
// Both are linear in the unknowns l_i >= 0 and t, and their coefficients are the given numbers.
#pragma once

#include <optional>
#include <span>

#include "near_side.h"

namespace occlude::oracle::second {

/// Whether some point of the box is in the shadow of the hull of the vertices, which begins at the hull or at `near`.
[[nodiscard]] bool share_a_point(const Viewpoint& view, std::span<const Point> vertices, const std::optional<NearSide>& near,
                                 const Box& box);

}  // namespace occlude::oracle::second
