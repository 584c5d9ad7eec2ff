// SPDX-License-Identifier: MIT
// Frames that do for other cameras than their own.
#include "camera/holds_for.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "camera/eye_region.h"
#include "camera/frame_view.h"
#include "frames.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/scene.h"
#include "sanitized.h"
#include "scenes.h"
#include "seed.h"
#include "seen_by_rays.h"

namespace holds_for_test {

using namespace occlude::culler;
using glm::dvec3;
using occlude::seed_of;
using occlude::unless_sanitized;

constexpr unsigned kCameras = unless_sanitized(100'000U, 2000U);

/// By how much the eye, relative to the middle, is in a box of three perpendicular half-edges or in a ball.
Number inside(const EyeRegion& eyes, const Vector& e) {
  if (eyes.radius > 0) return Number{eyes.radius} - glm::length(e);
  Number least = std::numeric_limits<Number>::infinity();
  for (const dvec3& half_edge : eyes.half_edges) {
    const Vector h(half_edge);
    const Number length = glm::length(h);
    least = std::min(least, length - std::fabs(glm::dot(e, h)) / length);
  }
  return least;
}

Number reach(const EyeRegion& eyes, const Vector& unit_vector) {
  Number reach = eyes.radius;
  for (const dvec3& half_edge : eyes.half_edges) reach += std::fabs(glm::dot(Vector(half_edge), unit_vector));
  return reach;
}

/// By how much a frame of `frame` for a model within `depth` does for a camera of one eye.
struct Slack {
  Number eye;      ///< in the region
  Number shown;    ///< what shows is in the half-spaces of all eyes, as a share of the depth; negative: beyond
  Number as_seen;  ///< the same for the camera's eye alone
  Number hiding;   ///< what hides is beyond the camera's near plane
};
Slack slack(const Camera& frame, const Camera& camera, Number depth) {
  const Picture of(frame), asked(camera);
  const Vector moved = Vector(camera.eye) - Vector(frame.eye);
  constexpr Number kInfinity = std::numeric_limits<Number>::infinity();
  Slack slack{frame.eyes.is_point() ? -glm::length(moved) : inside(frame.eyes, moved), kInfinity, kInfinity, kInfinity};
  const Number far = std::min(asked.far, depth), near = std::min(asked.near, far);
  const auto ask = [&](const Vector& normal, Number offset) {
    Number least = kInfinity;
    for (unsigned i = 0; i < 4; ++i) {
      least = std::min({least, glm::dot(normal, asked.corner(i, near)), glm::dot(normal, asked.corner(i, far))});
    }
    least = std::max(least, -depth);  // nothing is farther
    slack.as_seen = std::min(slack.as_seen, (least + offset) / depth);
    slack.shown = std::min(slack.shown, (least + offset + glm::dot(normal, moved) + reach(frame.eyes, normal)) / depth);
  };
  for (const auto& [normal, offset] : of.sides()) ask(normal, offset);
  if (of.far < depth) ask(Number{-1} * of.forward, of.far);
  if (frame.eyes.is_point()) ask(of.forward, -of.near);
  for (unsigned i = 0; i < 4; ++i) {
    slack.hiding = std::min(slack.hiding, (of.near - glm::dot(of.forward, asked.corner(i, asked.near))) / depth);
  }
  return slack;
}

EyeRegion some_eyes(std::mt19937& random) {
  if (random() % 2 == 0) return EyeRegion::ball(uniform(random, 0.01, 2));
  const dvec3 a = random_point(random, 1), b = glm::cross(a, random_point(random, 1)), c = glm::cross(a, b);
  const auto length = [&] { return uniform(random, 0.01, 2); };
  return EyeRegion::box(length() * glm::normalize(a), length() * glm::normalize(b), length() * glm::normalize(c));
}

dvec3 some_eye(std::mt19937& random, const EyeRegion& eyes, double size) {
  if (eyes.radius > 0) return size * eyes.radius * glm::normalize(random_point(random, 1));
  dvec3 e{0, 0, 0};
  for (const dvec3& h : eyes.half_edges) e += size * (random() % 2 == 0 ? 1.0 : uniform(random, -1, 1)) * h;
  return e;
}

/// One of the frame's cameras, somewhat changed.
Camera some_other(std::mt19937& random, const Camera& frame) {
  Camera camera = frame;
  camera.eyes = {};
  const dvec3 moved = random() % 8 == 0 ? dvec3(0) : some_eye(random, frame.eyes, uniform(random, 0, 1.1));
  const double turn = std::array{0.0, 1e-7, 1e-5, 1e-2, 0.1}[random() % 5];
  const dvec3 sight = frame.target - frame.eye;
  camera.eye += moved;
  camera.target = camera.eye + sight + random_point(random, turn);
  if (random() % 2 == 0) camera.up += random_point(random, turn);
  const double least = random() % 2 == 0 ? 0.6 : 0.999;
  camera.fov_y_deg *= random() % 3 == 0 ? 1 : uniform(random, least, 1.001);
  camera.height *= random() % 3 == 0 ? 1 : uniform(random, least, 1.001);
  camera.aspect *= random() % 3 == 0 ? 1 : uniform(random, least, 1.001);
  camera.near_plane *= random() % 3 == 0 ? 1 : uniform(random, least, 1.001);
  if (std::isfinite(camera.far_plane) && random() % 2 == 0) camera.far_plane *= uniform(random, least, 1.001);
  if (random() % 16 == 0) camera.far_plane = std::numeric_limits<double>::infinity();
  return camera;
}

Camera some_frame(std::mt19937& random) {
  Camera frame = random_camera(random);
  const double away = std::array{0.0, 1e3, 1e6}[random() % 3];
  const dvec3 moved = random_point(random, away);
  frame.eye += moved;
  frame.target += moved;
  frame.up = random() % 2 == 0 ? dvec3(0, 0, 1) : random_point(random, 1);
  frame.near_plane = uniform(random, 0.01, 1);
  frame.fov_y_deg = uniform(random, 20, 120);
  frame.aspect = uniform(random, 0.3, 3);
  frame.eyes = random() % 8 == 0 ? EyeRegion{} : some_eyes(random);
  return frame;
}

struct Counts {
  unsigned held = 0, refused = 0;
};

/// What shows beyond a frame's planes by no more than this share of the depth, is within its margins.
constexpr Number kSpare = 0x1p-22L;

TEST(HoldsFor, NeverIsWronglyTrueAndIsTrueWhereThereIsRoom) {
  std::mt19937 random(seed_of(5601));
  Counts counts, parallel;
  for (unsigned k = 0; k < kCameras; ++k) {
    const Camera frame = some_frame(random), camera = some_other(random, frame);
    if (!fault(frame).empty() || !fault(camera).empty()) continue;
    const FrameView view(frame, uniform(random, 5, 500));
    const Slack room = slack(frame, camera, view.depth);
    const bool is_parallel = frame.projection == Projection::orthographic;
    const bool held = holds_for(view, camera);
    Counts& of = is_parallel ? parallel : counts;
    ++(held ? of.held : of.refused);
    const std::string where = "camera " + std::to_string(k);
    if (held) {
      ASSERT_GE(room.eye, 0) << where;
      ASSERT_GE(room.shown, -kSpare) << where;
      ASSERT_GE(room.hiding, -kSpare) << where;
    } else if (!is_parallel || camera.axes().forward == frame.axes().forward) {
      const Number rounding = 0x1p-40L * (1 + std::fabs(frame.eye.x) + std::fabs(frame.eye.y) + std::fabs(frame.eye.z));
      // Turned near planes also need the margin of single precision turned.
      const bool is_turned = camera.axes().forward != frame.axes().forward;
      const Number least = std::min(room.as_seen, is_turned ? room.hiding - 0x1p-18L : room.hiding);
      ASSERT_TRUE(room.eye < (frame.eyes.is_point() ? 0 : rounding) || least < rounding / view.depth) << where;
    }
  }
  EXPECT_GT(counts.held, kCameras / 20);
  EXPECT_GT(counts.refused, kCameras / 20);
  EXPECT_GT(parallel.held, kCameras / 1000);
}

/// A camera that differs from the frame's by an eye alone.
TEST(HoldsFor, CamerasThatDifferByAnEyeOfTheRegion) {
  std::mt19937 random(seed_of(5602));
  for (unsigned k = 0; k < kCameras / 10; ++k) {
    Camera frame = some_frame(random);
    frame.projection = Projection::perspective;
    if (!fault(frame).empty()) continue;
    const FrameView view(frame, uniform(random, 5, 500));
    EXPECT_TRUE(holds_for(view, frame)) << "camera " << k;
    Camera own = frame;
    own.eyes = {};
    EXPECT_TRUE(holds_for(view, own)) << "camera " << k;
    if (frame.eyes.is_point()) continue;
    const double size = 1 + 0x1p-30 * (random() % 2 == 0 ? 1 : -1), away = glm::length(frame.eye);
    if (away > 1e4) continue;  // where the eye's own rounding is more
    own.eye += some_eye(random, frame.eyes, size);
    own.target = own.eye + (frame.target - frame.eye);
    if (size < 1) {
      EXPECT_TRUE(holds_for(view, own)) << "camera " << k;
    } else if (frame.eyes.radius > 0) {
      EXPECT_FALSE(holds_for(view, own)) << "camera " << k;
    }
  }
}

TEST(HoldsFor, RegionsWithinTheRegion) {
  Camera frame{.eye = {1, 2, 3}, .target = {2, 2, 3}, .near_plane = 0.5, .eyes = EyeRegion::box({1, 0, 0}, {0, 0.5, 0})};
  const auto holds_from = [&frame](const FrameView& view, const dvec3& moved, const EyeRegion& eyes) {
    Camera camera = frame;
    camera.eye += moved;
    camera.target += moved;
    camera.eyes = eyes;
    return holds_for(view, camera);
  };
  const FrameView flat(frame, 50);
  EXPECT_TRUE(holds_from(flat, {0.999, -0.499, 0}, {}));
  EXPECT_FALSE(holds_from(flat, {0.25, 0.25, 0x1p-40}, {})) << "the box is flat";
  EXPECT_FALSE(holds_from(flat, {1.001, 0, 0}, {}));
  EXPECT_FALSE(holds_from(flat, {0, 0.501, 0}, {}));
  EXPECT_FALSE(holds_from(flat, {0.25, 0.25, 0}, EyeRegion::ball(0.01)));
  frame.eyes = EyeRegion::box({1, 0, 0}, {0, 0.5, 0}, {0, 0, 0.25});
  const FrameView thick(frame, 50);
  EXPECT_TRUE(holds_from(thick, {0.25, 0.25, 0}, EyeRegion::ball(0.24)));
  EXPECT_FALSE(holds_from(thick, {0.25, 0.25, 0}, EyeRegion::ball(0.2501)));
  EXPECT_FALSE(holds_from(thick, {0.25, 0.3, 0}, EyeRegion::ball(0.21)));
  EXPECT_TRUE(holds_from(thick, {0.25, 0.25, 0}, EyeRegion::box({0, 0, 0.24}, {0.74, 0, 0}, {0, 0.24, 0})));
  EXPECT_FALSE(holds_from(thick, {0.25, 0.25, 0}, EyeRegion::box({0, 0, 0.24}, {0.76, 0, 0}, {0, 0.24, 0})));
}

/// Half-edges that depend on each other are a box that nobody can tell what is in.
TEST(EyeRegions, ContainNothingThatRoundingDecides) {
  const dvec3 some{0.1, 0.2, 0.3};
  for (const EyeRegion& eyes : {EyeRegion{}, EyeRegion::box(some), EyeRegion::box({1, 0, 0}, {1, 0, 0}),
                                EyeRegion::box({1, 2, 0}, {2, 1, 0}, {3, 3, 0}), EyeRegion::ball(1)}) {
    EXPECT_TRUE(contains(eyes, dvec3(0), 0));
    EXPECT_FALSE(contains(eyes, dvec3(0), 2));
    EXPECT_FALSE(contains(eyes, {0, 0, 2}, 0));
  }
  EXPECT_TRUE(contains(EyeRegion::box({1, 0, 0}), {0.5, 0, 0}, 0));
  EXPECT_FALSE(contains(EyeRegion::box({1, 0, 0}), {0.5, 0, 0x1p-60}, 0));
  EXPECT_FALSE(contains(EyeRegion::box({1, 0, 0}), {1.5, 0, 0}, 0));
  EXPECT_FALSE(contains(EyeRegion::box(some), some / 3.0, 0)) << "a third of it is rounded";
  EXPECT_FALSE(contains(EyeRegion::box({1, 2, 0}, {2, 1, 0}, {3, 3, 0}), {0.5, 0.5, 0}, 0)) << "dependent";
  EXPECT_TRUE(contains(EyeRegion::box({0, 1, 0}, {0, 0, 2}), {0, -0.75, 1.75}, 0));
  EXPECT_FALSE(contains(EyeRegion::box({0, 1, 0}, {0, 0, 2}), {0x1p-100, -0.75, 1.75}, 0));
}

/// Matrices: what one of them shows, held against the exact rows.
class Matrices {
 public:
  explicit Matrices(std::mt19937& random) : random_(random) {}

  /// A matrix of a camera, of any kind that is not of parallel rays.
  [[nodiscard]] MatrixCamera frame() {
    Camera camera = some_frame(random_);
    camera.projection = Projection::perspective;
    if (glm::length(camera.eye) > 1e4) camera.eye = {1, 2, 3}, camera.target = {2, 2.5, 2.5};
    if (!fault(camera).empty()) return frame();
    const ClipDepth depth = random_() % 2 == 0 ? ClipDepth::zero_to_w : ClipDepth::minus_w_to_w;
    MatrixCamera of = MatrixCamera::from_camera(camera, depth, random_() % 2 == 0 ? Nearer::less : Nearer::greater);
    if (random_() % 2 == 0) off_centre(of);
    return of;
  }
  /// The same from another eye, somewhat changed.
  [[nodiscard]] MatrixCamera other(const MatrixCamera& frame, double size) {
    MatrixCamera camera = frame;
    camera.eyes = {};
    const dvec3 moved = some_eye(random_, frame.eyes, size);
    camera.matrix = glm::transpose(camera.matrix);
    for (int row = 0; row < 4; ++row) camera.matrix[row][3] -= glm::dot(dvec3(camera.matrix[row]), moved);
    const auto change = [&] { return random_() % 3 == 0 ? 1 : uniform(random_, 0.999, 1.5); };
    camera.matrix[0] *= change();
    camera.matrix[1] *= change();
    camera.matrix = glm::transpose(camera.matrix);
    return camera;
  }

 private:
  void off_centre(MatrixCamera& camera) {
    const double right = uniform(random_, -1, 1), up = uniform(random_, -1, 1);
    for (int k = 0; k < 4; ++k) {
      camera.matrix[k][0] += right * camera.matrix[k][3];
      camera.matrix[k][1] += up * camera.matrix[k][3];
    }
  }

  std::mt19937& random_;
};

/// Whether the matrix shows the point, by more than `room` in clip space relative to w.
bool shows(const MatrixCamera& camera, const Vector& p, Number room) {
  const auto row = [&](int r) {
    return Number{camera.matrix[0][r]} * p.x + Number{camera.matrix[1][r]} * p.y + Number{camera.matrix[2][r]} * p.z +
           Number{camera.matrix[3][r]};
  };
  const Number w = row(3), some = room * std::fabs(w), z = row(2);
  const Number low = camera.depth == ClipDepth::zero_to_w ? 0 : -w;
  return std::fabs(row(0)) <= w + some && std::fabs(row(1)) <= w + some && z >= low - some && z <= w + some;
}

/// No point that a camera shows is beyond the clip volume that the frame's has from the same eye: but for the near plane.
TEST(HoldsFor, MatricesFromOtherEyes) {
  std::mt19937 random(seed_of(5603));
  Matrices matrices(random);
  unsigned held = 0, refused = 0;
  for (unsigned k = 0; k < kCameras / 4; ++k) {
    const MatrixCamera frame = matrices.frame();
    const FrameView view(frame, 100);
    ASSERT_TRUE(holds_for(view, frame));
    if (frame.eyes.is_point()) continue;
    const MatrixCamera camera = matrices.other(frame, uniform(random, 0, 1.1));
    if (!fault(camera).empty()) continue;
    const bool holds = holds_for(view, camera);
    ++(holds ? held : refused);
    if (!holds) continue;
    const dvec3 moved = camera.eye() - frame.eye();
    ASSERT_GE(inside(frame.eyes, Vector(moved)), -1e-9L);
    for (int point = 0; point < 20; ++point) {
      const Vector p(camera.eye() + random_point(random, std::array{1.0, 10.0, 50.0}[random() % 3]));
      if (!shows(camera, p, 0)) continue;
      // Seen by the frame's camera from some eye: here from those at the corners, and from this one.
      const Vector q = p - Vector(moved);
      Number least = std::numeric_limits<Number>::infinity();
      for (const HalfSpace& h : std::vector(view.half_spaces.begin(), view.half_spaces.begin() + view.half_space_count)) {
        least = std::min(least, glm::dot(Vector(h.normal), p) + Number{h.offset});
      }
      ASSERT_GE(least, 0x1p-20L * 100 * 0.6L) << k << ' ' << static_cast<double>(q.x);
    }
  }
  EXPECT_GT(held, kCameras / 100);
  EXPECT_GT(refused, kCameras / 100);
}

TEST(HoldsFor, NothingSeenIsCulledByFramesThatHold) {
  std::mt19937 random(seed_of(5604));
  const Culler culler(random_town_of_houses(56, 1500), {.hierarchy = {.leaf_size = 4}});
  unsigned rays = 0, held = 0;
  for (unsigned k = 0; k < kCameras / 1000; ++k) {
    Camera frame = random_camera(random);
    frame.projection = Projection::perspective;
    frame.eyes = some_eyes(random);
    frame.near_plane = 0.2;
    CullOptions options{.method = k % 4 == 0 ? Method::frusta : Method::cover};
    options.cover = {.width = 256, .height = 144};
    View view;
    EXPECT_FALSE(view.holds_for(frame)) << "there is no frame";
    culler.cull(frame, options, view);
    EXPECT_TRUE(view.holds_for(frame));
    for (unsigned other = 0; other < 10; ++other) {
      const Camera camera = some_other(random, frame);
      if (!fault(camera).empty() || !view.holds_for(camera)) continue;
      ++held;
      rays += expect_hidden(culler, drawn_polygons(culler, view.result()), camera, random, 1);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(held, kCameras / 1000);
  EXPECT_GT(rays, kCameras / 10);
}

TEST(HoldsFor, FramesOfScenes) {
  Scene scene;
  scene.add(occlude::kernel::Aabb{{10, -1, -1}, {11, 1, 1}});
  scene.update();
  Camera frame{.eye = {0, 0, 0}, .target = {1, 0, 0}, .near_plane = 0.5, .eyes = EyeRegion::ball(1)};
  Camera camera = frame;
  camera.eyes = {};
  camera.eye.x = camera.target.y = 0.25;
  camera.target.x = 100;
  SceneView view;
  EXPECT_FALSE(view.holds_for(frame));
  scene.cull(frame, {}, view);
  EXPECT_TRUE(view.holds_for(frame));
  EXPECT_FALSE(view.holds_for(camera));
  camera.fov_y_deg = 30;
  camera.near_plane = 0.4;
  EXPECT_TRUE(view.holds_for(camera));
  EXPECT_TRUE(view.holds_for(matrix_of(camera)));
  EXPECT_NE(refusal([&] { static_cast<void>(view.holds_for(Camera{.near_plane = -1})); }), "");
}

}  // namespace holds_for_test
