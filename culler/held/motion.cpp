// SPDX-License-Identifier: MIT
#include "held/motion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace occlude::culler {
namespace {

/// Of two speeds in a row the one that is not of a jump.
glm::dvec3 slower(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a) < glm::length(b) ? a : b; }

/// After so long without turning, the camera counts as half as fast.
constexpr double kHalfLife = 0.25;

}  // namespace

void Motion::see(const glm::dvec3& eye, const glm::dvec3& forward, double seconds) {
  const double passed = seconds - seconds_;
  if (has_last_ && passed > 0) {
    const glm::dvec3 step = (eye - eye_) / passed, turn = (forward - forward_) / passed;
    velocity_ = slower(step, last_step_);
    of_sight_ = slower(turn, last_turn_);
    last_step_ = step;
    last_turn_ = turn;
    const double lately = turning_ * std::exp2(-passed / kHalfLife);
    turning_ = std::max(lately, glm::degrees(glm::length(of_sight_)));
    frame_seconds_ = passed;
  }
  has_last_ = true;
  eye_ = eye;
  forward_ = forward;
  seconds_ = seconds;
}

}  // namespace occlude::culler
