// SPDX-License-Identifier: MIT
// Nodes of a scene that move.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

namespace occlude::render {

/// How values follow one another.
enum class Between { linear, step, cubic };

/// Values at times, which ascend. A cubic track has three values for each time: the tangent before it, the value, and the
/// tangent behind it.
template <class V>
struct Track {
  std::vector<double> times;  ///< seconds
  std::vector<V> values;
  Between between = Between::linear;

  [[nodiscard]] bool empty() const { return times.empty(); }
};

/// A node, whose place is below that of its parent.
struct MovingNode {
  std::optional<std::size_t> parent;
  glm::dmat4 rest{1};  ///< where nothing moves it
  glm::dvec3 translation{0}, scale{1};
  glm::dvec4 rotation{0, 0, 0, 1};  ///< a quaternion (x, y, z, w)
  Track<glm::dvec3> translations, scales;
  Track<glm::dvec4> rotations;

  [[nodiscard]] bool moves() const { return !translations.empty() || !scales.empty() || !rotations.empty(); }
};

/// The poses of a node in the scene, at about 30 frames a second from the first time to the last of all that moves it; one
/// pose if nothing does. Throws InputError for a node that is below itself and for more than kMostFrames.
[[nodiscard]] std::vector<glm::dmat4> poses_of(const std::vector<MovingNode>& nodes, std::size_t node);

/// The node and those above it. Throws InputError if it is below itself.
[[nodiscard]] std::vector<std::size_t> line_of(const std::vector<MovingNode>& nodes, std::size_t node);

}  // namespace occlude::render
