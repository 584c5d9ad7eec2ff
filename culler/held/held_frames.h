// SPDX-License-Identifier: MIT
// Frames that are held against culls of regions, of whatever is culled: when regions are culled, where, and which frames
// they do for.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "camera/frame_view.h"
#include "camera/sound_camera.h"
#include "held/background.h"
#include "held/held_region.h"
#include "held/lease.h"
#include "held/motion.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/held_cull.h"

namespace occlude::culler {

/// A picture that is wider than for so much turning takes as long as six that hold all directions.
inline constexpr double kMostTurn = 20;
/// Frames before the present region ends, beside those that a cull takes, in which the next one is asked for.
inline constexpr double kFramesBefore = 2;
/// What a region hides is compared with a frame by point until the lease stays as it is, and then for one region of so many.
inline constexpr std::size_t kCompared = 4;
/// Room for near planes, as for those of ahead().
inline constexpr double kFartherNear = 1 + 1.0 / 64;

/// A camera with a picture around the camera's. None with parallel rays, which turn by rounding when they move.
[[nodiscard]] inline std::optional<Camera> around_picture(const Camera& camera) {
  return camera.projection == Projection::perspective ? std::optional(camera) : std::nullopt;
}
[[nodiscard]] inline std::optional<Camera> around_picture(const MatrixCamera& camera) {
  if (!FrameView(camera, 0).is_perspective) return std::nullopt;
  return ahead(camera, glm::dvec3(0), 0, {.aside = 0, .up = 0});
}

/// How many times as long a move in a picture can be in another that is turned against it, per height of each: by up to the
/// square of a ray of the other's, at a distance of 1.
[[nodiscard]] inline double stretch(const Camera& from, const Camera& to) {
  const double from_half = std::tan(glm::radians(from.fov_y_deg) / 2), half = std::tan(glm::radians(to.fov_y_deg) / 2);
  const double square = 1 + half * half * (1 + to.aspect * to.aspect);
  return square * from_half / half;
}

template <class Work>
[[nodiscard]] double milliseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// How a region compares with a frame by point.
struct ComparedRegion {
  double hidden_share;  ///< of what the frame by point hides
  double point_ms;
};

/// `Source` is what is culled:
///  - Region: what a region draws; it has a default;
///  - kAround: whether a region may be of six cameras that look in all directions;
///  - cull(region, cameras, stretch): culls for them, with margins so many times as large; compare(region, camera): the
///  region
///    beside a frame by point. Both are called on any thread, one at a time;
///  - holds(region, camera), depth(eye): whether the region does for the camera, and how far everything is;
///  - list(region, camera), cull_by_point(camera): make the result of a frame.
template <class Source>
class HeldFrames {
 public:
  HeldFrames(Source source, HeldOptions options)
      : source_(std::move(source)),
        way_(options.way),
        is_repeatable_(options.is_repeatable),
        background_(std::move(options.later)) {
    static_cast<void>(ahead(Camera{}, glm::dvec3(0), 0, way_));  // throws for one of which there are no regions
  }

  template <class AnyCamera>
  void cull(const AnyCamera& camera, double seconds) {
    require_sound(camera);
    if (!std::isfinite(seconds)) throw std::invalid_argument("the time of the frame is not finite");
    const FrameView view(camera, 0);
    motion_.see(view.eye, view.axes.forward, seconds);
    ++stats_.frames;
    collect(seconds);
    const std::optional<Camera> picture = around_picture(camera);
    if (hold(camera, picture, seconds)) {
      source_.list(present_.region, camera);
      ++present_.frames;
    } else {
      source_.cull_by_point(camera);
      ++stats_.of_point;
    }
    if (picture && background_.is_there()) ask_for_next(*picture, seconds);
  }

  [[nodiscard]] const HeldStats& stats() const { return stats_; }
  [[nodiscard]] const Source& source() const { return source_; }

 private:
  /// A region that is being culled, or was.
  struct Making {
    Camera planned_for;  ///< the camera whose way it is
    std::vector<Camera> cameras;
    bool is_compared = false;
    double asked_at = 0, lease = 0;
    typename Source::Region region;
    double hidden_share = 1;  ///< of what a frame by point hides
    double cost = 0;          ///< frames by point that take as long; 0 if that is not known
    bool has_failed = false;
    std::size_t frames = 0;  ///< that used it
  };

  /// Whether a region holds for the camera: the one that is ready, the present one, or one that is culled now.
  template <class AnyCamera>
  bool hold(const AnyCamera& camera, const std::optional<Camera>& picture, double seconds) {
    if (is_ready_ && source_.holds(ready_.region, camera)) use_ready(seconds);
    if (source_.holds(present_.region, camera)) return true;
    if (is_ready_) {
      ++stats_.late;
      is_ready_ = false;
      leave(ready_, seconds);
    }
    if (!picture || background_.is_there() || !plan(*picture, seconds)) return false;
    make();
    take(seconds);
    if (is_ready_) use_ready(seconds);
    return source_.holds(present_.region, camera);
  }

  /// Asks for a region if the present one, or the one that is ready, will not hold when it could be there.
  void ask_for_next(const Camera& picture, double seconds) {
    if (background_.is_busy()) return;
    const double lead = latency_ + kFramesBefore * motion_.frame_seconds();
    Camera then = picture;
    then.eye += lead * motion_.velocity();
    then.target = then.eye + glm::normalize(picture.target - picture.eye) + lead * motion_.of_sight();
    then.eyes = {};
    if (!fault(then).empty() || source_.holds(present_.region, then)) return;
    if (is_ready_ && source_.holds(ready_.region, then)) return;
    if (plan(picture, seconds)) background_.start([this] { make(); });
  }

  /// Says what to cull next. False if that does not pay, or the way leads beyond all numbers.
  bool plan(const Camera& picture, double seconds) {
    if (!lease_.pays(seconds)) return false;
    // A camera that turns faster than it did a moment ago is the rule when it begins to turn.
    const double of_one = latency_ + lease_.seconds(false, motion_.frame_seconds());
    const double turn = way_.turn_degrees + 1.5 * of_one * motion_.turning();
    const bool is_around = Source::kAround && turn > kMostTurn;
    if (turn > kMostTurn && !is_around) return false;
    const double lasts = lease_.seconds(is_around, motion_.frame_seconds());
    if (!find_cameras(picture, latency_ + lasts, is_around ? std::nullopt : std::optional(turn))) return false;
    making_.planned_for = picture;
    making_.frames = 0;
    making_.asked_at = seconds;
    making_.lease = lasts;
    making_.is_compared = lease_.has_changed() || stats_.regions % kCompared == 0;
    stats_.around += is_around ? 1 : 0;
    ++stats_.regions;
    return true;
  }

  /// Those of a region for so long. Without a number of degrees they look in all directions.
  bool find_cameras(const Camera& picture, double seconds, std::optional<double> turn_degrees) {
    AheadOptions way = way_;
    way.turn_degrees = turn_degrees.value_or(0);
    try {
      making_.cameras.assign(1, ahead(picture, motion_.velocity(), seconds, way));
    } catch (const std::invalid_argument&) {
      return false;
    }
    if (turn_degrees) return true;
    const Camera& way_camera = making_.cameras[0];
    const auto near = near_around(picture, source_.depth(way_camera.eye));
    if (!near) return false;
    const auto cameras = all_around(way_camera, kFartherNear * *near);
    making_.cameras.assign(cameras.begin(), cameras.end());
    return true;
  }

  /// On any thread: nothing else touches what is being made.
  void make() noexcept {
    try {
      making_.has_failed = true;
      const double factor = stretch(making_.planned_for, making_.cameras[0]);
      const double ms = milliseconds([&] { source_.cull(making_.region, making_.cameras, factor); });
      if (making_.is_compared) compare(ms);
      making_.has_failed = false;
    } catch (...) {
      // Frames go on by point.
    }
  }
  /// With a frame for the eye for which it was planned.
  void compare(double region_ms) {
    const ComparedRegion compared = source_.compare(making_.region, making_.planned_for);
    making_.hidden_share = compared.hidden_share;
    making_.cost = is_repeatable_ || compared.point_ms == 0 ? 0 : region_ms / compared.point_ms;
  }

  void collect(double seconds) {
    if (!background_.is_busy()) return;
    if (is_repeatable_) background_.finish();
    if (!background_.has_ended()) return;
    latency_ = std::max(seconds - making_.asked_at, 0.0);
    take(seconds);
  }
  /// The region that was made is ready.
  void take(double seconds) {
    if (making_.has_failed) {
      lease_.hid(-1, seconds);
    } else if (making_.is_compared) {
      lease_.hid(making_.hidden_share, seconds);
      if (making_.cost > 0) lease_.cost(making_.cameras.size() > 1, making_.cost);
    }
    std::swap(ready_, making_);
    is_ready_ = !ready_.has_failed;
  }
  void use_ready(double seconds) {
    if (stats_.regions > 1) leave(present_, seconds);
    std::swap(present_, ready_);
    is_ready_ = false;
  }
  void leave(const Making& region, double seconds) {
    lease_.held(seconds - region.asked_at, region.lease, region.cameras.size() > 1, region.frames, seconds);
  }

  Source source_;
  AheadOptions way_;
  bool is_repeatable_;
  HeldStats stats_;
  Motion motion_;
  Lease lease_;
  double latency_ = 0;  ///< of the last region, from when it was asked for to the frame that could use it
  Making present_, ready_, making_;
  bool is_ready_ = false;  ///< `ready_` was not used so far
  Background background_;  ///< last: what it runs uses the others
};

}  // namespace occlude::culler
