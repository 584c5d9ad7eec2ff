// SPDX-License-Identifier: MIT
// What the cullers promise of views that change hands, of soups that are none, of shadows that were never made, of boxes far
// away and of other rounding modes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "frames.h"
#include "kernel/rounding.h"
#include "occlude/culler/clearance.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/scene.h"
#include "occlude/culler/shadow_margin.h"
#include "scenes.h"

namespace {

using namespace occlude;
using namespace occlude::culler;
using kernel::Aabb;

PolygonSoup triangle() {
  PolygonSoup soup;
  add(soup, {{2, -1, -1}, {2, 1, -1}, {2, 0, 1}});
  add(soup, {{3, -1, -1}, {3, 1, -1}, {3, 0, 1}});
  return soup;
}

/// What the culler and the scene say alike.
template <class Change>
std::string refusal_of_soup(const Change& change) {
  PolygonSoup soup = triangle();
  change(soup);
  const std::string by_culler = refusal([&] { static_cast<void>(Culler(soup)); });
  EXPECT_EQ(by_culler, refusal([&] { static_cast<void>(Scene({}, soup)); }));
  return by_culler;
}

TEST(Soup, IsRefusedUnlessWellFormed) {
  EXPECT_EQ(refusal_of_soup([](PolygonSoup&) {}), "");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.indices[4] = 6; }), "polygon 1: corner 1 is vertex 6 of 6");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.indices[0] = 4294967295U; }),
            "polygon 0: corner 0 is vertex 4294967295 of 6");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first = {0, 2, 6}; }), "polygon 0: fewer than 3 corners");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first = {0, 3, 3, 6}; }), "polygon 1: fewer than 3 corners");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) {
              soup.first = {0, 6, 3};
            }),
            "polygon 1: its corners are not among the indices");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) {
              soup.first = {0, 3, 7};
            }),
            "polygon 1: its corners are not among the indices");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first = {0, 3}; }), "the soup has indices after its last polygon");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first = {1, 3, 6}; }), "the soup's `first` does not begin with 0");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first.clear(); }), "the soup's `first` does not begin with 0");
}

TEST(Soup, NumbersDoNotWrap) {
  EXPECT_EQ(PolygonSoup::narrowed(4294967295U), 4294967295U);
  EXPECT_THROW(static_cast<void>(PolygonSoup::narrowed(4294967296U)), std::length_error);
}

}  // namespace
