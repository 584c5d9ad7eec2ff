// SPDX-License-Identifier: MIT
// Cases of all families against copies of themselves that must have the same answer. No oracle is needed to find a
// difference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "cases/ask.h"
#include "kernel/exact_copies.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"
#include "occlude/kernel/overlap.h"
#include "seed.h"

namespace metamorphic_test {

using namespace occlude;
using namespace occlude::kernel;
using Loop = std::vector<Vec3>;

/// All that `certified` answers about a case.
struct Answer {
  Refusal refusal = Refusal::none;
  Relation overlap = Relation::partial, conservative = Relation::partial;

  friend bool operator==(const Answer&, const Answer&) = default;
  friend void PrintTo(const Answer& answer, std::ostream* out) {
    *out << to_string(answer.refusal) << '/' << to_string(answer.overlap) << '/' << to_string(answer.conservative);
  }
};

Answer answer_of(const fuzz::Case& c) {
  const auto made = fuzz::make_frustum(c);
  if (!made.frustum) return {.refusal = made.refusal};
  return {Refusal::none, fuzz::overlap(*made.frustum, c.box).relation, fuzz::conservative(*made.frustum, c.box).relation};
}

/// Whether the near plane is the kernel's choice, as it is for `surface` and a polygon that is not coplanar. A copy may then
/// have another one.
bool is_chosen_near_plane(const fuzz::Case& c) {
  const auto made = fuzz::make_frustum(c);
  return made.frustum && made.frustum->support_plane();
}

bool is_legal(const fuzz::Case& c) { return fuzz::check(c.box) == Refusal::none; }

std::vector<fuzz::Case> exact_copies(const fuzz::Case& c) {
  std::vector<fuzz::Case> copies;
  for (const auto& similarities : {permutations_and_mirrors(), scalings(), translations()}) {
    for (const Similarity& similarity : similarities) {
      if (const auto image = copy(c, similarity)) copies.push_back(*image);
    }
  }
  return copies;
}

/// Whether no other vertex is nearly as far as the farthest. Then the order of the vertices cannot matter. Otherwise it
/// decides which of several equally far vertices gives the near plane of `farthest` (overlap.h).
bool has_clear_farthest(const Viewpoint& viewpoint, const Loop& loop) {
  std::vector<double> distances;
  for (const Vec3& v : loop) {
    const Vec3& e = viewpoint.value;
    const double x = v.x - e.x, y = v.y - e.y, z = v.z - e.z;
    distances.push_back(viewpoint.is_eye() ? x * x + y * y + z * z : v.x * e.x + v.y * e.y + v.z * e.z);
  }
  const auto farthest = static_cast<std::size_t>(std::ranges::max_element(distances) - distances.begin());
  double scale = 0;
  for (const double d : distances) scale = std::max(scale, std::fabs(d));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i] != loop[farthest] && distances[i] > distances[farthest] - 1e-6 * scale) return false;
  }
  return true;
}

fuzz::Case with_occluder(fuzz::Case c, fuzz::Occluder occluder) {
  c.occluder = std::move(occluder);
  return c;
}

fuzz::Case with_box(fuzz::Case c, const fuzz::Box& box) {
  c.box = box;
  return c;
}

/// The occluder with its loop, or the loops of its faces, written in other ways.
std::vector<fuzz::Case> other_spellings(const fuzz::Case& c) {
  if (const auto* const polytope = std::get_if<Polytope>(&c.occluder)) {
    Polytope reversed = *polytope, rotated = *polytope;
    for (auto& face : reversed.faces) std::ranges::reverse(face);
    std::ranges::reverse(rotated.faces);
    for (auto& face : rotated.faces) std::rotate(face.begin(), face.begin() + 1, face.end());
    return {with_occluder(c, reversed), with_occluder(c, rotated)};
  }
  const Loop& loop = std::get<Loop>(c.occluder);
  Loop reversed(loop.rbegin(), loop.rend()), rotated = loop, repeated;
  std::rotate(rotated.begin(), rotated.begin() + 1, rotated.end());
  for (const Vec3& v : loop) repeated.insert(repeated.end(), 2, v);
  std::vector<fuzz::Case> spellings{with_occluder(c, repeated)};
  if (c.near == Near::farthest && !has_clear_farthest(c.viewpoint, loop)) return spellings;
  spellings.push_back(with_occluder(c, reversed));
  spellings.push_back(with_occluder(c, rotated));
  return spellings;
}

Vec3 negative(const Vec3& v) { return {-v.x, -v.y, -v.z}; }

/// The average of a and b if it is exact.
std::optional<double> middle(double a, double b) {
  const double sum = a + b;
  return sum - a == b && sum - b == a ? std::optional(sum / 2) : std::nullopt;
}

std::optional<Obb> as_oriented(const Aabb& box) {
  Obb oriented;
  for (int k = 0; k < 3; ++k) {
    const auto center = middle(box.min[k], box.max[k]), half = middle(box.max[k], -box.min[k]);
    if (!center || !half) return std::nullopt;
    oriented.center[k] = *center;
    oriented.half_edges[static_cast<std::size_t>(k)][k] = *half;
  }
  return kernel::check(oriented) == Refusal::none ? std::optional(oriented) : std::nullopt;
}

/// The same set of points as a box, written in other ways.
std::vector<fuzz::Case> other_boxes(const fuzz::Case& c) {
  if (const auto* const aabb = std::get_if<Aabb>(&c.box)) {
    const auto oriented = as_oriented(*aabb);
    return oriented ? std::vector{with_box(c, *oriented)} : std::vector<fuzz::Case>{};
  }
  const auto& [center, h] = std::get<Obb>(c.box);
  return {with_box(c, Obb{center, {h[1], h[2], h[0]}}), with_box(c, Obb{center, {h[1], h[0], h[2]}}),
          with_box(c, Obb{center, {negative(h[0]), h[1], h[2]}}),
          with_box(c, Obb{center, {negative(h[2]), negative(h[1]), negative(h[0])}})};
}

/// A random box within the box.
fuzz::Box shrunk(fuzz::Random& random, const fuzz::Box& box) {
  if (const auto* const aabb = std::get_if<Aabb>(&box)) {
    Aabb part;
    for (int k = 0; k < 3; ++k) {
      const auto between = [&] { return std::clamp(random.real(aabb->min[k], aabb->max[k]), aabb->min[k], aabb->max[k]); };
      const double a = random.chance(0.5) ? aabb->min[k] : between(), b = random.chance(0.5) ? aabb->max[k] : between();
      part.min[k] = std::min(a, b);
      part.max[k] = std::max(a, b);
    }
    return part;
  }
  Obb part = std::get<Obb>(box);
  for (Vec3& half_edge : part.half_edges) {
    const double factor = random.chance(0.5) ? 1 : -0.5;
    half_edge = {factor * half_edge.x, factor * half_edge.y, factor * half_edge.z};
  }
  return part;
}

class Metamorphic : public testing::TestWithParam<fuzz::Family> {
 protected:
  /// Calls `examine(case, seed)` for legal cases of the family.
  template <class Examine>
  void for_each_case(const Examine& examine) {
    const std::uint64_t base = occlude::seed_of(1);
    constexpr std::uint64_t kCases = 100;
    for (std::uint64_t seed = base * kCases; seed < (base + 1) * kCases; ++seed) {
      SCOPED_TRACE("family " + std::string(fuzz::name(GetParam())) + ", seed " + std::to_string(seed));
      const fuzz::Case c = fuzz::make_case(GetParam(), seed);
      if (is_legal(c)) examine(c, seed);
    }
  }
};

TEST_P(Metamorphic, CopiesAnswerAsTheCase) {
  std::size_t cases = 0, copies = 0;
  for_each_case([&](const fuzz::Case& c, std::uint64_t) {
    if (is_chosen_near_plane(c)) return;
    const Answer answer = answer_of(c);
    ++cases;
    // `conservative` asks planes alone, so it does not depend on how the box is written either.
    for (const auto& images : {exact_copies(c), other_spellings(c), other_boxes(c)}) {
      for (const fuzz::Case& image : images) EXPECT_EQ(answer_of(image), answer);
      copies += images.size();
    }
  });
  std::printf("%zu copies of %zu cases\n", copies, cases);
  EXPECT_GT(copies, 6 * cases);
}

TEST_P(Metamorphic, WhatIsWithinABoxInsideIsInside) {
  for_each_case([](const fuzz::Case& c, std::uint64_t seed) {
    const auto made = fuzz::make_frustum(c);
    if (!made.frustum || fuzz::overlap(*made.frustum, c.box).relation != Relation::inside) return;
    fuzz::Random random(seed);
    for (int i = 0; i < 8; ++i) {
      const fuzz::Box part = shrunk(random, c.box);
      if (fuzz::check(part) != Refusal::none) continue;
      EXPECT_EQ(fuzz::overlap(*made.frustum, part).relation, Relation::inside) << i;
      EXPECT_EQ(fuzz::conservative(*made.frustum, part).relation, Relation::inside) << i;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(All, Metamorphic, testing::ValuesIn(fuzz::families().begin(), fuzz::families().end()),
                         [](const auto& family) { return std::string(fuzz::name(family.param)); });

}  // namespace metamorphic_test
