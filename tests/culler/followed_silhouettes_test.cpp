// SPDX-License-Identifier: MIT
#include "frusta/followed_silhouettes.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "frusta/potential_occluders.h"
#include "occlude/culler/polygon_soup.h"
#include "scenes.h"

namespace followed_silhouettes_test {

using namespace occlude;
using namespace occlude::culler;

TEST(FollowedSilhouettes, AreSoManyAndOfTheShellsLastAskedFor) {
  PolygonSoup soup;
  constexpr std::uint32_t kShells = 20, kPlaces = 4;
  for (std::uint32_t i = 0; i < kShells; ++i) soup.add_box({3.0 * i, 0, 0}, {3.0 * i + 1, 1, 1});
  const PotentialOccluders occluders = PotentialOccluders::find(SharedSoup(soup), {});
  ASSERT_EQ(occluders.shells().size(), kShells);
  FollowedSilhouettes followed;
  const auto faces_asked = [&](std::uint32_t shell) {
    followed.reserve(kPlaces, kShells, occluders.shells().most_faces(), occluders.shells().most_edges());
    kernel::PolytopeSilhouette& seen = followed.of(shell);
    seen.update(kernel::Viewpoint::eye({-5, 7, 9}), occluders.shells().polytope(shell));
    EXPECT_EQ(seen.loop().size(), 6U);
    return seen.faces_asked();
  };
  const std::size_t all = occluders.shells().most_faces();
  for (std::uint32_t shell = 0; shell < kShells; ++shell) EXPECT_EQ(faces_asked(shell), all) << "never seen";
  EXPECT_EQ(followed.size(), kPlaces);
  for (std::uint32_t shell = kShells - kPlaces; shell < kShells; ++shell) EXPECT_EQ(followed.of(shell).faces_asked(), all);
  EXPECT_EQ(followed.of(0).faces_asked(), 0U) << "forgotten, and its place begun anew";
}

}  // namespace followed_silhouettes_test
