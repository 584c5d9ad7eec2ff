// SPDX-License-Identifier: MIT
// Neighbours of boxes, and damaged cases: they never change, and all the kinds that are promised occur.
#include "occlude/fuzz/neighbours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <variant>

#include "case_hash.h"
#include "cases/ask.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/spoil.h"

namespace occlude::fuzz {
namespace neighbours_test {

constexpr std::uint64_t kSeeds = 2000;

template <class Change>
std::uint64_t hash_of(const Change& change) {
  CaseHash hash;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Case c = make_case(families()[seed % families().size()], seed);
    change(c, seed);
    hash.add(c);
  }
  return hash.value();
}

void move_box(Case& c, std::uint64_t seed) { c.box = neighbour(c.box, seed); }

void damage(Case& c, std::uint64_t seed) {
  Random random(seed);
  spoil(random, c);
}

TEST(Golden, NeighboursAreWhatTheyWere) {
  EXPECT_EQ(hash_of(move_box), 0xb8e43f6007ab43e1U) << std::hex << hash_of(move_box);
}

TEST(Golden, SpoiledCasesAreWhatTheyWere) { EXPECT_EQ(hash_of(damage), 0xcb5521ae4458cf9dU) << std::hex << hash_of(damage); }

TEST(Neighbour, MovesBoundsByTheLeastThereIsAndByWhole) {
  const kernel::Aabb box{{8, 16, 24}, {40, 48, 72}};
  std::set<double> bounds;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto near = std::get<kernel::Aabb>(neighbour(box, seed));
    ASSERT_EQ(check(Box(near)), kernel::Refusal::none);
    bounds.insert(near.min.x);
  }
  for (const double x : {8.0, std::nextafter(8.0, 9.0), std::nextafter(8.0, 7.0), 0.0, 16.0, 24.0, 40.0, -24.0}) {
    EXPECT_TRUE(bounds.contains(x)) << x;
  }
}

TEST(Neighbour, CollapsesOrientedBoxesToAFace) {
  const kernel::Obb box{{1, 2, 3}, {kernel::Vec3{4, 0, 0}, kernel::Vec3{0, 4, 4}, kernel::Vec3{0, -4, 4}}};
  bool to_face = false;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto near = std::get<kernel::Obb>(neighbour(box, seed));
    to_face = to_face || (near.center == kernel::Vec3{5, 2, 3} && near.half_edges[0] == kernel::Vec3{});
  }
  EXPECT_TRUE(to_face);
}

TEST(Spoil, MeetsEveryRefusal) {
  std::set<kernel::Refusal> met;
  for (std::uint64_t seed = 0; seed < 10 * kSeeds; ++seed) {
    Case c = make_case(families()[seed % families().size()], seed);
    damage(c, seed);
    met.insert(check(c.box));
    met.insert(make_frustum(c).refusal);
  }
  EXPECT_EQ(met.size(), static_cast<std::size_t>(kernel::Refusal::eye_in_polytope) + 1);
}

}  // namespace neighbours_test
}  // namespace occlude::fuzz
