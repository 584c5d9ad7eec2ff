// SPDX-License-Identifier: MIT
// Occluders of few triangles: what becomes of models of which it is known how few do.
#include "occlude/culler/simplified_occluders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "frusta/closed_parts.h"
#include "model/adjacency.h"
#include "occlude/culler/scene.h"
#include "scenes.h"
#include "seed.h"

namespace simplified_occluders_test {

using namespace occlude::culler;
using glm::dvec3;
using occlude::seed_of;

constexpr SimplifyOptions kAll{.triangles = std::numeric_limits<std::size_t>::max()};

double area(SoupView soup) {
  double sum = 0;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const dvec3& a = soup.vertices[loop[0]];
      sum += glm::length(glm::cross(soup.vertices[loop[i]] - a, soup.vertices[loop[i + 1]] - a)) / 2;
    }
  }
  return sum;
}

bool is_all_closed(SoupView soup) {
  const std::vector<std::uint32_t> weld = welded(soup.vertices);
  return std::ranges::all_of(find_parts(soup, weld), [&](const auto& part) { return is_closed(soup, weld, part); });
}

/// A box of n x n squares a face, each of two triangles, turned outwards. Its places are rounded.
PolygonSoup fine_box(std::uint32_t n, const dvec3& size) {
  PolygonSoup soup;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool is_far : {false, true}) {
      const auto at = [&](std::uint32_t i, std::uint32_t k) {
        dvec3 v;
        v[axis] = is_far ? size[axis] : 0;
        v[(axis + 1) % 3] = size[(axis + 1) % 3] * i / n;
        v[(axis + 2) % 3] = size[(axis + 2) % 3] * k / n;
        return v;
      };
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t k = 0; k < n; ++k) {
          std::vector<dvec3> square{at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)};
          if (!is_far) std::ranges::reverse(square);
          add(soup, {square[0], square[1], square[2]});
          add(soup, {square[0], square[2], square[3]});
        }
      }
    }
  }
  return soup;
}

/// A floor of squares from 0 to n on both axes, without those from `first` to before `end` on both.
PolygonSoup floor_with_hole(int n, int first, int end) {
  PolygonSoup soup;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      if (x >= first && x < end && y >= first && y < end) continue;
      add(soup, {dvec3(x, y, 0), dvec3(x + 1, y, 0), dvec3(x + 1, y + 1, 0), dvec3(x, y + 1, 0)});
    }
  }
  return soup;
}

std::size_t size_of(SoupView soup) { return simplified_occluders(soup, kAll).soup.size(); }

TEST(SimplifiedOccluders, AFinelyMadeBoxIsTwelveTriangles) {
  for (const std::uint32_t n : {1U, 2U, 7U, 40U}) {
    const PolygonSoup box = fine_box(n, {10.1, 7.3, 5.7});
    const SimplifiedOccluders simple = simplified_occluders(box, kAll);
    EXPECT_EQ(simple.soup.size(), 12U) << n;
    EXPECT_EQ(simple.soup.vertices.size(), 8U) << n;
    EXPECT_EQ(simple.drawn_triangles, std::size_t{12} * n * n);
    EXPECT_EQ(simple.flat_triangles, 12U);
    EXPECT_TRUE(is_all_closed(simple.soup)) << n;
    EXPECT_NEAR(area(simple.soup), area(box), 1e-9);
  }
}

TEST(SimplifiedOccluders, TurnAsWhatTheyLieOn) {
  const SimplifiedOccluders simple = simplified_occluders(fine_box(5, {2, 2, 2}), kAll);
  for (std::size_t p = 0; p < simple.soup.size(); ++p) {
    const auto loop = simple.soup.loop(p);
    const auto at = [&](std::size_t i) { return simple.soup.vertices[loop[i]]; };
    const dvec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
    EXPECT_GT(glm::dot(normal, at(0) - dvec3(1)), 0) << p;
  }
}

TEST(SimplifiedOccluders, AHoleStaysOpen) {
  for (const int n : {3, 8, 20}) {
    const SimplifiedOccluders simple = simplified_occluders(floor_with_hole(n, 1, n - 1), kAll);
    EXPECT_EQ(simple.soup.size(), 8U) << "a square with a square hole";
    EXPECT_EQ(area(simple.soup), n * n - (n - 2) * (n - 2));
  }
}

/// A corner moved by the least that there is out of the plane, or off the line, keeps its triangles.
TEST(SimplifiedOccluders, NothingIsFlatUpToRounding) {
  for (const dvec3& at : {dvec3(2, 2, 0), dvec3(2, 0, 0)}) {  // inside, and on the border
    for (int axis = 0; axis < 3; ++axis) {
      PolygonSoup floor = floor_with_hole(4, 9, 9);
      std::size_t moved = 0;
      for (dvec3& v : floor.vertices) {
        if (v != at) continue;
        v[axis] = v[axis] == 0 ? 0x1p-100 : std::nextafter(v[axis], 3);
        ++moved;
      }
      ASSERT_GT(moved, 1U);
      const bool is_within = axis != 2 && at.y > 0, is_along = axis == 0 && at.y == 0;
      const std::size_t triangles = size_of(floor);
      if (is_within || is_along) {
        EXPECT_EQ(triangles, 2U) << axis;
      } else {
        EXPECT_GT(triangles, 2U) << axis;
      }
    }
  }
}

/// Of a dome, every corner is needed.
TEST(SimplifiedOccluders, NothingBentIsMerged) {
  PolygonSoup dome;
  const auto at = [](int x, int y) { return dvec3(x, y, x * x + x * y + y * y); };
  for (int x = -3; x < 3; ++x) {
    for (int y = -3; y < 3; ++y) {
      add(dome, {at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      add(dome, {at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  EXPECT_EQ(size_of(dome), 72U);
}

/// Where walls meet, a border is straight for all or stays.
TEST(SimplifiedOccluders, BordersKeepTheCornersOfAllThatMeet) {
  // Two walls in two halves each, along one edge: its middle goes.
  const auto walls = [](double left, double right) {
    PolygonSoup soup;
    add(soup, {{0, 0, 0}, {4, 0, 0}, {4, 0, left}, {0, 0, left}});
    add(soup, {{0, 0, left}, {4, 0, left}, {4, 0, 4}, {0, 0, 4}});
    add(soup, {{0, 0, 0}, {0, 0, right}, {0, 4, right}, {0, 4, 0}});
    add(soup, {{0, 0, right}, {0, 0, 4}, {0, 4, 4}, {0, 4, right}});
    return soup;
  };
  EXPECT_EQ(size_of(walls(2, 2)), 4U);
  EXPECT_EQ(size_of(walls(1, 3)), 4U) << "each corner is one of one wall alone, and goes";
  // A third wall begins or ends at the middle. So the other two keep it.
  for (const double end : {4, 0}) {
    for (const bool is_first : {false, true}) {
      PolygonSoup three;
      const std::vector<dvec3> third{{0, 0, 2}, {0, 0, end}, {-3, -3, end}, {-3, -3, 2}};
      if (is_first) add(three, third);
      const PolygonSoup two = walls(2, 2);
      for (std::size_t p = 0; p < two.size(); ++p) {
        add(three, {two.vertices[4 * p], two.vertices[4 * p + 1], two.vertices[4 * p + 2], two.vertices[4 * p + 3]});
      }
      if (!is_first) add(three, third);
      const SimplifiedOccluders simple = simplified_occluders(three, kAll);
      EXPECT_EQ(std::ranges::count(simple.soup.vertices, dvec3(0, 0, 2)), 1);
      EXPECT_EQ(simple.soup.size(), 8U);
      EXPECT_NEAR(area(simple.soup), area(three), 1e-9);
    }
  }
}

TEST(SimplifiedOccluders, FoldsAndOverlapsStay) {
  PolygonSoup folded;  // the second triangle lies on the first
  add(folded, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  add(folded, {{4, 0, 0}, {0, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(size_of(folded), 2U);
  PolygonSoup turned;  // neighbours that turn the other way
  add(turned, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  add(turned, {{1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 0}});
  EXPECT_EQ(size_of(turned), 4U);
  PolygonSoup repeated = floor_with_hole(1, 9, 9);
  add(repeated, {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}});
  EXPECT_EQ(size_of(repeated), 2U);
}

/// A triangle without area closes the seam between edges of different length: it goes with the corner that it is for, and
/// stays where that stays.
TEST(SimplifiedOccluders, TrianglesWithoutAreaCloseSeams) {
  PolygonSoup soup;
  add(soup, {{0, 0, 0}, {2, 0, 0}, {2, -2, 0}, {0, -2, 0}});
  add(soup, {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}});
  add(soup, {{1, 0, 0}, {2, 0, 0}, {0, 1, 1}});
  add(soup, {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(size_of(soup), 3U);
  add(soup, {{1, 0, 0}, {1, 0, 5}, {1, 5, 5}});
  EXPECT_EQ(size_of(soup), 6U);
}

TEST(SimplifiedOccluders, SeeThroughPolygonsGiveNone) {
  PolygonSoup soup = floor_with_hole(4, 9, 9);
  soup.see_through.assign(soup.size(), 0);
  soup.see_through[5] = 1;  // the square at (1, 1)
  const SimplifiedOccluders simple = simplified_occluders(soup, kAll);
  EXPECT_EQ(simple.soup.size(), 8U);
  EXPECT_EQ(area(simple.soup), 15);
  soup.see_through.assign(soup.size(), 1);
  EXPECT_EQ(size_of(soup), 0U);
  EXPECT_EQ(size_of(PolygonSoup()), 0U);
}

TEST(SimplifiedOccluders, BestFirst) {
  PolygonSoup soup;
  for (int i = 1; i <= 20; ++i)
    add(soup, {dvec3(9 * i, 0, 0), dvec3(9 * i + 0.4 * (i * 7 % 20 + 1), 0, 0), dvec3(9 * i, 1, i)});
  const SimplifiedOccluders all = simplified_occluders(soup, kAll);
  ASSERT_EQ(all.soup.size(), 20U);
  const auto area_of = [](const SimplifiedOccluders& simple, std::size_t p) {
    PolygonSoup one;
    one.vertices = simple.soup.vertices;
    one.add_polygon(simple.soup.loop(p));
    return area(one);
  };
  for (std::size_t p = 1; p < all.soup.size(); ++p) EXPECT_GE(area_of(all, p - 1), area_of(all, p)) << p;
  for (const std::size_t n : {0U, 1U, 7U, 20U}) {
    const SimplifiedOccluders few = simplified_occluders(soup, {.triangles = n});
    ASSERT_EQ(few.soup.size(), n);
    EXPECT_TRUE(std::ranges::equal(few.origins, std::span(all.origins).first(n)));
  }
  // From an eye close to one of them that one is the first, and one of which no side is seen is the last.
  for (std::uint32_t i = 0; i < 20; ++i) {
    Camera view;
    view.eye = soup.vertices[3 * i] + dvec3(0.1, 0.1, 0);
    view.target = view.eye + dvec3(0, 1, 0);
    EXPECT_EQ(simplified_occluders(soup, {.triangles = 1, .views = std::span(&view, 1)}).origins[0].polygon, i);
  }
}

/// Of walls one behind the other the first is chosen, though those behind it look larger together. Where nothing is hidden,
/// what looks largest is.
TEST(SimplifiedOccluders, WhatHidesComesFirst) {
  PolygonSoup soup;
  const auto add_wall = [&](double x, double size) { add(soup, {{x, -size, -size}, {x, size, -size}, {x, 0, size}}); };
  for (int i = 0; i < 20; ++i) add_wall(30 + 10 * i, 5);
  add_wall(-9, 9);
  add_wall(20, 18);
  Camera view;
  const auto first = [&] { return simplified_occluders(soup, {.triangles = 1, .views = std::span(&view, 1)}).origins[0]; };
  EXPECT_EQ(first().polygon, 21U);
  view.target = {-1, 0, 0};
  EXPECT_EQ(first().polygon, 20U);
  view.projection = Projection::orthographic;
  view.eye.x = -50;
  EXPECT_EQ(first().polygon, 21U);
}

/// The same, turned about all axes: its places are rounded, and nothing of it is exactly flat.
PolygonSoup turned(PolygonSoup soup) {
  for (dvec3& v : soup.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      double &x = v[axis], &y = v[(axis + 1) % 3];
      const double turned_x = std::cos(0.5) * x - std::sin(0.5) * y;
      y = std::sin(0.5) * x + std::cos(0.5) * y;
      x = turned_x;
    }
  }
  return soup;
}

bool has_inner(SoupView soup, double inset) {
  const SimplifiedOccluders simple = simplified_occluders(soup, {.inset = inset});
  return std::ranges::any_of(simple.origins, &OccluderOrigin::is_inside);
}

TEST(SimplifiedOccluders, NearlyFlatRegionsOfClosedPartsAreMergedInside) {
  const PolygonSoup box = turned(fine_box(40, {10.1, 7.3, 5.7}));
  EXPECT_GT(size_of(box), 1000U);
  const SimplifiedOccluders simple = simplified_occluders(box, {.inset = 1e-9});
  ASSERT_EQ(simple.soup.size(), 12U);
  EXPECT_EQ(simple.soup.vertices.size(), 8U);
  EXPECT_TRUE(is_all_closed(simple.soup));
  EXPECT_NEAR(area(simple.soup), area(box), 1e-8);
  for (const OccluderOrigin& origin : simple.origins) EXPECT_EQ(origin, (OccluderOrigin{.polygon = 0, .is_inside = true}));
  const PolygonSoup flat = fine_box(40, {8, 4, 2});
  EXPECT_FALSE(has_inner(flat, 1e-9)) << "there are as few on it";
}

TEST(SimplifiedOccluders, WhatIsNotProvenInsideStaysAsItIs) {
  const PolygonSoup box = turned(fine_box(8, {10.1, 7.3, 5.7}));
  ASSERT_TRUE(has_inner(box, 1e-9));
  PolygonSoup open = box;
  open.indices.erase(open.indices.begin(), open.indices.begin() + 3);
  open.first.pop_back();
  EXPECT_FALSE(has_inner(open, 1e-9)) << "it has a hole";
  PolygonSoup inwards = box;
  for (std::size_t p = 0; p < inwards.size(); ++p) std::swap(inwards.indices[3 * p], inwards.indices[3 * p + 1]);
  EXPECT_FALSE(has_inner(inwards, 1e-9)) << "behind it is outside";
}

TEST(SimplifiedOccluders, BoxesStandBesideWhatTheyAreIn) {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  soup.add_box({5, 0, 0}, {9, 4, 4});
  EXPECT_TRUE(simplified_occluders(soup, kAll).boxes.empty()) << "they are not for every eye";
  SimplifyOptions options{.triangles = 13, .boxes = {.boxes = 1}};
  const SimplifiedOccluders simple = simplified_occluders(soup, options);
  ASSERT_EQ(simple.soup.size(), 13U);
  ASSERT_EQ(simple.boxes.size(), 1U) << "of the smaller solid no face is among the 13 largest";
  EXPECT_EQ(simple.boxes[0].polygon, 6U);
  std::size_t of_boxes = 0;
  for (std::size_t t = 0; t < 13; ++t) {
    const OccluderOrigin& origin = simple.origins[t];
    if (origin.box == OccluderOrigin::kNoBox) continue;
    ++of_boxes;
    EXPECT_EQ(origin, (OccluderOrigin{6, 0, true}));
  }
  EXPECT_GE(of_boxes, 1U);
}

/// A solid of steps, perhaps skewed, its faces divided at random, with places that are whole numbers or rounded.
PolygonSoup random_solid(std::mt19937& random) {
  const auto pick = [&](std::uint32_t count) { return static_cast<std::uint32_t>(random()) % count; };
  const std::uint32_t n = 2 + pick(3);
  std::vector<bool> full(n * n * n);
  for (std::size_t i = 0; i < full.size(); ++i) full[i] = pick(3) != 0;
  const auto is_full = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return x < n && y < n && z < n && full[(z * n + y) * n + x];
  };
  PolygonSoup soup;
  const double scale = pick(4) != 0 ? 1 : 0.1;
  const bool is_skewed = pick(2) == 0;
  const auto place = [&](const dvec3& v) {
    return scale * (is_skewed ? dvec3(4 * v.x + 2 * v.y - v.z, v.x + 5 * v.y + v.z, 6 * v.z - 2 * v.x + v.y) : v);
  };
  for (std::uint32_t i = 0; i < n * n * n; ++i) {
    const std::array<std::uint32_t, 3> cell{i % n, i / n % n, i / n / n};
    for (std::uint32_t axis = 0; axis < 3 && full[i]; ++axis) {
      for (const std::uint32_t step : {~std::uint32_t{0}, 1U}) {
        std::array<std::uint32_t, 3> other = cell;
        other[axis] += step;
        if (is_full(other[0], other[1], other[2])) continue;
        std::vector<dvec3> square(4, {cell[0], cell[1], cell[2]});
        for (std::size_t k = 0; k < 4; ++k) {
          const auto down = [&](std::uint32_t a) { return static_cast<glm::length_t>(a % 3); };
          square[k][down(axis)] += step == 1 ? 1 : 0;
          square[k][down(axis + 1)] += k == 1 || k == 2 ? 1 : 0;
          square[k][down(axis + 2)] += k >= 2 ? 1 : 0;
        }
        if (step != 1) std::ranges::reverse(square);
        for (dvec3& v : square) v = place(v);
        const std::size_t turn = pick(4);
        const auto at = [&](std::size_t k) { return square[(k + turn) % 4]; };
        if (pick(3) == 0) {
          add(soup, square);
        } else {
          add(soup, {at(0), at(1), at(2)});
          add(soup, {at(0), at(2), at(3)});
        }
      }
    }
  }
  return soup;
}

TEST(SimplifiedOccluders, SolidsStayClosedAndAsLarge) {
  RecordProperty("seed", static_cast<int>(seed_of(1)));
  std::mt19937 random(seed_of(1));
  std::size_t drawn = 0, left = 0;
  for (int i = 0; i < 300; ++i) {
    const PolygonSoup soup = random_solid(random);
    ASSERT_TRUE(is_all_closed(soup));
    const SimplifiedOccluders simple = simplified_occluders(soup, kAll);
    EXPECT_TRUE(is_all_closed(simple.soup)) << "solid " << i << " of seed " << seed_of(1);
    EXPECT_NEAR(area(simple.soup), area(soup), 1e-9 * area(soup)) << "solid " << i << " of seed " << seed_of(1);
    drawn += simple.drawn_triangles;
    left += simple.flat_triangles;
  }
  EXPECT_LT(left, drawn * 3 / 4);
}

/// The share of what is hidden behind a fine wall is that behind a plain one.
TEST(SimplifiedOccluders, HideAsMuch) {
  const auto hidden_behind = [](PolygonSoup soup) {
    Scene scene;
    scene.add(std::make_shared<OccluderMesh>(std::move(soup)));
    for (int i = -30; i <= 30; ++i) {
      for (int k = -10; k <= 10; ++k)
        scene.add(occlude::kernel::Aabb{{0.3 * i, 30, 0.3 * k}, {0.3 * i + 0.1, 31, 0.3 * k + 0.1}});
    }
    scene.update();
    SceneView view;
    Camera camera;
    camera.eye = {5, -20, 3};
    camera.target = {5, 0, 3};
    return scene.cull(camera, {}, view).stats.hidden;
  };
  const std::size_t plain = hidden_behind(fine_box(1, {10, 7, 5}));
  EXPECT_GT(plain, 100U);
  EXPECT_EQ(hidden_behind(simplified_occluders(fine_box(40, {10, 7, 5}), kAll).soup), plain);
}

TEST(SimplifiedOccluders, AreTheSameOnAnyNumberOfThreads) {
  const PolygonSoup soup = random_town_of_houses(seed_of(3), 400);
  const SimplifyOptions options{.triangles = 500, .boxes = {}};
  const SimplifiedOccluders one = simplified_occluders(soup, options, Checkpoint(Executor()));
  for (int i = 0; i < 3; ++i) {
    const SimplifiedOccluders many = simplified_occluders(soup, options);
    EXPECT_EQ(many.soup.vertices, one.soup.vertices);
    EXPECT_EQ(many.soup.indices, one.soup.indices);
    EXPECT_EQ(many.origins, one.origins);
  }
}

TEST(SimplifiedOccluders, RefuseWhatIsNotLegalAndStopWhenAsked) {
  PolygonSoup soup = fine_box(3, {1, 1, 1});
  EXPECT_THROW((void)simplified_occluders(soup, {}, [] { throw std::logic_error("stop"); }), std::logic_error);
  soup.vertices[4].x = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)simplified_occluders(soup), std::invalid_argument);
  soup.vertices[4].x = 0;
  std::array<Camera, 2> views;
  views[1].target = views[1].eye;
  EXPECT_THROW((void)simplified_occluders(soup, {.views = views}), std::invalid_argument);
  soup.indices[0] = 12345;
  EXPECT_THROW((void)simplified_occluders(soup), std::invalid_argument);
}

/// Two hundred triangles around a corner, or on one edge, stay as they are: they would take too long.
TEST(SimplifiedOccluders, WhatIsAroundOneCornerMayStay) {
  PolygonSoup wheel, edge;
  for (int i = 0; i < 200; ++i) {
    const auto rim = [](int k) {
      return dvec3(std::cos(0.01 * std::numbers::pi * k), std::sin(0.01 * std::numbers::pi * k), 0);
    };
    add(wheel, {dvec3(0, 0, 0), rim(i), rim((i + 1) % 200)});
    add(edge, {dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, i % 2 == 0 ? 1 + i : -1 - i, 0)});
  }
  EXPECT_EQ(size_of(wheel), 200U);
  EXPECT_EQ(size_of(edge), 200U);
}

/// A corner with many triangles waits until its neighbours have gone, and costs nothing meanwhile.
TEST(SimplifiedOccluders, ManyTrianglesAroundACornerAreMergedFromTheirBorder) {
  PolygonSoup fan;
  constexpr int kCount = 100'000;
  for (int i = 0; i < kCount; ++i) add(fan, {dvec3(0, 0, 0), dvec3(kCount, i, 0), dvec3(kCount, i + 1, 0)});
  EXPECT_EQ(size_of(fan), 1U);
}

}  // namespace simplified_occluders_test
