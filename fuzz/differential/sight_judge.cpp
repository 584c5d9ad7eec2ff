// SPDX-License-Identifier: MIT
#include "sight_judge.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "cases/to_oracle.h"
#include "occlude/fuzz/case.h"
#include "occlude/oracle/region.h"
#include "occlude/oracle/sight.h"
#include "report.h"

namespace occlude::fuzz {
namespace {

using oracle::Point;

/// a + factor b, rounded.
Point plus(const Point& a, double factor, const Point& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Point eye_of_box(Random& random, const oracle::Obb& box, std::size_t corner) {
  Point eye = box.center;
  for (std::size_t i = 0; i < 3; ++i) {
    const double side = (corner >> i & 1U) != 0 ? 1 : -1;
    eye = plus(eye, corner < 8 || random.chance(0.4) ? side : random.integer(-15, 15) / 16.0, box.half_edges[i]);
  }
  return eye;
}

Point eye_of_ball(Random& random, const oracle::Ball& ball, std::size_t number) {
  Point direction{};
  if (number < 6) {
    direction[number / 2] = number % 2 == 0 ? 1 : -1;
    return plus(ball.center, ball.radius, direction);
  }
  for (double& coordinate : direction) coordinate = random.real(-1, 1);
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  return plus(ball.center, (1 - 0x1p-40) * ball.radius / std::max(length, 1.0), direction);
}

std::vector<oracle::Triangle> triangles_of(culler::SoupView soup) {
  const auto at = [&](std::uint32_t i) {
    const auto& v = soup.vertices[i];
    return Point{v.x, v.y, v.z};
  };
  std::vector<oracle::Triangle> triangles;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; soup.is_opaque(p) && i + 1 < loop.size(); ++i) {
      triangles.push_back({at(loop[0]), at(loop[i]), at(loop[i + 1])});
    }
  }
  return triangles;
}

constexpr std::size_t kEyes = 16, kPointsOfEye = kLinesOfCull / kEyes;

}  // namespace

std::vector<Point> some_eyes(Random& random, const oracle::EyeRegion& region) {
  std::vector<Point> eyes;
  for (std::size_t i = 0; i < kEyes; ++i) {
    const oracle::Ball* const ball = std::get_if<oracle::Ball>(&region);
    const Point eye = ball ? eye_of_ball(random, *ball, i) : eye_of_box(random, std::get<oracle::Obb>(region), i);
    const bool is_in =
        ball ? oracle::contains(*ball, eye) : oracle::contains(oracle::Box(std::get<oracle::Obb>(region)), eye);
    if (is_in) eyes.push_back(eye);
  }
  return eyes;
}

Point some_point(Random& random, const kernel::Aabb& box) {
  const bool is_corner = random.chance(0.5);
  Point point{};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.min[axis], high = box.max[axis],
                 share = random.chance(0.5) ? random.integer(0, 1) : random.real(0, 1);
    point[static_cast<std::size_t>(axis)] =
        is_corner ? (random.chance(0.5) ? low : high) : std::clamp(low + share * (high - low), low, high);
  }
  return point;
}

std::string fault_of_sight(Random& random, const culler::Culler& culler, const proof::AnyCamera& camera,
                           const culler::CullResult& result, std::uint64_t& lines) {
  const auto is_by_cover = [](const culler::Culled& culled) { return culled.by == culler::Culled::By::cover; };
  const proof::Eyes region = proof::eyes_of(camera);
  if (!region || std::ranges::none_of(result.culled, is_by_cover)) return "";
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  const oracle::Aabb model = to_oracle(hierarchy.nodes()[0].box);
  oracle::Sight sight(triangles_of(hierarchy.soup()), proof::drawn(camera, model));
  const std::vector<Point> eyes = some_eyes(random, *region);
  for (const culler::Culled& culled : result.culled) {
    if (!is_by_cover(culled)) continue;
    for (const Point& eye : eyes) {
      for (std::size_t i = 0; i < kPointsOfEye; ++i, ++lines) {
        if (sight.is_clear(eye, some_point(random, hierarchy.nodes()[culled.node].box))) {
          return "culled by cover: an eye sees a point of the box";
        }
      }
    }
  }
  return "";
}

}  // namespace occlude::fuzz
