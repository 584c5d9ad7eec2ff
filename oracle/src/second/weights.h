// SPDX-License-Identifier: MIT
// Linear programmes in the weights of the occluder's vertices. A point x lies on the line of sight through a point o of the
// occluder when x = o + t (o - V), or x = o + t d; in its shadow when t >= 0. With o = sum m_i v_i, m_i >= 0, sum m_i = 1,
// and weights l_i = (1 + t) m_i, or m_i, that is
//   x = sum l_i v_i - t V, sum l_i = 1 + t,   or   x = sum l_i v_i + t d, sum l_i = 1,
// linear in the unknowns l_i >= 0 and t, its coefficients the given numbers.
#pragma once

#include <optional>
#include <span>

#include "near_side.h"

namespace occlude::oracle::second {

/// Whether some point of the box is in the shadow of the vertices' hull.
[[nodiscard]] bool share_a_point(const Viewpoint& view, std::span<const Point> vertices, const std::optional<NearSide>& near,
                                 const Box& box);

}  // namespace occlude::oracle::second
