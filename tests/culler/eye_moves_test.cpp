// SPDX-License-Identifier: MIT
// What the eyes of a region do in a picture with a plane in focus: positions, boxes, edges and planes hold from each of
// them.
#include "cover/eye_moves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <iostream>
#include <limits>
#include <random>

#include "camera/frame_view.h"
#include "cover/conservative_viewport.h"
#include "cover/cover_buffer.h"
#include "cover/layer_erosion.h"
#include "cover/projected_boxes.h"
#include "cover/projected_plane.h"
#include "scenes.h"
#include "seed.h"

namespace occlude::culler {
namespace eye_moves_test {

using Real = long double;
using Vector = glm::vec<3, Real>;

/// A picture of several eyes, and what one of them sees in it.
class EyeMovesTest : public testing::Test {
 protected:
  void SetUp() override { std::cout << "seed " << seed_of(1) << "\n"; }

  struct Place {
    Real x, y, nearness;  ///< in pixels; 1 over the distance along the line of sight from the middle
  };

  [[nodiscard]] double number(double low, double high) { return uniform(random_, low, high); }
  [[nodiscard]] glm::dvec3 some_vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }
  [[nodiscard]] double some_size(double low, double high) { return std::exp(number(std::log(low), std::log(high))); }

  void next_picture() {
    Camera camera;
    camera.eye = 100.0 * some_vector();
    camera.target = camera.eye + some_vector();
    camera.fov_y_deg = number(20, 100);
    camera.near_plane = some_size(0.01, 2);
    const double size = some_size(0.01, 3);
    switch (random_() % 3) {
      case 0:
        camera.eyes = EyeRegion::ball(size);
        break;
      case 1:
        camera.eyes = EyeRegion::box(size * some_vector(), 0.3 * size * some_vector(), 0.1 * some_vector());
        break;
      default:
        camera.eyes = EyeRegion::box(size * camera.axes().forward, 0.1 * camera.axes().right);
    }
    eyes_ = camera.eyes;
    view_ = FrameView(camera, kDepth);
    picture_ = ConservativeViewport(view_, {512, 288, 16}, 0);
    focus_ = number(0, 1) * number(0, 1) * picture_.most_focus();
  }

  /// At any place beyond the near cut, often close to it and to the side.
  [[nodiscard]] glm::dvec3 some_point() {
    const double forward = picture_.near() * (1 + some_size(1e-3, 1e3));
    return point(number(-2, 2) * forward, number(-2, 2) * forward, forward);
  }
  [[nodiscard]] glm::dvec3 point(double right, double up, double forward) const {
    return picture_.eye() + right * picture_.right() + up * picture_.up() + forward * picture_.forward();
  }
  [[nodiscard]] bool is_beyond(const glm::dvec3& p) const { return picture_.eye_point(p).forward >= picture_.near(); }

  /// At a corner, on the sphere, or anywhere in the region.
  [[nodiscard]] Vector some_eye() {
    if (eyes_.radius > 0) {
      const Vector direction = glm::normalize(Vector(some_vector()));
      return direction * Real(eyes_.radius * (random_() % 2 == 0 ? 1.0 : number(0, 1)));
    }
    Vector eye(0);
    for (const glm::dvec3& h : eyes_.half_edges) {
      eye += Vector(h) * Real(random_() % 2 == 0 ? (random_() % 2 == 0 ? 1.0 : -1.0) : number(-1, 1));
    }
    return eye;
  }

  [[nodiscard]] Place seen_from(const Vector& eye, const Vector& p) const {
    const auto along = [](const glm::dvec3& axis, const Vector& v) { return glm::dot(Vector(axis), v); };
    const Vector y = p - Vector(picture_.eye());
    const Vector e(along(picture_.right(), eye), along(picture_.up(), eye), along(picture_.forward(), eye));
    const Vector v(along(picture_.right(), y), along(picture_.up(), y), along(picture_.forward(), y));
    const Real focus = focus_, left = 1 - focus * e.z, forward = v.z - e.z;
    const Real x = focus * e.x + (v.x - e.x) / forward * left, up = focus * e.y + (v.y - e.y) / forward * left;
    return {picture_.middle().x + picture_.scale().x * x, picture_.middle().y + picture_.scale().y * up, 1 / v.z};
  }

  /// The vector whose product with `a` is 1, and with the others 0.
  [[nodiscard]] static Vector dual(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const Vector across = glm::cross(Vector(b), Vector(c));
    return across / glm::dot(Vector(a), across);
  }

  static constexpr double kDepth = 4000;
  std::mt19937 random_{seed_of(1)};
  EyeRegion eyes_;
  FrameView view_;
  ConservativeViewport picture_;
  double focus_ = 0;
};

TEST_F(EyeMovesTest, HoldPositions) {
  std::size_t tight = 0, all = 0;
  for (int i = 0; i < 4000; ++i) {
    next_picture();
    const glm::dvec3 p = some_point();
    if (!is_beyond(p)) continue;
    const MovedPosition moved = picture_.moving(picture_.eye_point(p)).at(focus_);
    Real nearest = std::numeric_limits<Real>::infinity();
    for (int k = 0; k < 32; ++k) {
      const Place at = seen_from(some_eye(), Vector(p));
      ASSERT_GE(at.x, moved.low.x - moved.error);
      ASSERT_LE(at.x, moved.high.x + moved.error);
      ASSERT_GE(at.y, moved.low.y - moved.error);
      ASSERT_LE(at.y, moved.high.y + moved.error);
      nearest = std::min({nearest, at.x - moved.low.x, moved.high.x - at.x, at.y - moved.low.y, moved.high.y - at.y});
    }
    ++all;
    tight += nearest < 0.1 * std::max(moved.high.x - moved.low.x, moved.high.y - moved.low.y) ? 1 : 0;
  }
  EXPECT_GT(tight, all / 2) << "the bounds are much too large";
}

TEST_F(EyeMovesTest, HoldBoxes) {
  std::size_t known = 0, tight = 0;
  for (int i = 0; i < 20000; ++i) {
    next_picture();
    FocusLayers in_focus;
    in_focus.focus[0] = static_cast<float>(focus_);
    focus_ = in_focus.focus[0];
    const glm::dvec3 low = some_point(), high = low + some_size(1e-4, 1) * glm::abs(some_vector());
    const BoxPicture picture(picture_, {0, 0}, in_focus);
    ProjectedBoxes boxes;
    boxes.add(picture, {{low.x, low.y, low.z}, {high.x, high.y, high.z}});
    boxes.project(picture);
    if (boxes.most[0] == std::numeric_limits<float>::infinity()) continue;
    ++known;
    int leftmost = picture_.width();
    for (int k = 0; k < 32; ++k) {
      const glm::dvec3 share = 0.5 * (some_vector() + 1.0),
                       p = low + (k % 2 == 0 ? glm::round(share) : share) * (high - low);
      const Place at = seen_from(some_eye(), Vector(p));
      const int x = pixel_at(static_cast<double>(at.x), picture_.width()),
                y = pixel_at(static_cast<double>(at.y), picture_.height());
      ASSERT_TRUE(boxes.x0[0] <= x && x < boxes.x1[0]) << "box " << i;
      ASSERT_TRUE(boxes.y0[0] <= y && y < boxes.y1[0]) << "box " << i;
      ASSERT_LE(at.nearness, boxes.most[0]) << "box " << i;
      leftmost = std::min(leftmost, x);
    }
    tight += leftmost <= boxes.x0[0] + 1 ? 1 : 0;
  }
  EXPECT_GT(known, 10000U);
  EXPECT_GT(tight, known / 2) << "the bounds are much too large";
}

/// What a layer starts with is not closure, and must hide no box that asks it.
TEST_F(EyeMovesTest, BoxesAskLayersThatStartNoNearer) {
  std::size_t around = 0;
  for (int i = 0; i < 200; ++i) {
    next_picture();
    CoverBuffer buffer;
    buffer.begin(view_, 64, 64, 0);
    const BoxPicture& picture = buffer.box_picture();
    for (std::size_t layer = 0; layer < picture.layers.count; ++layer) {
      const double distance =
          (1 + std::ldexp(number(-1, 1), -static_cast<int>(random_() % 30))) / picture.layers.focus[layer];
      const glm::dvec3 p = point(0, 0, distance);
      ProjectedBoxes boxes;
      boxes.add(picture, {{p.x, p.y, p.z}, {p.x, p.y, p.z}});
      boxes.project(picture);
      for (const BoxPixels* asked : std::initializer_list<const BoxPixels*>{&boxes, &boxes.nearer_layer}) {
        const auto at = static_cast<std::size_t>(asked->first_tile[0] / picture.tiles_of_layer);
        ASSERT_LE(picture.layers.start(at), boxes.most[0]) << "picture " << i << ", layer " << layer;
        around += at == layer ? 1 : 0;
      }
    }
  }
  EXPECT_GT(around, 1000U);
}

/// The rays of a pixel pass the next nearer layer in the pixels through which it may take over that they are closed.
TEST_F(EyeMovesTest, HoldRaysInTheNextLayer) {
  std::size_t tight = 0, all = 0;
  for (int i = 0; i < 2000; ++i) {
    next_picture();
    FocusLayers layers;
    layers.count = 2;
    layers.focus[0] = static_cast<float>(number(0, 1) * number(0, 1) * picture_.most_focus());
    layers.focus[1] = static_cast<float>(number(layers.focus[0], picture_.most_focus()));
    LayerErosion erosion;
    erosion.begin(picture_, layers);
    const int x = static_cast<int>(number(0, 512)), y = static_cast<int>(number(0, 288));
    const PixelRectangle pixel{x, y, x + 1, y + 1}, through = erosion.through(0, pixel);
    if (through.x1 - through.x0 > 64 || through.y1 - through.y0 > 64) continue;  // nothing is taken over
    ++all;
    Real nearest = std::numeric_limits<Real>::infinity();
    for (int k = 0; k < 32; ++k) {
      // A ray passes the plane in focus at a point; the next layer sees this point like any other.
      const auto side = [&] { return k % 2 == 0 ? static_cast<double>(random_() % 2) : number(0, 1); };
      const PixelPosition slope = picture_.slope(x + side(), y + side());
      const Real distance = 1 / Real(layers.focus[0]);
      const Vector p =
          Vector(picture_.eye()) + distance * (Real(slope.x) * dual(picture_.right(), picture_.up(), picture_.forward()) +
                                               Real(slope.y) * dual(picture_.up(), picture_.forward(), picture_.right()) +
                                               dual(picture_.forward(), picture_.right(), picture_.up()));
      focus_ = layers.focus[1];
      const Place at = seen_from(some_eye(), p);
      constexpr Real kRounded = 1e-10;  // of the positions of this test
      ASSERT_GE(at.x, through.x0 - kRounded) << "picture " << i;
      ASSERT_LE(at.x, through.x1 + kRounded) << "picture " << i;
      ASSERT_GE(at.y, through.y0 - kRounded) << "picture " << i;
      ASSERT_LE(at.y, through.y1 + kRounded) << "picture " << i;
      nearest = std::min({nearest, at.x - through.x0, through.x1 - at.x, at.y - through.y0, through.y1 - at.y});
    }
    tight += nearest < 1 ? 1 : 0;
  }
  EXPECT_GT(all, 1000U);
  EXPECT_GT(tight, all / 2) << "the bounds are much too large";
}

/// Of long edges and of such as are shorter than the moves, whose ends may pass each other.
TEST_F(EyeMovesTest, HoldEdges) {
  for (int i = 0; i < 20000; ++i) {
    next_picture();
    const glm::dvec3 p = some_point();
    const glm::dvec3 q = i % 2 == 0 ? some_point() : p + some_size(1e-3, 1) * some_vector();
    if (!is_beyond(p) || !is_beyond(q)) continue;
    const MovingPosition from = picture_.moving(picture_.eye_point(p)), to = picture_.moving(picture_.eye_point(q));
    const SweptEdge swept = picture_.swept(picture_.moving(from.still, to.still), from.still, to.still, focus_);
    for (int k = 0; k < 16; ++k) {
      const Real share = k % 4 == 0 ? 0 : k % 4 == 1 ? 1 : number(0, 1);
      const Place at = seen_from(some_eye(), Vector(p) + share * (Vector(q) - Vector(p)));
      for (std::size_t c = 0; c < 4; ++c) {
        const PixelPosition &a = swept.corners[c], &b = swept.corners[(c + 1) % 4];
        const Real x = Real(b.x) - a.x, y = Real(b.y) - a.y, length = std::sqrt(x * x + y * y);
        if (length == 0) continue;
        const Real inside = (x * (at.y - a.y) - y * (at.x - a.x)) / length;
        ASSERT_GE(inside, -2 * Real(swept.error)) << "edge " << i << ", side " << c;
      }
    }
  }
}

TEST_F(EyeMovesTest, HoldPlanes) {
  std::size_t known = 0, tight = 0;
  const auto reach = [&] {
    const PixelPosition high = picture_.slope(512, 288);
    return 40 * (high.x + high.y);
  };
  for (int i = 0; i < 20000; ++i) {
    next_picture();
    const std::array<glm::dvec3, 3> t{some_point(), some_point(), some_point()};
    if (!std::ranges::all_of(t, [&](const glm::dvec3& p) { return is_beyond(p); })) continue;
    const ProjectedPlane plane(picture_, reach(), picture_.eye_point(t[0]), picture_.eye_point(t[1]),
                               picture_.eye_point(t[2]));
    if (!plane.is_known()) continue;
    ++known;
    for (int k = 0; k < 16; ++k) {
      const Real a = number(0, 1), b = (1 - a) * Real(number(0, 1));
      const Place at = seen_from(some_eye(), a * Vector(t[0]) + b * Vector(t[1]) + (1 - a - b) * Vector(t[2]));
      const Real x = (at.x - picture_.middle().x) / picture_.scale().x,
                 y = (at.y - picture_.middle().y) / picture_.scale().y;
      if (std::fabs(x) + std::fabs(y) > reach()) continue;
      Real bound = std::numeric_limits<Real>::infinity();
      for (const PlaneBound& of : plane.bounds(focus_)) {
        bound = std::min(bound, (of.constant + of.of_x * x + of.of_y * y) * Real(of.scale));
      }
      ASSERT_LE(bound, at.nearness * (1 + 0x1p-40L)) << "plane " << i;
      tight += bound > 0.9L * at.nearness ? 1 : 0;
    }
  }
  EXPECT_GT(known, 3000U);
  EXPECT_GT(tight, 4 * known) << "the bounds are much too small";
}

/// By hand: a focus at twice the distance of a point, and an eye that is 1 to the right and 1 ahead.
TEST(EyeMoves, OfAPointByHand) {
  const Camera::Axes axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  // The point is (0.5, 0, 1) / 0.25 = (2, 0, 4). From the eye (1, 0, 1) the ray (1, 0, 3) passes z = 8 at 1 + 7 / 3; over 8
  // that is 5 / 12, a move of -1 / 12, which is f - k = -1 / 8 times 2 / 3.
  const EyeMoves::Range range = EyeMoves(EyeRegion::box({1, 0, 1}), axes).along(1, 0, 0.5, 0, 0.25);
  EXPECT_DOUBLE_EQ(range.high, 2.0 / 3);
  // From (-1, 0, -1) the ray (3, 0, 5) passes it at -1 + 27 / 5: 11 / 20, a move of 1 / 20.
  EXPECT_DOUBLE_EQ(range.low, -2.0 / 5);
  // A ball around the eye of a point straight ahead moves it to both sides alike, by r / sqrt(1 - (r k)^2).
  const EyeMoves::Range ball = EyeMoves(EyeRegion::ball(2), axes).along(0, 1, 0, 0, 0.25);
  EXPECT_DOUBLE_EQ(ball.high, 2 / std::sqrt(0.75));
  EXPECT_DOUBLE_EQ(ball.low, -ball.high);
}

/// The more the eyes move what is far, the more layers there are: few where they hardly do, and most for a ball in a room.
TEST(FocusLayers, AreAsManyAsTheEyesMoveWhatIsFarBy) {
  const auto layers = [](const EyeRegion& eyes, double depth) {
    Camera camera;
    camera.eyes = eyes;
    return FocusLayers(ConservativeViewport(FrameView(camera, depth), {576, 360, 60}, 0));
  };
  const auto count = [&](const EyeRegion& eyes, double depth) { return layers(eyes, depth).count; };
  EXPECT_EQ(count(EyeRegion::ball(0), 1000), 1U) << "one eye";
  std::size_t before = 4;
  for (const double depth : {1e5, 1e4, 3e3, 1e3, 300.0, 100.0, 10.0}) {
    const std::size_t found = count(EyeRegion::ball(0.25), depth);
    EXPECT_GE(found, before) << depth;
    before = found;
  }
  EXPECT_EQ(count(EyeRegion::ball(0.25), 1e5), 4U);
  EXPECT_EQ(count(EyeRegion::ball(0.25), 10), FocusLayers::kMost);
  EXPECT_EQ(count(EyeRegion::box({0.25, 0, 0}, {0, 0.25, 0}), 10), 8U) << "a box";
  EXPECT_EQ(layers(EyeRegion::ball(0.25), 1e4).beyond, 1U);
  EXPECT_EQ(layers(EyeRegion::ball(0.25), 300).beyond, 2U) << "a castle";
  EXPECT_EQ(layers(EyeRegion::ball(0.25), 10).beyond, 1U) << "a room";
}

}  // namespace eye_moves_test
}  // namespace occlude::culler
