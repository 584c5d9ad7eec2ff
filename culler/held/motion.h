// SPDX-License-Identifier: MIT
// How a camera moves, from its frames so far.
#pragma once

#include <glm/vec3.hpp>

namespace occlude::culler {

/// One frame that differs from those before and after it is a jump, and counts for nothing.
class Motion {
 public:
  /// The camera is here at this time, and looks along this unit vector.
  void see(const glm::dvec3& eye, const glm::dvec3& forward, double seconds);

  [[nodiscard]] const glm::dvec3& velocity() const { return velocity_; }
  /// How fast it has turned lately, degrees a second.
  [[nodiscard]] double turning() const { return turning_; }
  /// How fast the line of sight moves.
  [[nodiscard]] const glm::dvec3& of_sight() const { return of_sight_; }
  /// Between the last two frames.
  [[nodiscard]] double frame_seconds() const { return frame_seconds_; }

 private:
  bool has_last_ = false;
  glm::dvec3 eye_{0, 0, 0}, forward_{1, 0, 0};
  double seconds_ = 0, frame_seconds_ = 0;
  glm::dvec3 last_step_{0, 0, 0}, velocity_{0, 0, 0};
  glm::dvec3 last_turn_{0, 0, 0}, of_sight_{0, 0, 0};
  double turning_ = 0;
};

}  // namespace occlude::culler
