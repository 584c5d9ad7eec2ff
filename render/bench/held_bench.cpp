// SPDX-License-Identifier: MIT
#include "held_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <random>
#include <utility>

#include "occlude/render/interrupt.h"
#include "spread.h"

namespace occlude::experiments {
namespace {

using culler::Camera;
using glm::dvec3;

constexpr double kAspect = 16.0 / 9;

/// Points of a path by how far they are along it, in model units.
class Way {
 public:
  explicit Way(const render::CameraPath& path) {
    double length = 0;
    for (std::size_t frame = 0; frame < path.frames; ++frame) {
      const Camera camera = path.camera(frame, kAspect);
      if (!stops_.empty()) length += glm::length(camera.eye - stops_.back().camera.eye);
      stops_.push_back({length, camera});
    }
  }
  [[nodiscard]] double length() const { return stops_.back().length; }
  /// REQUIRES: 0 <= along.
  [[nodiscard]] Camera at(double along) const {
    const auto next = std::ranges::upper_bound(stops_, along, {}, &Stop::length);
    if (next == stops_.end()) return stops_.back().camera;
    const Stop &a = *std::prev(next), &b = *next;
    const double share = (along - a.length) / (b.length - a.length);
    Camera camera = a.camera;
    const auto sight = [](const Camera& c) { return glm::normalize(c.target - c.eye); };
    camera.eye += share * (b.camera.eye - a.camera.eye);
    camera.target = camera.eye + (1 - share) * sight(a.camera) + share * sight(b.camera);
    return camera;
  }

 private:
  struct Stop {
    double length;
    Camera camera;
  };
  std::vector<Stop> stops_;
};

/// Along the way, there and back.
double there_and_back(double along, double length) {
  const double turn = std::fmod(along, 2 * length);
  return turn < length ? turn : 2 * length - turn;
}

/// A thread beside, as it would be if it ran: what it is given begins with the next frame, and takes as many frames as such
/// work took the last time.
class Beside {
 public:
  explicit Beside(double frame_ms) : frame_ms_(frame_ms) {}

  [[nodiscard]] culler::Later later() {
    return [this](std::function<void()> task) {
      task_ = std::move(task);
      frames_left_ = static_cast<int>(last_ms_ / frame_ms_);
    };
  }
  void pass_frame() {
    if (!task_ || frames_left_-- > 0) return;
    const std::function<void()> task = std::exchange(task_, nullptr);
    last_ms_ = milliseconds(task);
    all_ms_ += last_ms_;
    most_ms_ = std::max(most_ms_, last_ms_);
  }
  [[nodiscard]] double all_ms() const { return all_ms_; }
  [[nodiscard]] double most_ms() const { return most_ms_; }

 private:
  double frame_ms_, last_ms_ = 0, all_ms_ = 0, most_ms_ = 0;
  std::function<void()> task_;
  int frames_left_ = 0;
};

/// Where a camera is in each frame.
struct Move {
  std::string name;
  std::optional<double> speed;  ///< as of HeldMove
  std::function<Camera(std::size_t frame)> camera;
};

std::vector<Move> moves(const Way& way, double frames_a_second, const std::vector<double>& speeds) {
  const auto along = [&way, frames_a_second](double speed) {
    return [&way, frames_a_second, speed](std::size_t frame) {
      return way.at(there_and_back(speed * static_cast<double>(frame) / frames_a_second, way.length()));
    };
  };
  if (!speeds.empty()) {
    std::vector<Move> result;
    for (const double speed : speeds) result.push_back({fmt::format("{} a second", speed), speed, along(speed)});
    return result;
  }
  const auto turning = [&way, frames_a_second](std::size_t frame) {
    Camera camera = way.at(way.length() / 2);
    const double angle = glm::radians(180.0) * static_cast<double>(frame) / frames_a_second;
    const dvec3 sight = camera.target - camera.eye, axis = glm::normalize(camera.up);
    camera.target = camera.eye + std::cos(angle) * sight + std::sin(angle) * glm::cross(axis, sight) +
                    (1 - std::cos(angle)) * glm::dot(axis, sight) * axis;
    return camera;
  };
  const auto jumping = [&way, frames_a_second](std::size_t frame) {
    const double seconds = static_cast<double>(frame) / frames_a_second;
    std::mt19937 random(static_cast<std::uint32_t>(seconds));
    const double from = static_cast<double>(random()) / 4294967296.0 * way.length();
    return way.at(there_and_back(from + 1.5 * (seconds - std::floor(seconds)), way.length()));
  };
  return {{"walking, 1.5 a second", 1.5, along(1.5)},
          {"driving, 15 a second", 15, along(15)},
          {"turning, 180 degrees a second", std::nullopt, turning},
          {"walking, elsewhere every second", 1.5, jumping}};
}

HeldMove measure(const culler::Culler& culler, const Move& move, const HeldBenchOptions& options) {
  Beside beside(1000 / options.frames_a_second);
  culler::HeldCull held(culler, {.later = beside.later()}, options.cull);
  culler::View view;
  HeldMove result;
  result.name = move.name;
  result.speed = move.speed;
  double hidden = 0, more = 0;
  std::size_t compared = 0;
  for (std::size_t frame = 0; frame < options.frames; ++frame) {
    render::check_interrupt();
    const Camera camera = move.camera(frame);
    const culler::HeldResult* drawn = nullptr;
    const double ms =
        milliseconds([&] { drawn = &held.cull(camera, static_cast<double>(frame) / options.frames_a_second); });
    result.own_ms += ms / static_cast<double>(options.frames);
    result.worst_own_ms = std::max(result.worst_own_ms, ms);
    if (!drawn->is_of_point) result.worst_held_ms = std::max(result.worst_held_ms, ms);
    beside.pass_frame();
    if (frame % options.compare_every != 0) continue;
    ++compared;
    const culler::CullResult* by_point = nullptr;
    result.point_ms += milliseconds([&] { by_point = &culler.cull(camera, options.cull, view); });
    hidden += static_cast<double>(by_point->stats.shadow_culled_polygons);
    more += static_cast<double>(drawn->drawn_polygons) - static_cast<double>(by_point->stats.drawn_polygons);
    result.drawn += static_cast<double>(drawn->drawn_polygons);
    result.drawn_by_point += static_cast<double>(by_point->stats.drawn_polygons);
  }
  for (double* const mean : {&result.point_ms, &result.drawn, &result.drawn_by_point})
    *mean /= static_cast<double>(compared);
  result.hidden_share = hidden > 0 ? 1 - more / hidden : 1;
  result.beside_ms = beside.all_ms() / static_cast<double>(options.frames);
  result.worst_beside = beside.most_ms();
  result.stats = held.stats();
  return result;
}

}  // namespace

HeldBenchResult bench_held(const Subject& subject, const HeldBenchOptions& options) {
  const culler::Culler culler(subject.soup, {.hierarchy = {.leaf_size = options.leaf}});
  culler.prepare(options.cull.method);
  const Way way(subject.path);
  HeldBenchResult result{subject.name, subject.soup.size(), {}};
  for (const Move& move : moves(way, options.frames_a_second, options.speeds))
    result.moves.push_back(measure(culler, move, options));
  return result;
}

}  // namespace occlude::experiments
