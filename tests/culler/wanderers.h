// SPDX-License-Identifier: MIT
// Cameras that go about, and threads that answer late.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <utility>

#include "occlude/culler/camera.h"
#include "occlude/culler/held_cull.h"
#include "sanitized.h"
#include "scenes.h"

namespace occlude::culler {

/// OCCLUDE_HELD_FRAMES, or as many as the suite has time for.
inline unsigned frames_wanted() {
  const char* const requested = std::getenv("OCCLUDE_HELD_FRAMES");
  constexpr unsigned kUsual = unless_sanitized(3000U, 300U);
  return requested != nullptr ? static_cast<unsigned>(std::strtoul(requested, nullptr, 10)) : kUsual;
}

/// Tasks that run when some time has gone.
class Delays {
 public:
  [[nodiscard]] Later later(std::function<double()> seconds) {
    return [this, seconds = std::move(seconds)](std::function<void()> task) {
      tasks_.emplace_back(now_ + seconds(), std::move(task));
    };
  }
  void pass_until(double now) {
    now_ = now;
    for (std::size_t i = 0; i < tasks_.size();) {
      if (tasks_[i].first > now) {
        ++i;
        continue;
      }
      const std::function<void()> task = std::move(tasks_[i].second);
      tasks_.erase(tasks_.begin() + static_cast<std::ptrdiff_t>(i));
      task();
    }
  }
  [[nodiscard]] std::size_t waiting() const { return tasks_.size(); }

 private:
  double now_ = 0;
  std::deque<std::pair<double, std::function<void()>>> tasks_;
};

/// Somebody who walks, drives, stands, turns and is put elsewhere.
class Wanderer {
 public:
  explicit Wanderer(std::mt19937& random) : random_(random) { jump(); }

  Camera after(double seconds) {
    if (random_() % 180 == 0) {
      speed_ = std::array{0.0, 1.5, 1.5, 1.5, 15.0}[random_() % 5];
      turning_ = std::array{0.0, 0.0, 20.0, -30.0, 180.0}[random_() % 5];
    }
    if (random_() % 400 == 0) jump();
    angle_ += glm::radians(turning_) * seconds;
    const glm::dvec3 forward{std::cos(angle_), std::sin(angle_), 0.1 * std::sin(3 * angle_)};
    camera_.eye += speed_ * seconds * glm::dvec3(forward.x, forward.y, 0);
    if (std::max(std::fabs(camera_.eye.x), std::fabs(camera_.eye.y)) > 55) jump();
    camera_.target = camera_.eye + forward;
    return camera_;
  }

 private:
  void jump() {
    camera_.eye = {uniform(random_, -45, 45), uniform(random_, -45, 45), uniform(random_, 1, 2)};
    angle_ = uniform(random_, 0, 6.3);
  }

  std::mt19937& random_;
  Camera camera_{.fov_y_deg = 60, .near_plane = 0.05};
  double angle_ = 0, speed_ = 1.5, turning_ = 0;
};

}  // namespace occlude::culler
