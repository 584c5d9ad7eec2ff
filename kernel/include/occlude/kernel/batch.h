// SPDX-License-Identifier: MIT
// Many boxes against one frustum, one box against many frusta: the certified tests in SIMD, the same answers. Reading
// order: 10.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// Axis-aligned boxes, coordinate by coordinate. REQUIRES of every box: check(box) == Refusal::none; not checked.
class BoxBatch {
 public:
  explicit BoxBatch(std::span<const Aabb> boxes);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Aabb box(std::size_t i) const;
  /// The box around all boxes; the origin when there are none.
  [[nodiscard]] const Aabb& bounds() const { return bounds_; }
  /// Coordinates 0 to 2 are those of the minima, 3 to 5 of the maxima; readable beyond size() up to a whole vector.
  [[nodiscard]] const double* coordinate(std::size_t k) const { return coordinates_.data() + k * stride_; }

 private:
  std::size_t size_, stride_;
  std::vector<double> coordinates_;
  Aabb bounds_;
};

/// relation[i] becomes the relation of box i to the frustum, as the function of the same name answers for one box.
/// REQUIRES: relation.size() == boxes.size(), and rounding to nearest (validity.h).
void conservative_certified(const ShadowFrustum& frustum, const BoxBatch& boxes, NearBoundary near,
                            std::span<Relation> relation);
void overlap_certified(const ShadowFrustum& frustum, const BoxBatch& boxes, NearBoundary near, std::span<Relation> relation);

/// Shadow frusta, plane by plane. Refers to the frusta, which must outlive it.
class FrustumBatch {
 public:
  explicit FrustumBatch(std::span<const ShadowFrustum> frusta);

  /// What the planes number j of all frusta hold, in rows of size() and readable beyond up to a whole vector. A frustum with
  /// fewer planes has one there that all boxes are on the inner side of.
  enum Row : std::size_t { normal_x, normal_y, normal_z, offset, rows };

  [[nodiscard]] std::size_t size() const { return frusta_.size(); }
  [[nodiscard]] std::span<const ShadowFrustum> frusta() const { return frusta_; }
  [[nodiscard]] std::size_t plane_count() const { return plane_count_; }
  [[nodiscard]] const double* row(std::size_t plane, Row row) const {
    return planes_.data() + (plane * rows + row) * stride_;
  }
  /// Coordinates 0 to 2 of the origins of the frusta, slopes (3) and bases (4) of their bounds.
  [[nodiscard]] const double* frame(std::size_t k) const { return frames_.data() + k * stride_; }

 private:
  std::span<const ShadowFrustum> frusta_;
  std::size_t stride_, plane_count_ = 0;
  std::vector<double> planes_, frames_;
};

/// relation[i] becomes the relation of the box to frustum i. REQUIRES: relation.size() == frusta.size(), rounding to nearest
/// and check(box) == Refusal::none; not checked.
void conservative_certified(const FrustumBatch& frusta, const Aabb& box, NearBoundary near, std::span<Relation> relation);
void overlap_certified(const FrustumBatch& frusta, const Aabb& box, NearBoundary near, std::span<Relation> relation);

}  // namespace occlude::kernel
