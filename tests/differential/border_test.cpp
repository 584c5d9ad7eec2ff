// SPDX-License-Identifier: MIT
#include "border.h"

#include <gtest/gtest.h>

#include <vector>

namespace occlude::proof {
namespace border_test {

using Parts = std::vector<Polygon>;

const kernel::Vec3 a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0}, d{0, 1, 0}, e{0.5, 0.5, 0}, f{2, 0, 0};
const Polygon square{a, b, c, d};

TEST(Border, OfPartsThatFillTheLoop) {
  EXPECT_TRUE(have_border(Parts{square}, square));
  EXPECT_TRUE(have_border(Parts{square}, {c, d, a, b}));
  EXPECT_TRUE(have_border(Parts{{a, b, c}, {a, c, d}}, square));
  EXPECT_TRUE(have_border(Parts{{b, c, d}, {d, a, b}}, square));
  EXPECT_TRUE(have_border(Parts{{a, b, c}, {a, c, d}}, {a, b, c, {-0.0, 1, 0}}));
}

TEST(Border, OfPartsThatDoNot) {
  EXPECT_FALSE(have_border(Parts{}, square));
  EXPECT_FALSE(have_border(Parts{{a, b, c}}, square)) << "a half is missing";
  EXPECT_FALSE(have_border(Parts{{a, b, c}, {a, b, c}}, square)) << "one half twice";
  EXPECT_FALSE(have_border(Parts{{a, b, c}, {a, c, d}, {b, f, c}}, square)) << "more than the loop";
  EXPECT_FALSE(have_border(Parts{{a, b, c}, {d, c, a}}, square)) << "turned against one another";
  EXPECT_FALSE(have_border(Parts{{a, b, e}, {b, c, e}, {c, d, e}, {d, a, e}}, square)) << "a vertex inside";
  EXPECT_FALSE(have_border(Parts{square}, {d, c, b, a})) << "the other way round";
}

}  // namespace border_test
}  // namespace occlude::proof
