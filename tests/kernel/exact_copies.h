// SPDX-License-Identifier: MIT
// Copies of a case in which no coordinate is rounded. They must have the same answer.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "occlude/fuzz/cases.h"
#include "occlude/kernel/validity.h"

namespace occlude {

/// Maps (x0, x1, x2) to coordinates factors[k] * x[axes[k]] + offset[k]. The factors are powers of two or their negatives.
struct Similarity {
  std::string name;
  std::array<int, 3> axes{0, 1, 2};
  kernel::Vec3 factors{1, 1, 1}, offset{};
};

/// Applies a similarity to a case, and records whether everything so far was exact and in the legal range.
class Copier {
 public:
  explicit Copier(const Similarity& similarity) : similarity_(similarity) {}

  [[nodiscard]] bool is_exact() const { return is_exact_; }

  kernel::Vec3 vector(const kernel::Vec3& v) {
    kernel::Vec3 image;
    for (int k = 0; k < 3; ++k) image[k] = similarity_.factors[k] * v[similarity_.axes[static_cast<std::size_t>(k)]];
    is_exact_ = is_exact_ && kernel::check(image) == kernel::Refusal::none;
    return image;
  }

  kernel::Vec3 point(const kernel::Vec3& p) {
    kernel::Vec3 image = vector(p);
    for (int k = 0; k < 3; ++k) image[k] = sum(image[k], similarity_.offset[k]);
    is_exact_ = is_exact_ && kernel::check(image) == kernel::Refusal::none;
    return image;
  }

  kernel::Viewpoint viewpoint(const kernel::Viewpoint& v) {
    return v.is_eye() ? kernel::Viewpoint::eye(point(v.value)) : kernel::Viewpoint::direction(vector(v.value));
  }

  std::vector<kernel::Vec3> occluder(std::vector<kernel::Vec3> loop) {
    for (kernel::Vec3& v : loop) v = point(v);
    return loop;
  }
  kernel::Polytope occluder(const kernel::Polytope& polytope) { return {occluder(polytope.vertices), polytope.faces}; }

  kernel::Aabb box(const kernel::Aabb& aabb) {
    const kernel::Vec3 a = point(aabb.min), b = point(aabb.max);
    kernel::Aabb image;
    for (int k = 0; k < 3; ++k) {
      image.min[k] = std::min(a[k], b[k]);
      image.max[k] = std::max(a[k], b[k]);
    }
    return image;
  }
  kernel::Obb box(const kernel::Obb& obb) {
    return {point(obb.center), {vector(obb.half_edges[0]), vector(obb.half_edges[1]), vector(obb.half_edges[2])}};
  }

 private:
  /// The sum is exact when subtracting either term leaves the other.
  double sum(double a, double b) {
    const double s = a + b;
    is_exact_ = is_exact_ && s - a == b && s - b == a;
    return s;
  }

  Similarity similarity_;
  bool is_exact_ = true;
};

/// The copy, if it is exact and in the legal range.
inline std::optional<fuzz::Case> copy(const fuzz::Case& c, const Similarity& similarity) {
  Copier copier(similarity);
  fuzz::Case image;
  image.viewpoint = copier.viewpoint(c.viewpoint);
  image.occluder = std::visit([&](const auto& kind) { return fuzz::Occluder(copier.occluder(kind)); }, c.occluder);
  image.near = c.near;
  image.box = std::visit([&](const auto& kind) { return fuzz::Box(copier.box(kind)); }, c.box);
  return copier.is_exact() ? std::optional(image) : std::nullopt;
}

inline std::vector<Similarity> permutations_and_mirrors() {
  return {
      {.name = "axes rotated", .axes = {1, 2, 0}},
      {.name = "axes rotated back", .axes = {2, 0, 1}},
      {.name = "axes swapped", .axes = {1, 0, 2}},
      {.name = "mirrored in x", .factors = {-1, 1, 1}},
      {.name = "mirrored in y and z", .factors = {1, -1, -1}},
      {.name = "mirrored in all axes", .factors = {-1, -1, -1}},
      {.name = "swapped and mirrored", .axes = {0, 2, 1}, .factors = {1, -1, 1}},
  };
}

inline std::vector<Similarity> scalings() {
  const auto by = [](std::string name, double s) { return Similarity{.name = std::move(name), .factors = {s, s, s}}; };
  return {by("scaled by 2^-60", 0x1p-60), by("scaled by 2^-1", 0x1p-1), by("scaled by 2^3", 0x1p3),
          by("scaled by 2^60", 0x1p60)};
}

inline std::vector<Similarity> translations() {
  return {
      {.name = "moved by whole numbers", .offset = {-1, -1, -1}},
      {.name = "moved along one axis", .offset = {0, -2, 0}},
      {.name = "moved by fractions", .offset = {0.375, -1.25, 0.5}},
      {.name = "moved far", .offset = {0x1p22, -0x1p21, 0x1p20}},
  };
}

}  // namespace occlude
