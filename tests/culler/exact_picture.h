// SPDX-License-Identifier: MIT
// Where points are in a coarse picture, in higher precision where the machine has it.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "cover/conservative_viewport.h"

namespace occlude::culler {

using Real = long double;

/// A point as a picture sees it.
struct ExactSeen {
  Real right, up, forward;
};

inline ExactSeen exact(const ConservativeViewport& picture, const glm::dvec3& point) {
  const auto along = [&](const glm::dvec3& axis) {
    Real sum = 0;
    for (int i = 0; i < 3; ++i) sum += Real{axis[i]} * (Real{point[i]} - Real{picture.eye()[i]});
    return sum;
  };
  return {along(picture.right()), along(picture.up()), along(picture.forward())};
}

/// Where the picture's rounding() may move a point at most.
inline std::array<ExactSeen, 8> moved(const ConservativeViewport& picture, const ExactSeen& seen) {
  const Real most = picture.rounding();
  std::array<ExactSeen, 8> all{};
  for (unsigned i = 0; i < 8; ++i) {
    const auto move = [&](unsigned axis) { return (i >> axis & 1U) != 0 ? most : -most; };
    all[i] = {seen.right + move(0), seen.up + move(1), seen.forward + move(2)};
  }
  return all;
}

/// A position in the picture and how near it is.
struct ExactPlace {
  Real x, y, nearness;
};

inline ExactPlace exact_place(const ConservativeViewport& picture, const ExactSeen& seen) {
  const Real shrink = picture.is_perspective() ? 1 / seen.forward : 1;
  return {picture.middle().x + picture.scale().x * seen.right * shrink,
          picture.middle().y + picture.scale().y * seen.up * shrink, picture.is_perspective() ? shrink : -seen.forward};
}

}  // namespace occlude::culler
