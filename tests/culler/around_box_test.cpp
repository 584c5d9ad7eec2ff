// SPDX-License-Identifier: MIT
// Regions of eyes around boxes.
#include "held/around_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scenes.h"
#include "seed.h"

namespace around_box_test {

using namespace occlude::culler;
using occlude::seed_of;
using occlude::kernel::Aabb;

/// In more digits than the region has.
TEST(CameraOfABox, HoldsTheBoxHoweverItsNumbersRound) {
  std::mt19937 random(seed_of(5901));
  for (int trial = 0; trial < 10000; ++trial) {
    Aabb box;
    for (int i = 0; i < 3; ++i) {
      // Ends of different magnitudes, whose differences are rounded.
      box.min[i] = -std::ldexp(uniform(random, 1, 2), -static_cast<int>(random() % 30));
      box.max[i] = random() % 4 == 0 ? box.min[i] : uniform(random, 0, 3);
    }
    const Camera camera = camera_of(box);
    for (int i = 0; i < 3; ++i) {
      const long double middle = camera.eye[i], reach = camera.eyes.half_edges[static_cast<std::size_t>(i)][i];
      EXPECT_LE(middle - reach, box.min[i]);
      EXPECT_GE(middle + reach, box.max[i]);
      EXPECT_EQ(reach == 0, box.min[i] == box.max[i]);
    }
  }
}

}  // namespace around_box_test
