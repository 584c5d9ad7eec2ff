// SPDX-License-Identifier: MIT
// Oriented boxes that scenes keep, against what they were packed from.
#include "scene/packed_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "model/bounds.h"
#include "model/outer_box.h"
#include "occlude/kernel/validity.h"
#include "scenes.h"

namespace packed_edges_test {

using namespace occlude;
using namespace occlude::culler;
using kernel::Aabb;
using kernel::Obb;
using kernel::Vec3;

constexpr std::uint32_t kSeed = 20261;

using Axes = std::array<glm::dvec3, 3>;

Axes random_axes(std::mt19937& random) {
  const auto vector = [&] { return to_glm(random_vector(random, -1, 1)); };
  Axes axes;
  axes[0] = glm::normalize(vector());
  axes[1] = glm::normalize(glm::cross(axes[0], vector()));
  axes[2] = glm::cross(axes[0], axes[1]);
  return axes;
}

/// Turned about the vertical.
Axes upright_axes(std::mt19937& random) {
  const double angle = uniform(random, 0, 6.28), c = std::cos(angle), s = std::sin(angle);
  return {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
}

Obb box_of(const Vec3& center, const Axes& axes, const glm::dvec3& size) {
  Obb box{center, {}};
  for (std::size_t k = 0; k < axes.size(); ++k) box.half_edges[k] = to_kernel(size[static_cast<int>(k)] * axes[k]);
  return box;
}

using Wide = std::array<long double, 3>;

/// A corner of the box, from a point near its centre.
Wide corner_of(const Obb& box, unsigned i, const Vec3& from) {
  Wide corner;
  for (int axis = 0; axis < 3; ++axis) {
    long double& x = corner[static_cast<std::size_t>(axis)];
    x = static_cast<long double>(box.center[axis]) - static_cast<long double>(from[axis]);
    for (std::size_t k = 0; k < 3; ++k)
      x += (i >> k & 1U ? 1.0L : -1.0L) * static_cast<long double>(box.half_edges[k][axis]);
  }
  return corner;
}

/// How far the corners of a box reach in another one along each of its edges, as a share of it. What both have 0 of on an
/// axis leaves that axis out.
long double reach(const Obb& box, const Obb& within) {
  std::array<Wide, 3> e;
  for (std::size_t k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis) e[k][static_cast<std::size_t>(axis)] = within.half_edges[k][axis];
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {  // a flat one gets a width across, in which nothing lies beside it
    if (e[0][axis] != 0 || e[1][axis] != 0 || e[2][axis] != 0) continue;
    e[2][axis] = 1;
  }
  const auto determinant = [](const Wide& a, const Wide& b, const Wide& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const long double volume = determinant(e[0], e[1], e[2]);
  long double most = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const Wide to = corner_of(box, i, within.center);
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<Wide, 3> of = e;
      of[k] = to;
      most = std::max(most, std::fabs(determinant(of[0], of[1], of[2]) / volume));
    }
  }
  return most;
}

/// The largest of the ratios of widths along some directions.
double growth(std::mt19937& random, const Obb& box, const Obb& grown) {
  const auto width = [](const Obb& of, const glm::dvec3& n) {
    double sum = 0;
    for (const Vec3& edge : of.half_edges) sum += std::fabs(glm::dot(n, to_glm(edge)));
    return sum;
  };
  double most = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 n = to_glm(random_vector(random, -1, 1));
    most = std::max(most, width(grown, n) / width(box, n));
  }
  return most;
}

struct Kind {
  const char* name;
  std::function<Obb(std::mt19937&)> make;
  double growth;  ///< along most directions
  double packed;  ///< share of the boxes that are packed at all
};

std::vector<Kind> kinds() {
  const auto at = [](std::mt19937& random, double far = 50) { return random_vector(random, -far, far); };
  const auto size = [](std::mt19937& random) { return to_glm(random_vector(random, 0.2, 2)); };
  return {
      {"turned", [=](auto& r) { return box_of(at(r), random_axes(r), size(r)); }, 1.02, 0.99},
      {"upright", [=](auto& r) { return box_of(at(r), upright_axes(r), size(r)); }, 1.01, 1},
      {"far", [=](auto& r) { return box_of(at(r, 1e6), upright_axes(r), size(r)); }, 1.01, 1},
      {"wall",
       [=](auto& r) {
         return box_of(at(r), upright_axes(r), {10, 0.1, 3});
       },
       1.1, 1},
      {"sheet",
       [=](auto& r) {
         return box_of(at(r), random_axes(r), {2, 1, 0});
       },
       1.2, 0.99},
      {"floor",
       [=](auto& r) {
         return box_of({1, 2, 0}, upright_axes(r), {2, 1, 0});
       },
       1.01, 1},
      {"skewed",
       [=](auto& r) {
         return Obb{at(r), {random_vector(r, -1, 1), random_vector(r, -1, 1), random_vector(r, -1, 1)}};
       },
       1.2, 0.99},
  };
}

TEST(PackedEdges, HoldWhatWasPackedAndLittleMore) {
  std::mt19937 random(kSeed);
  for (const Kind& kind : kinds()) {
    std::size_t packed = 0, small = 0;
    constexpr std::size_t kBoxes = 2000;
    for (std::size_t i = 0; i < kBoxes; ++i) {
      const Obb box = kind.make(random);
      const Aabb outer = outer_box(box);
      const PackedEdges edges(box, outer);
      if (edges.is_none()) continue;
      ++packed;
      const Obb unpacked = edges.box(outer);
      ASSERT_EQ(kernel::check(unpacked), kernel::Refusal::none) << kind.name;
      ASSERT_LE(reach(box, unpacked), 1) << kind.name << " " << i << ", seed " << kSeed;
      small += growth(random, box, unpacked) < kind.growth;
    }
    EXPECT_GE(packed, kind.packed * kBoxes) << kind.name;
    EXPECT_GE(small, 0.9 * kBoxes) << kind.name;
  }
}

/// Where doubles become twice as coarse, the middle of the outer box is beside that of the box.
TEST(PackedEdges, HoldWhatIsNearlyLostBesideItsPlace) {
  std::mt19937 random(kSeed);
  std::size_t packed = 0, beside = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::ldexp(1, -16 - static_cast<int>(random() % 8));
    const auto coordinate = [&] { return 0x1p30 + std::ldexp(static_cast<int>(random() % 64) - 32, -23); };
    Obb box = box_of({0, 0, 0}, random_axes(random), {size, size, size / 2});
    for (int axis = 0; axis < 3; ++axis) box.center[axis] = coordinate();
    const Aabb outer = outer_box(box);
    const PackedEdges edges(box, outer);
    if (edges.is_none()) continue;
    ++packed;
    const Obb unpacked = edges.box(outer);
    beside += box.center.x != unpacked.center.x || box.center.y != unpacked.center.y;
    ASSERT_LE(reach(box, unpacked), 1) << i << ", seed " << kSeed;
  }
  EXPECT_GT(packed, 5000U);
  EXPECT_GT(beside, 500U);
}

/// Rotations leave numbers that are nearly 0; a scale may leave large ones.
TEST(PackedEdges, OfAnySizeAreLegal) {
  const auto turned = [](double size) {
    return Obb{{3 * size, 0, 0}, {{{size, size, 6e-17 * size}, {-size, size, 0}, {0, 6e-17 * size, size}}}};
  };
  std::size_t packed = 0;
  for (int exponent = -100; exponent < 98; ++exponent) {
    const Obb box = turned(std::ldexp(1, exponent));
    const Aabb outer = outer_box(box);
    const PackedEdges edges(box, outer);
    if (edges.is_none()) continue;
    ++packed;
    const Obb unpacked = edges.box(outer);
    ASSERT_EQ(kernel::check(unpacked), kernel::Refusal::none) << exponent;
    ASSERT_LE(reach(box, unpacked), 1) << exponent;
  }
  EXPECT_GT(packed, 180U);
  const Obb point{{1, 2, 3}, {}};
  EXPECT_TRUE(PackedEdges(point, outer_box(point)).is_none());
}

}  // namespace packed_edges_test
