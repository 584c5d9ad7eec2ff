// SPDX-License-Identifier: MIT
// Several occluders at once: the same answers as one by one, on every instruction set.
#include "frusta/seen_occluders.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "only_target.h"

namespace seen_occluders_test {

using namespace occlude;
using namespace occlude::culler;

class SeenOccludersTest : public testing::Test {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  glm::dvec3 point(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

  /// Regions and shells near a point.
  std::vector<PotentialOccluder> some(std::size_t count, const glm::dvec3& eye) {
    std::vector<PotentialOccluder> occluders;
    for (std::size_t i = 0; i < count; ++i) {
      PotentialOccluder occluder;
      occluder.centre = i % 7 == 3 ? eye : eye + point(20);
      if (i % 2 == 0) occluder.area_normal = point(3);
      if (i % 2 == 1) occluder.round_area = uniform(0, 3);
      occluder.radius = i % 5 == 0 ? 0 : uniform(0, 4);
      occluders.push_back(occluder);
    }
    return occluders;
  }

  std::mt19937 random_{5};
};

TEST_F(SeenOccludersTest, AreAsOneByOneOnEveryInstructionSet) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const OnlyTarget only(target);
    std::size_t in_view = 0, all = 0;
    SeenOccluders seen;
    for (std::size_t count = 0; count <= SeenOccluders::kMost; ++count) {
      const glm::dvec3 eye = point(count % 2 == 0 ? 1e6 : 1);
      std::vector<HalfSpace> view;
      for (std::size_t i = 0; i < count % 7; ++i) {
        const glm::dvec3 normal = glm::normalize(point(1));
        view.push_back({normal, uniform(0, 20) - glm::dot(normal, eye)});
      }
      const std::vector<PotentialOccluder> occluders = some(count, eye);
      seen.size = 0;
      for (const PotentialOccluder& occluder : occluders) seen.add(occluder);
      seen.see(eye, view);
      for (std::size_t i = 0; i < count; ++i) {
        const PotentialOccluder& o = occluders[i];
        const bool is_in_view = std::ranges::none_of(
            view, [&](const HalfSpace& h) { return glm::dot(h.normal, o.centre) + h.offset < -o.radius; });
        EXPECT_EQ((seen.in_view >> i & 1U) != 0, is_in_view) << hwy::TargetName(target) << ", " << i << " of " << count;
        EXPECT_EQ(seen.angle[i], o.area_angle(eye)) << hwy::TargetName(target) << ", " << i << " of " << count;
        in_view += is_in_view ? 1 : 0;
        ++all;
      }
      EXPECT_EQ(std::uint64_t{seen.in_view} >> count, 0U);
    }
    EXPECT_GT(in_view, all / 5);
    EXPECT_LT(in_view, 4 * all / 5);
  }
}

}  // namespace seen_occluders_test
