// SPDX-License-Identifier: MIT
// Placements, in doubles.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace occlude::render::gltf {

/// Scales, then turns, then moves. The quaternion (x, y, z, w) may have any length: files have it in few digits. One of
/// length 0 does not turn.
[[nodiscard]] inline glm::dmat4 placement(const glm::dvec3& translation, const glm::dvec4& quaternion,
                                          const glm::dvec3& scale) {
  const auto [x, y, z, w] = std::array{quaternion.x, quaternion.y, quaternion.z, quaternion.w};
  const double square = x * x + y * y + z * z + w * w;
  const double s = square == 0 ? 0 : 2 / square;
  return {glm::dvec4(1 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w), 0) * scale.x,
          glm::dvec4(s * (x * y - z * w), 1 - s * (x * x + z * z), s * (y * z + x * w), 0) * scale.y,
          glm::dvec4(s * (x * z + y * w), s * (y * z - x * w), 1 - s * (x * x + y * y), 0) * scale.z,
          glm::dvec4(translation, 1)};
}

/// The point, moved. The last row of the matrix is (0, 0, 0, 1).
[[nodiscard]] inline glm::dvec3 placed(const glm::dmat4& matrix, const glm::dvec3& point) {
  return glm::dvec3(matrix * glm::dvec4(point, 1));
}

}  // namespace occlude::render::gltf
