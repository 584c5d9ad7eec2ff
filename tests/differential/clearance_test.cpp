// SPDX-License-Identifier: MIT
// What is said about a box's distance from the border of a shadow is proved, and hardly more could be said.
#include "occlude/kernel/clearance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <variant>
#include <vector>

#include "cases/to_oracle.h"
#include "occlude/fuzz/case.h"
#include "occlude/kernel/overlap.h"
#include "occlude/oracle/oracle.h"

namespace occlude::fuzz {
namespace clearance_test {

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

kernel::Vec3 point(std::mt19937& random, double low, double high) {
  const double x = uniform(random, low, high), y = uniform(random, low, high), z = uniform(random, low, high);
  return {x, y, z};
}

kernel::Vec3 sum(const kernel::Vec3& a, const kernel::Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// A box of either kind, near where the shadow of something near the origin is.
std::variant<kernel::Aabb, kernel::Obb> some_box(std::mt19937& random, const kernel::Vec3& origin) {
  const kernel::Vec3 low = sum(origin, point(random, 0, 40));
  if (random() % 2 == 0) return kernel::Aabb{low, sum(low, point(random, 0, 2))};
  return kernel::Obb{low, {point(random, -1, 1), point(random, -1, 1), point(random, -1, 1)}};
}

TEST(Clearance, IsProvedExactly) {
  std::mt19937 random(5);
  int proved = 0, tight = 0;
  for (int i = 0; i < 60000; ++i) {
    // Scenes are near the origin or far from it. Triangles have all shapes, and some almost contain the eye in their plane.
    const double far = std::ldexp(1.0, static_cast<int>(random() % 32)) * static_cast<double>(random() % 2);
    const kernel::Vec3 origin{far, far, -far};
    const double thickness = std::ldexp(1.0, -static_cast<int>(random() % 40));
    std::vector<kernel::Vec3> loop{sum(origin, point(random, 1, 4)), sum(origin, point(random, 1, 4))};
    loop.push_back(sum(loop[0], point(random, -thickness, thickness)));
    const kernel::Viewpoint view =
        random() % 4 == 0 ? kernel::Viewpoint::direction(point(random, 0.1, 1)) : kernel::Viewpoint::eye(origin);
    const auto shadow = kernel::ShadowFrustum::make(view, loop, kernel::Near::surface).frustum;
    if (!shadow) continue;
    // The boxes are near the middle of the shadow, so that many are inside.
    kernel::Vec3 ahead{};
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = (loop[0][axis] + loop[1][axis] + loop[2][axis]) / 3;
      ahead[axis] =
          view.is_eye() ? origin[axis] + uniform(random, 1, 8) * (middle - origin[axis]) : middle + view.value[axis];
    }
    const double size = thickness * uniform(random, 0, 0.2);
    const kernel::Aabb small{ahead, sum(ahead, {size, size, size})};
    const auto box = random() % 8 == 0 ? some_box(random, origin) : std::variant<kernel::Aabb, kernel::Obb>(small);
    const double distance = std::visit([&](const auto& b) { return kernel::clearance(*shadow, b).distance; }, box);
    const double certain = std::visit([&](const auto& b) { return kernel::certain_distance(*shadow, b); }, box);
    if (!(certain > 0)) continue;
    oracle::Shadow judge(to_oracle(view), to_oracle(loop), to_oracle(kernel::Near::surface));
    const auto judged = std::visit([](const auto& b) { return oracle::Box(to_oracle(b)); }, box);
    ASSERT_EQ(judge.refute_cull(judged, certain), "") << i;
    ++proved;
    if (certain < 0.99 * distance) continue;  // little is certain about slivers
    ++tight;
    ASSERT_NE(judge.refute_cull(judged, 1.02 * distance), "") << i;
  }
  EXPECT_GT(proved, 1000);
  EXPECT_GT(tight, proved / 2);
}

}  // namespace clearance_test
}  // namespace occlude::fuzz
