// SPDX-License-Identifier: MIT
// Tours show what there is to see, and never go through a triangle, wherever, however large and however turned a model is.
#include "occlude/render/tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "occlude/kernel/orientation.h"
#include "tour/scenes.h"

namespace occlude::render {
namespace tour_test {

using culler::PolygonSoup;
using glm::dvec3;

kernel::Vec3 exact(const dvec3& v) { return {v.x, v.y, v.z}; }

/// Whether two closed segments in one plane share a point, seen along an axis in which the plane is not a line.
bool segments_meet(int axis, const dvec3& p, const dvec3& q, const dvec3& a, const dvec3& b) {
  const auto turn = [&](const dvec3& u, const dvec3& v, const dvec3& w) {
    return kernel::turn(axis, exact(u), exact(v), exact(w));
  };
  if (turn(p, q, a) * turn(p, q, b) > 0 || turn(a, b, p) * turn(a, b, q) > 0) return false;
  for (int k = 0; k < 3; ++k) {  // collinear ones meet if their boxes do
    if (std::max(p[k], q[k]) < std::min(a[k], b[k]) || std::max(a[k], b[k]) < std::min(p[k], q[k])) return false;
  }
  return true;
}

/// Whether a closed segment and a closed triangle share a point, exactly. A triangle without area is not drawn.
bool meets(const dvec3& p, const dvec3& q, const std::array<dvec3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const auto side = [&](const dvec3& u, const dvec3& v, const dvec3& w, const dvec3& x) {
    return kernel::orientation(exact(u), exact(v), exact(w), exact(x));
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int turn = kernel::turn(axis, exact(a), exact(b), exact(c));
    if (turn == 0) continue;
    const int of_p = side(a, b, c, p), of_q = side(a, b, c, q);
    if (of_p * of_q > 0) return false;
    if (of_p != 0 || of_q != 0) {
      const int ab = side(p, q, a, b), bc = side(p, q, b, c), ca = side(p, q, c, a);
      return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
    }
    const auto inside = [&](const dvec3& u, const dvec3& v) {
      return kernel::turn(axis, exact(u), exact(v), exact(p)) * turn >= 0;
    };
    return (inside(a, b) && inside(b, c) && inside(c, a)) || segments_meet(axis, p, q, a, b) ||
           segments_meet(axis, p, q, b, c) || segments_meet(axis, p, q, c, a);
  }
  return false;
}

/// Whether a point of a lattice over the triangle is as near to p as this.
bool is_near(const dvec3& p, const std::array<dvec3, 3>& triangle, double distance) {
  const auto& [a, b, c] = triangle;
  if (glm::distance(p, glm::clamp(p, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)))) > distance) return false;
  constexpr int kParts = 12;
  for (int i = 0; i <= kParts; ++i) {
    for (int j = 0; i + j <= kParts; ++j) {
      const double s = 1.0 * i / kParts, t = 1.0 * j / kParts;
      if (glm::distance(p, (1 - s - t) * a + s * b + t * c) <= distance) return true;
    }
  }
  return false;
}

std::vector<std::array<dvec3, 3>> triangles(const PolygonSoup& soup) {
  std::vector<std::array<dvec3, 3>> result;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      result.push_back({soup.vertices[loop[0]], soup.vertices[loop[i]], soup.vertices[loop[i + 1]]});
  }
  return result;
}

/// What make_tour() promises, by brute force.
void expect_free(const PolygonSoup& soup, const CameraPath& path) {
  ASSERT_GE(path.frames, 300U);
  ASSERT_LE(path.frames, 3000U);
  ASSERT_EQ(path.keyframes.size(), path.frames);
  constexpr double kWide = 2.8;
  const double corner = path.near * std::sqrt(1 + (1 + kWide * kWide) / 3);
  const auto all = triangles(soup);
  for (std::size_t frame = 0; frame < path.frames; ++frame) {
    const culler::Camera camera = path.camera(frame, kWide);
    ASSERT_EQ(culler::fault(camera), "") << "frame " << frame;
    const dvec3 next = path.camera(std::min(frame + 1, path.frames - 1), kWide).eye;
    for (const auto& triangle : all) {
      ASSERT_FALSE(meets(camera.eye, next, triangle)) << "frame " << frame;
      ASSERT_FALSE(is_near(camera.eye, triangle, corner)) << "frame " << frame;
    }
  }
}

constexpr dvec3 kUp(0, 0, 1);

std::vector<dvec3> eyes(const CameraPath& path) {
  std::vector<dvec3> result;
  for (const auto& keyframe : path.keyframes) result.push_back(keyframe.eye);
  return result;
}

/// The share of the eyes for which the question is answered with yes.
template <class Question>
double share(const CameraPath& path, Question&& question) {
  const auto all = eyes(path);
  return static_cast<double>(std::count_if(all.begin(), all.end(), question)) / static_cast<double>(all.size());
}

TEST(Tour, WalksThroughADoor) {
  const PolygonSoup soup = scenes::two_rooms();
  const Tour tour = make_tour(soup, kUp, TourKind::automatic);
  EXPECT_EQ(tour.kind, TourKind::walk);
  expect_free(soup, tour.path);
  EXPECT_GT(share(tour.path, [](const dvec3& eye) { return eye.x < 5; }), 0.2);
  EXPECT_GT(share(tour.path, [](const dvec3& eye) { return eye.x > 7; }), 0.2);
  EXPECT_EQ(share(tour.path, [](const dvec3& eye) { return std::fabs(eye.z - 1.7) < 0.01; }), 1);
}

TEST(Tour, WalksInTheStreetRatherThanOnRoofsAndThePlain) {
  const PolygonSoup soup = scenes::street();
  const Tour tour = make_tour(soup, kUp, TourKind::automatic);
  EXPECT_EQ(tour.kind, TourKind::walk);
  expect_free(soup, tour.path);
  EXPECT_GT(share(tour.path, [](const dvec3& eye) { return std::fabs(eye.y) < 4 && std::fabs(eye.x) < 42; }), 0.8);
  EXPECT_EQ(share(tour.path, [](const dvec3& eye) { return eye.z < 2; }), 1);
}

TEST(Tour, ClimbsStairs) {
  const PolygonSoup soup = scenes::stairs();
  const Tour tour = make_tour(soup, kUp, TourKind::automatic);
  EXPECT_EQ(tour.kind, TourKind::walk);
  expect_free(soup, tour.path);
  EXPECT_GT(share(tour.path, [](const dvec3& eye) { return eye.z < 1.75; }), 0.1);
  EXPECT_GT(share(tour.path, [](const dvec3& eye) { return eye.z > 4.15; }), 0.1);
}

TEST(Tour, WalksWhicheverWayTheFloorTurns) {
  PolygonSoup soup = scenes::street();
  for (std::size_t p = 0; p < soup.size(); ++p)
    std::reverse(soup.indices.begin() + soup.first[p], soup.indices.begin() + soup.first[p + 1]);
  EXPECT_EQ(make_tour(soup, kUp, TourKind::automatic).kind, TourKind::walk);
}

TEST(Tour, GoesRoundAClosedBox) {
  const PolygonSoup soup = scenes::closed_box();
  for (const TourKind kind : {TourKind::automatic, TourKind::fly, TourKind::orbit}) {
    const Tour tour = make_tour(soup, kUp, kind);
    EXPECT_EQ(tour.kind, TourKind::orbit) << to_string(kind);
    expect_free(soup, tour.path);
    for (const double angle : {0.0, 1.5, 3.0, 4.5}) {
      EXPECT_GT(share(tour.path,
                      [&](const dvec3& eye) {
                        return glm::dot(eye - 5.0, {std::cos(angle), std::sin(angle), 0}) > 8;
                      }),
                0.2);
    }
  }
}

TEST(Tour, FliesIntoAHole) {
  const PolygonSoup soup = scenes::hollow_box();
  const Tour tour = make_tour(soup, kUp, TourKind::fly);
  EXPECT_EQ(tour.kind, TourKind::fly);
  expect_free(soup, tour.path);
  EXPECT_GT(share(tour.path, [](const dvec3& eye) { return glm::length(eye - 5.0) < 4; }), 0.02);
  EXPECT_GT(eyes(tour.path).front().z, 10);
  EXPECT_GT(glm::length(eyes(tour.path).back() - 5.0), 9);
}

TEST(Tour, WalksOverALandscapeOnlyIfAsked) {
  const PolygonSoup soup = scenes::landscape();
  EXPECT_EQ(make_tour(soup, kUp, TourKind::automatic).kind, TourKind::orbit);
  const Tour tour = make_tour(soup, kUp, TourKind::walk);
  EXPECT_EQ(tour.kind, TourKind::walk);
  expect_free(soup, tour.path);
  for (const dvec3& eye : eyes(tour.path)) EXPECT_NEAR(eye.z - scenes::landscape_height(eye.x, eye.y), 1.7, 0.3);
}

TEST(Tour, IsTheSameEveryTime) {
  for (const TourKind kind : {TourKind::automatic, TourKind::fly}) {
    const PolygonSoup soup = scenes::two_rooms();
    const auto one = make_tour(soup, kUp, kind).path, other = make_tour(soup, kUp, kind).path;
    EXPECT_EQ(eyes(one), eyes(other));
  }
}

TEST(Tour, OfWhatHasNoExtent) {
  PolygonSoup point;
  point.add_polygon(std::array{point.add_vertex({0, 0, 0}), 0U, 0U});
  PolygonSoup line;
  line.add_polygon(std::array{line.add_vertex({1, 2, 3}), line.add_vertex({1, 2, 4}), line.add_vertex({1, 2, 5})});
  PolygonSoup triangle;
  triangle.add_polygon(
      std::array{triangle.add_vertex({0, 0, 0}), triangle.add_vertex({5, 0, 0}), triangle.add_vertex({0, 0, 5})});
  for (const PolygonSoup* soup : {&point, &line, &triangle}) {
    for (const TourKind kind : {TourKind::automatic, TourKind::walk, TourKind::fly, TourKind::orbit}) {
      const Tour tour = make_tour(*soup, kUp, kind);
      EXPECT_EQ(tour.kind, TourKind::orbit);
      expect_free(*soup, tour.path);
    }
  }
}

TEST(Tour, RefusesAModelWithNothingOutside) {
  PolygonSoup soup;
  soup.add_box(dvec3(-0x1p100), dvec3(0x1p100));
  EXPECT_THROW(static_cast<void>(make_tour(soup, kUp, TourKind::automatic)), std::invalid_argument);
}

TEST(Tour, StopsWhereItIsTold) {
  struct Stop {};
  const PolygonSoup soup = scenes::two_rooms();
  EXPECT_THROW(static_cast<void>(make_tour(soup, kUp, TourKind::automatic, [] { throw Stop(); })), Stop);
}

/// A copy of a scene elsewhere, of another size, with another axis up.
struct Copy {
  double scale;
  dvec3 offset;
  std::array<dvec3, 3> axes;

  [[nodiscard]] PolygonSoup of(PolygonSoup soup) const {
    for (dvec3& v : soup.vertices) v = offset + scale * (v.x * axes[0] + v.y * axes[1] + v.z * axes[2]);
    return soup;
  }
};

constexpr std::array<dvec3, 3> kZ{dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)};
constexpr std::array<dvec3, 3> kY{dvec3(0, 0, 1), dvec3(1, 0, 0), dvec3(0, 1, 0)};
constexpr std::array<dvec3, 3> kMinusX{dvec3(0, 1, 0), dvec3(0, 0, -1), dvec3(-1, 0, 0)};
constexpr std::array<dvec3, 3> kOblique{dvec3(0.8, 0, -0.6), dvec3(0, 1, 0), dvec3(0.6, 0, 0.8)};
constexpr Copy kResized[] = {
    {0x1p-20, dvec3(0), kZ}, {0x1p-90, dvec3(0), kZ}, {0x1p+80, dvec3(0), kY}, {1, dvec3(0x1p60), kZ}};
constexpr Copy kMoved[] = {{1, dvec3(0x1p30, -0x1p30, 7), kMinusX}, {1, dvec3(-300, 50, 1e5), kOblique}};

class EveryScene : public testing::TestWithParam<PolygonSoup (*)()> {};

TEST_P(EveryScene, OfAnySizeKeepsThePromise) {
  for (const Copy& copy : kResized) {
    const PolygonSoup soup = copy.of(GetParam()());
    for (const TourKind kind : {TourKind::walk, TourKind::fly}) {
      SCOPED_TRACE("scaled by " + std::to_string(copy.scale) + ": " + std::string(to_string(kind)));
      expect_free(soup, make_tour(soup, copy.axes[2], kind).path);
    }
  }
}

TEST_P(EveryScene, IsTouredInTheSameWayAnywhere) {
  const PolygonSoup original = GetParam()();
  for (const TourKind asked : {TourKind::automatic, TourKind::walk, TourKind::fly}) {
    const TourKind kind = make_tour(original, kUp, asked).kind;
    for (const Copy& copy : kMoved) {
      const PolygonSoup soup = copy.of(original);
      const Tour tour = make_tour(soup, copy.axes[2], asked);
      EXPECT_EQ(tour.kind, kind) << to_string(asked);
      expect_free(soup, tour.path);
    }
  }
}

PolygonSoup random_triangles() { return scenes::random_triangles(1); }

INSTANTIATE_TEST_SUITE_P(Tour, EveryScene,
                         testing::Values(scenes::two_rooms, scenes::street, scenes::stairs, scenes::closed_box,
                                         scenes::hollow_box, scenes::pit, scenes::landscape, random_triangles));

}  // namespace tour_test
}  // namespace occlude::render
