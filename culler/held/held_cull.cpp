// SPDX-License-Identifier: MIT
#include "occlude/culler/held_cull.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "camera/frame_view.h"
#include "camera/sound_camera.h"
#include "held/background.h"
#include "held/held_region.h"
#include "held/lease.h"
#include "held/motion.h"
#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// A picture that is wider than for so much turning takes as long as six that hold all directions.
constexpr double kMostTurn = 20;
/// Frames before the present region ends, beside those that a cull takes, in which the next one is asked for.
constexpr double kFramesBefore = 2;
/// What a region hides is compared with a frame by point until the lease stays as it is, and then for one region of so many.
constexpr std::size_t kCompared = 4;
/// Room for near planes, as for those of ahead().
constexpr double kFartherNear = 1 + 1.0 / 64;

/// A camera with a picture around the camera's. None with parallel rays, which turn by rounding when they move.
std::optional<Camera> around_picture(const Camera& camera) {
  return camera.projection == Projection::perspective ? std::optional(camera) : std::nullopt;
}
std::optional<Camera> around_picture(const MatrixCamera& camera) {
  if (!FrameView(camera, 0).is_perspective) return std::nullopt;
  return ahead(camera, glm::dvec3(0), 0, {.aside = 0, .up = 0});
}

/// How many times as long a move in a picture can be in another that is turned against it, per height of each: by up to the
/// square of a ray of the other's, at a distance of 1.
double stretch(const Camera& from, const Camera& to) {
  const double from_half = std::tan(glm::radians(from.fov_y_deg) / 2), half = std::tan(glm::radians(to.fov_y_deg) / 2);
  const double square = 1 + half * half * (1 + to.aspect * to.aspect);
  return square * from_half / half;
}

template <class Work>
double milliseconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

struct HeldCull::State {
  /// A region that is being culled, or was.
  struct Making {
    Camera planned_for;  ///< the camera whose way it is
    std::vector<Camera> cameras;
    CullOptions options;
    bool is_compared = false;
    double asked_at = 0, lease = 0;
    HeldRegion region;
    double hidden_share = 1;  ///< of what a frame by point hides
    double cost = 0;          ///< frames by point that take as long; 0 if that is not known
    bool has_failed = false;
    std::size_t frames = 0;  ///< that used it
  };

  State(const Culler& of, HeldOptions how) : culler(of), options(std::move(how)), background(options.later) {}

  template <class AnyCamera>
  const HeldResult& cull(const AnyCamera& camera, double seconds) {
    require_sound(camera);
    const FrameView view(camera, depth(culler.hierarchy().nodes()[0].box, eye_of(camera)));
    motion.see(view.eye, view.axes.forward, seconds);
    ++stats.frames;
    collect(seconds);
    if (is_ready && ready.region.holds_for(camera)) use_ready(seconds);
    const std::optional<Camera> picture = around_picture(camera);
    bool holds = present.region.holds_for(camera);
    if (is_ready && !holds) {
      ++stats.late;
      is_ready = false;
      leave(ready, seconds);
    }
    if (picture && !holds && !background.is_there() && plan(*picture, seconds)) {
      make(making);
      take(seconds);
      use_ready(seconds);
      holds = present.region.holds_for(camera);
    }
    if (holds) {
      list(view);
    } else {
      cull_by_point(camera);
    }
    if (picture && background.is_there()) ask_for_next(*picture, seconds);
    return result;
  }

  /// What is held, culled by the view.
  void list(const FrameView& view) {
    planes.clear();
    for (std::size_t i = 0; i < view.half_space_count; ++i) {
      planes.push_back({to_kernel(view.half_spaces[i].normal), view.half_spaces[i].offset});
    }
    present.region.leaves().list(planes, result);
    ++present.frames;
    result.is_of_point = false;
  }

  template <class AnyCamera>
  void cull_by_point(const AnyCamera& camera) {
    const CullResult& frame = culler.cull(camera, options.cull, view_by_point);
    result.drawn.assign(frame.drawn.begin(), frame.drawn.end());
    result.drawn_polygons = frame.stats.drawn_polygons;
    result.is_of_point = true;
    ++stats.of_point;
  }

  /// Asks for a region if the present one, or the one that is ready, will not hold when it could be there.
  void ask_for_next(const Camera& picture, double seconds) {
    if (background.is_busy()) return;
    const double lead = latency + kFramesBefore * motion.frame_seconds();
    Camera then = picture;
    then.eye += lead * motion.velocity();
    then.target = then.eye + glm::normalize(picture.target - picture.eye) + lead * motion.of_sight();
    then.eyes = {};
    if (!fault(then).empty() || present.region.holds_for(then)) return;
    if (is_ready && ready.region.holds_for(then)) return;
    if (!plan(picture, seconds)) return;
    background.start([this] { make(making); });
  }

  /// Says what to cull next. False if that does not pay.
  bool plan(const Camera& picture, double seconds) {
    if (!lease.pays(seconds)) return false;
    // A camera that turns faster than it did a moment ago is the rule when it begins to turn.
    const auto turn_in = [&](double held) { return options.way.turn_degrees + 1.5 * held * motion.turning(); };
    const double of_one = latency + lease.seconds(false, motion.frame_seconds()), turn = turn_in(of_one);
    const bool is_around = turn > kMostTurn;
    const double lasts = lease.seconds(is_around, motion.frame_seconds()), longest = latency + lasts;
    AheadOptions way = options.way;
    way.turn_degrees = is_around ? 0 : turn;
    const Camera ahead_of = ahead(picture, motion.velocity(), longest, way);
    making.cameras.assign(1, ahead_of);
    if (is_around) {
      const auto near = near_around(picture, depth(culler.hierarchy().nodes()[0].box, ahead_of.eye));
      if (!near) return false;
      const auto cameras = all_around(ahead_of, kFartherNear * *near);
      making.cameras.assign(cameras.begin(), cameras.end());
    }
    making.planned_for = picture;
    making.frames = 0;
    making.asked_at = seconds;
    making.lease = lasts;
    making.options = options.cull;
    making.options.margin *= stretch(picture, making.cameras[0]);
    making.is_compared = lease.has_changed() || stats.regions % kCompared == 0;
    stats.around += is_around ? 1 : 0;
    ++stats.regions;
    return true;
  }

  /// On any thread: nothing else touches `of` and the views of regions meanwhile.
  void make(Making& of) noexcept {
    try {
      of.has_failed = true;
      const double ms = milliseconds([&] { of.region.cull(culler, of.cameras, of.options, view_of_regions); });
      if (of.is_compared) compare(of, ms);
      of.has_failed = false;
    } catch (...) {
      // Frames go on by point.
    }
  }

  /// Culls for the eye for which the region was planned, too.
  void compare(Making& of, double region_ms) {
    const double ms = milliseconds([&] { culler.cull(of.planned_for, options.cull, view_compared); });
    const CullResult& frame = view_compared.result();
    of.cost = options.is_repeatable || ms == 0 ? 0 : region_ms / ms;
    std::vector<kernel::HalfSpace> view;
    for (const HalfSpace& h : frame.view) view.push_back({to_kernel(h.normal), h.offset});
    HeldResult drawn;
    of.region.leaves().list(view, drawn);
    const double of_point = static_cast<double>(frame.stats.shadow_culled_polygons);
    const double more = static_cast<double>(drawn.drawn_polygons) - static_cast<double>(frame.stats.drawn_polygons);
    of.hidden_share = of_point > 0 ? 1 - more / of_point : 1;
  }

  void collect(double seconds) {
    if (!background.is_busy()) return;
    if (options.is_repeatable) background.finish();
    if (!background.has_ended()) return;
    latency = std::max(seconds - making.asked_at, 0.0);
    take(seconds);
  }
  /// The region that was made is ready.
  void take(double seconds) {
    if (making.has_failed) {
      lease.hid(-1, seconds);
    } else if (making.is_compared) {
      lease.hid(making.hidden_share, seconds);
      if (making.cost > 0) lease.cost(making.cameras.size() > 1, making.cost);
    }
    std::swap(ready, making);
    is_ready = !ready.has_failed;
  }
  void use_ready(double seconds) {
    if (stats.regions > 1) leave(present, seconds);
    std::swap(present, ready);
    is_ready = false;
  }

  void leave(const Making& region, double seconds) {
    lease.held(seconds - region.asked_at, region.lease, region.cameras.size() > 1, region.frames, seconds);
  }

  const Culler& culler;
  HeldOptions options;
  HeldStats stats;
  HeldResult result;
  Motion motion;
  Lease lease;
  double latency = 0;  ///< of the last region, from when it was asked for to the frame that could use it
  std::vector<kernel::HalfSpace> planes;
  Making present, ready, making;
  bool is_ready = false;  ///< `ready` was not used so far
  View view_by_point, view_of_regions, view_compared;
  Background background;  ///< last: what it runs uses the others
};

HeldCull::HeldCull(const Culler& culler, HeldOptions options)
    : state_(std::make_unique<State>(culler, std::move(options))) {}
HeldCull::~HeldCull() = default;
HeldCull::HeldCull(HeldCull&&) noexcept = default;
HeldCull& HeldCull::operator=(HeldCull&&) noexcept = default;

const HeldResult& HeldCull::cull(const Camera& camera, double seconds) { return state_->cull(camera, seconds); }
const HeldResult& HeldCull::cull(const MatrixCamera& camera, double seconds) { return state_->cull(camera, seconds); }

const HeldStats& HeldCull::stats() const { return state_->stats; }

}  // namespace occlude::culler
