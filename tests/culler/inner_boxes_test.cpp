// SPDX-License-Identifier: MIT
// Boxes in solids of which it is known what is inside.
#include "occlude/culler/inner_boxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "scenes.h"

namespace inner_boxes_test {

using namespace occlude::culler;
using occlude::kernel::Aabb;

std::vector<Aabb> boxes_of(SoupView soup, const InnerBoxOptions& options = {}) {
  std::vector<Aabb> boxes;
  for (const InnerBox& inner : find_inner_boxes(soup, options).boxes) boxes.push_back(inner.box);
  return boxes;
}

double volume(const Aabb& box) { return (box.max.x - box.min.x) * (box.max.y - box.min.y) * (box.max.z - box.min.z); }

/// Whether a point of `other` is in the box, borders excluded of both.
bool overlap(const Aabb& box, const Aabb& other) {
  for (int axis = 0; axis < 3; ++axis) {
    if (box.max[axis] <= other.min[axis] || box.min[axis] >= other.max[axis]) return false;
  }
  return true;
}

bool holds(const Aabb& box, const Aabb& other) {
  for (int axis = 0; axis < 3; ++axis) {
    if (other.min[axis] < box.min[axis] || other.max[axis] > box.max[axis]) return false;
  }
  return true;
}

/// A prism of this outline, from z = 0 to `height`, its caps one polygon each.
PolygonSoup prism(const std::vector<glm::dvec3>& outline, double height) {
  PolygonSoup soup;
  const glm::dvec3 up{0, 0, height};
  std::vector<glm::dvec3> top;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    add(soup, {a, b, b + up, a + up});
    top.push_back(a + up);
  }
  add(soup, outline);
  add(soup, top);
  return soup;
}

const std::vector<glm::dvec3> kL{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};

PolygonSoup tetrahedron(double size) {
  PolygonSoup soup;
  const glm::dvec3 o{0, 0, 0}, x{size, 0, 0}, y{0, size, 0}, z{0, 0, size};
  for (const auto& loop : {std::vector{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}}) add(soup, loop);
  return soup;
}

/// A square frame about the z axis: from 4 x 4 the middle 2 x 2 is left out.
PolygonSoup frame() {
  PolygonSoup soup;
  const auto corner = [](double size, int i) {
    return glm::dvec3{i == 0 || i == 3 ? -size : size, i < 2 ? -size : size, 0};
  };
  const glm::dvec3 up{0, 0, 1};
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 a = corner(2, i), b = corner(2, (i + 1) % 4), c = corner(1, i), d = corner(1, (i + 1) % 4);
    add(soup, {a, b, b + up, a + up});
    add(soup, {d, c, c + up, d + up});
    add(soup, {a, c, d, b});
    add(soup, {a + up, b + up, d + up, c + up});
  }
  return soup;
}

TEST(InnerBoxes, ABoxGivesItself) {
  for (const bool triangles : {false, true}) {
    PolygonSoup soup;
    add_wall(soup, 50, 0, 1, 0, 1);
    add_box(soup, {0.1, -0.7, 3}, {1.3, 9.1, 3.5}, triangles);
    const InnerBoxes found = find_inner_boxes(soup);
    ASSERT_EQ(found.boxes.size(), 1U);
    EXPECT_EQ(found.boxes[0].box, (Aabb{{0.1, -0.7, 3}, {1.3, 9.1, 3.5}}));
    EXPECT_EQ(found.boxes[0].polygon, 1U);
    EXPECT_EQ(found.parts, 2U);
    EXPECT_EQ(found.closed_parts, 1U);
    EXPECT_EQ(found.filled_parts, 1U);
    EXPECT_EQ(found.share, 1);
  }
}

/// The arms of an L overlap in its corner. That its cap is not convex, and drawn as a fan, folds it there.
TEST(InnerBoxes, OfAnLFillBothArms) {
  const Aabb along_x{{0, 0, 0}, {3, 1, 2}}, along_y{{0, 0, 0}, {1, 3, 2}};
  const std::vector<Aabb> boxes = boxes_of(prism(kL, 2));
  ASSERT_EQ(boxes.size(), 2U);
  for (const Aabb& box : boxes) EXPECT_TRUE(box == along_x || box == along_y);
  EXPECT_NE(boxes[0], boxes[1]);
}

TEST(InnerBoxes, OfATetrahedronTouchItsSlope) {
  const std::vector<Aabb> boxes = boxes_of(tetrahedron(1));
  ASSERT_FALSE(boxes.empty());
  for (const Aabb& box : boxes) {
    EXPECT_TRUE(holds({{0, 0, 0}, {1, 1, 1}}, box));
    EXPECT_LE(box.max.x + box.max.y + box.max.z, 1);
    EXPECT_GT(box.max.x + box.max.y + box.max.z, 1 - 1e-12) << "as large as may be";
  }
  EXPECT_GT(volume(boxes[0]), 0.9 / 27) << "the largest is 1/3 x 1/3 x 1/3";
}

TEST(InnerBoxes, OfAFrameLeaveItsHole) {
  const std::vector<Aabb> boxes = boxes_of(frame());
  ASSERT_EQ(boxes.size(), 4U);
  double all = 0;
  for (const Aabb& box : boxes) {
    EXPECT_TRUE(holds({{-2, -2, 0}, {2, 2, 1}}, box));
    EXPECT_FALSE(overlap(box, {{-1, -1, 0}, {1, 1, 1}}));
    all += volume(box);
  }
  EXPECT_GE(all, 12) << "each side is filled";
}

/// A smaller shell within is another part, and hides within the larger one. Joined to it by a corner it is a hollow of it.
TEST(InnerBoxes, OfShellsInShells) {
  const Aabb outer{{0, 0, 0}, {8, 8, 8}}, inner{{2, 2, 2}, {6, 6, 6}};
  PolygonSoup nested;
  nested.add_box({0, 0, 0}, {8, 8, 8});
  nested.add_box({2, 2, 2}, {6, 6, 6});
  EXPECT_EQ(boxes_of(nested), (std::vector{outer, inner}));

  PolygonSoup hollow;
  hollow.add_box({0, 0, 0}, {8, 8, 8});
  add_box(hollow, {0, 0, 0}, {4, 4, 4}, true);
  const std::vector<Aabb> boxes = boxes_of(hollow);
  ASSERT_EQ(boxes.size(), 3U) << "a slab on each side of the hollow";
  for (const Aabb& box : boxes) {
    EXPECT_TRUE(holds(outer, box));
    EXPECT_FALSE(overlap(box, {{0, 0, 0}, {4, 4, 4}}));
    EXPECT_EQ(volume(box), 256);
  }
}

TEST(InnerBoxes, NoneInWhatIsOpen) {
  for (std::size_t left_out = 0; left_out < 6; ++left_out) {
    PolygonSoup box, soup;
    box.add_box({0, 0, 0}, {2, 2, 2});
    soup.vertices = box.vertices;
    for (std::size_t p = 0; p < 6; ++p) {
      if (p != left_out) soup.add_polygon(box.loop(p));
    }
    EXPECT_TRUE(boxes_of(soup).empty()) << left_out;
    EXPECT_EQ(find_inner_boxes(soup).closed_parts, 0U);
    const std::span<const std::uint32_t> face = box.loop(left_out);
    soup.add_polygon(std::array{face[0], face[1], face[2]});
    EXPECT_TRUE(boxes_of(soup).empty()) << "half of a face is left out";
    soup.add_polygon(std::array{face[0], face[2], face[3]});
    EXPECT_EQ(boxes_of(soup).size(), 1U);
  }
  // A corner in the middle of an edge of one of its two faces.
  PolygonSoup junction;
  junction.add_box({0, 0, 0}, {2, 2, 2});
  junction.first.pop_back();
  junction.indices.resize(junction.first.back());
  add(junction, {{0, 0, 2}, {1, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}});
  EXPECT_TRUE(boxes_of(junction).empty());
}

TEST(InnerBoxes, NoneInWhatEnclosesNothing) {
  EXPECT_TRUE(boxes_of({}).empty());
  PolygonSoup twice;  // an open box, each face two polygons
  for (int i = 0; i < 2; ++i) {
    twice.add_box({0, 0, 0}, {2, 2, 2});
    twice.first.pop_back();
    twice.indices.resize(twice.first.back());
  }
  EXPECT_EQ(find_inner_boxes(twice).closed_parts, 1U);
  EXPECT_TRUE(boxes_of(twice).empty());
  PolygonSoup flat;
  flat.add_box({0, 0, 1}, {2, 2, 1});
  add(flat, {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}});
  add(flat, {{6, 6, 6}, {7, 7, 7}, {6, 6, 6}});
  EXPECT_EQ(find_inner_boxes(flat).closed_parts, 3U);
  EXPECT_TRUE(boxes_of(flat).empty());
}

/// A triangle without area is drawn as nothing, but it closes the surface. No box holds a part of it.
TEST(InnerBoxes, ASliverInASolidIsLeftOut) {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {4, 4, 4});
  soup.add_polygon(std::array{0U, 7U, 0U});  // along the diagonal of the solid
  EXPECT_EQ(find_inner_boxes(soup).closed_parts, 1U);
  const std::vector<Aabb> boxes = boxes_of(soup);
  EXPECT_FALSE(boxes.empty());
  for (const Aabb& box : boxes) {
    const double low = std::max({box.min.x, box.min.y, box.min.z}), high = std::min({box.max.x, box.max.y, box.max.z});
    EXPECT_GE(low, high);
    EXPECT_TRUE(holds({{0, 0, 0}, {4, 4, 4}}, box));
  }
}

/// Between the two triangles that it is drawn as, a face may be a pit or a ridge.
TEST(InnerBoxes, FacesThatAreNotPlaneAreAsTheyAreDrawn) {
  for (const bool pit : {false, true}) {
    PolygonSoup soup;
    soup.add_box({0, 0, 0}, {4, 4, 4});
    soup.vertices[4].z = soup.vertices[7].z = 0.5;  // the top, of corners 4, 5, 7, 6, falls to the ends of one diagonal
    soup.first.pop_back();
    soup.indices.resize(soup.first.back());
    const std::array<std::uint32_t, 4> along{4, 5, 7, 6}, across{5, 7, 6, 4};
    soup.add_polygon(pit ? along : across);
    const std::vector<Aabb> boxes = boxes_of(soup);
    ASSERT_FALSE(boxes.empty());
    double top = 0;
    for (const Aabb& box : boxes) {
      top = std::max(top, box.max.z);
      // From 4 at (4, 0) and (0, 4) it falls to 0.5 all along x = y, or to (0, 0) and (4, 4) alone.
      const double nearest = box.min.x > box.max.y   ? box.min.x - box.max.y
                             : box.min.y > box.max.x ? box.min.y - box.max.x
                                                     : 0;
      const double sums[2] = {box.min.x + box.min.y, 8 - box.max.x - box.max.y};
      const double roof = pit ? 0.5 + nearest * 0.875 : 0.5 + std::min({4.0, sums[0], sums[1]}) * 0.875;
      EXPECT_LE(box.max.z, roof + 0x1p-50);
    }
    EXPECT_GT(top, 1);
  }
}

TEST(InnerBoxes, FarFromTheOrigin) {
  const double far = 0x1p40;  // where doubles are 2^-12 apart
  PolygonSoup soup;
  for (const glm::dvec3& v : tetrahedron(1).vertices) soup.add_vertex(v + far);
  soup.indices = tetrahedron(1).indices;
  soup.first = tetrahedron(1).first;
  soup.add_box({-far, far, 0x1p-90}, {-far + 3, far + 0x1p-8, 0x1p-80});
  const std::vector<Aabb> boxes = boxes_of(soup);
  ASSERT_GT(boxes.size(), 1U);
  for (std::size_t i = 0; i + 1 < boxes.size(); ++i) {
    EXPECT_TRUE(holds({{far, far, far}, {far + 1, far + 1, far + 1}}, boxes[i]));
    EXPECT_LE((boxes[i].max.x - far) + (boxes[i].max.y - far) + (boxes[i].max.z - far), 1);
  }
  EXPECT_EQ(boxes.back(), (Aabb{{-far, far, 0x1p-90}, {-far + 3, far + 0x1p-8, 0x1p-80}}));
}

/// Solids at the ends of the legal range: what lies between their coordinates may not be legal, and is not asked.
TEST(InnerBoxes, AtTheEndsOfTheRange) {
  const double least = 0x1p-100, most = 0x1p100;
  PolygonSoup soup;
  soup.add_box({-most, -most, -most}, {most, most, most});
  soup.add_box({least, -least, least}, {most, least, 2 * least});
  EXPECT_EQ(boxes_of(soup).front(), (Aabb{{-most, -most, -most}, {most, most, most}}));
  EXPECT_EQ(find_inner_boxes(soup).closed_parts, 2U);
}

/// A ring of houses with gables, and among them all the solids above: something of every kind.
PolygonSoup village() {
  PolygonSoup soup;
  const auto put = [&](SoupView solid, const glm::dvec3& at, double angle) {
    const auto base = static_cast<std::uint32_t>(soup.vertices.size());
    for (const glm::dvec3& v : solid.vertices) {
      soup.add_vertex(at + glm::dvec3{v.x * std::cos(angle) - v.y * std::sin(angle),
                                      v.x * std::sin(angle) + v.y * std::cos(angle), v.z});
    }
    for (std::size_t p = 0; p < solid.size(); ++p) {
      std::vector<std::uint32_t> loop;
      for (const std::uint32_t index : solid.loop(p)) loop.push_back(base + index);
      soup.add_polygon(loop);
    }
  };
  for (int i = 0; i < 12; ++i) {
    const double angle = i * std::numbers::pi / 12;
    put(prism({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {1.5, 3.5, 0}, {0, 2, 0}}, 4), {10.0 * i, 0, 0}, angle);
    put(prism(kL, 2), {10.0 * i, 10, 0}, angle);
    put(tetrahedron(3), {10.0 * i, 20, 0}, angle);
    put(frame(), {10.0 * i, 30, 0}, angle);
  }
  return soup;
}

bool same(const InnerBoxes& a, const InnerBoxes& b) {
  if (a.boxes.size() != b.boxes.size()) return false;
  for (std::size_t i = 0; i < a.boxes.size(); ++i) {
    if (a.boxes[i].box != b.boxes[i].box || a.boxes[i].polygon != b.boxes[i].polygon) return false;
  }
  return true;
}

TEST(InnerBoxes, AreTheSameOnAnyNumberOfThreads) {
  const PolygonSoup soup = village();
  const InnerBoxes one = find_inner_boxes(soup, {}, {}, Checkpoint(Executor()));
  EXPECT_EQ(one.closed_parts, 48U);
  EXPECT_GT(one.boxes.size(), 96U);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(same(find_inner_boxes(soup), one));
}

TEST(InnerBoxes, OfAScaledModelAreScaled) {
  PolygonSoup soup = village();
  const InnerBoxes plain = find_inner_boxes(soup);
  for (const double scale : {0x1p-30, 0x1p50}) {
    PolygonSoup scaled = soup;
    for (glm::dvec3& v : scaled.vertices) v *= scale;
    InnerBoxes found = find_inner_boxes(scaled);
    for (InnerBox& inner : found.boxes) {
      for (int axis = 0; axis < 3; ++axis) {
        inner.box.min[axis] /= scale;
        inner.box.max[axis] /= scale;
      }
    }
    EXPECT_TRUE(same(found, plain));
  }
}

/// Of copies with other axes, mirrored too, the boxes may be others, but they are as good.
TEST(InnerBoxes, OfTurnedAndMirroredModelsAreAsLarge) {
  const PolygonSoup soup = village();
  const double share = find_inner_boxes(soup).share;
  EXPECT_GT(share, 0.15);
  for (int i = 1; i < 32; i += 5) {
    PolygonSoup copy = soup;
    for (glm::dvec3& v : copy.vertices) {
      v = {v[i % 3], v[(i + 1) % 3], v[(i + 2) % 3]};
      v *= glm::dvec3{i & 4 ? -1 : 1, i & 8 ? -1 : 1, i & 16 ? -1 : 1};
    }
    EXPECT_NEAR(find_inner_boxes(copy).share, share, 0.1 * share) << i;
  }
}

TEST(InnerBoxes, NoMoreThanAskedForInGridsOfAnySize) {
  const PolygonSoup soup = village();
  EXPECT_EQ(boxes_of(soup, {.boxes = 0}).size(), 0U);
  EXPECT_EQ(find_inner_boxes(soup, {.boxes = 1}).boxes.size(), 48U);
  const PolygonSoup slope = tetrahedron(1);
  const InnerBoxes coarse = find_inner_boxes(slope, {.boxes = 1, .cells = 3}), fine = find_inner_boxes(slope, {.cells = 64});
  EXPECT_LT(coarse.share, 0.9 * fine.share);
  EXPECT_TRUE(same(find_inner_boxes(slope, {.boxes = 1, .cells = 0}), coarse));
  EXPECT_TRUE(same(find_inner_boxes(slope, {.cells = 1000}), fine));
}

TEST(InnerBoxes, RefuseWhatIsNotLegalAndStopWhenAsked) {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW((void)find_inner_boxes(soup, {}, {}, [] { throw std::logic_error("stop"); }), std::logic_error);
  std::size_t most = 0;
  const auto count = [&](std::size_t done, std::size_t all) {
    EXPECT_EQ(all, 1U);
    most = done;
  };
  (void)find_inner_boxes(soup, {}, count);
  EXPECT_EQ(most, 1U);
  soup.vertices[3].y = NAN;
  EXPECT_THROW((void)find_inner_boxes(soup), std::invalid_argument);
  soup.vertices[3].y = 1;
  soup.indices[5] = 8;
  EXPECT_THROW((void)find_inner_boxes(soup), std::invalid_argument);
}

TEST(InnerBoxes, AsASoupAreTurnedOutwards) {
  PolygonSoup soup;
  soup.add_box({1, 2, 3}, {4, 6, 8});
  soup.add_box({11, 2, 3}, {14, 6, 8});
  const InnerBoxes found = find_inner_boxes(soup);
  const PolygonSoup boxes = soup_of(found.boxes);
  ASSERT_EQ(boxes.size(), 12U);
  for (std::size_t p = 0; p < boxes.size(); ++p) {
    const auto at = [&](std::size_t i) { return boxes.vertices[boxes.loop(p)[i]]; };
    const glm::dvec3 middle{p < 6 ? 2.5 : 12.5, 4, 5.5};
    ASSERT_EQ(boxes.loop(p).size(), 4U);
    EXPECT_EQ(at(0) + at(2), at(1) + at(3)) << "a rectangle";
    EXPECT_GT(glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), at(0) - middle), 0) << p;
  }
  const InnerBoxes again = find_inner_boxes(boxes);
  EXPECT_EQ(again.boxes.size(), 2U) << "closed";
  EXPECT_EQ(soup_of({}).size(), 0U);
}

}  // namespace inner_boxes_test
