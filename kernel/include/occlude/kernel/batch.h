// SPDX-License-Identifier: MIT
// Many boxes against one frustum, or one box against many frusta: the certified tests in SIMD, with the same relations.
// Reading order: 10.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// A copy of axis-aligned boxes, coordinate by coordinate. REQUIRES (not checked): check(box) == Refusal::none for each.
class BoxBatch {
 public:
  explicit BoxBatch(std::span<const Aabb> boxes);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// REQUIRES: i < size().
  [[nodiscard]] Aabb box(std::size_t i) const;
  /// The smallest box that contains all boxes; the point (0, 0, 0) if there are none.
  [[nodiscard]] const Aabb& bounds() const { return bounds_; }

 private:
  friend struct BatchRows;

  /// Coordinate k of all boxes: k = 0 to 2 are the minima, 3 to 5 the maxima. Readable past size() by one SIMD vector.
  [[nodiscard]] const double* row(std::size_t k) const { return coordinates_.data() + k * stride_; }

  std::size_t size_, stride_;
  std::vector<double> coordinates_;
  Aabb bounds_;
};

/// Sets relation[i] to the relation of box i to the frustum: what the function of the same name for one box answers
/// (overlap.h). Nothing is allocated. REQUIRES (not checked): relation.size() == boxes.size(), and rounding to nearest
/// (validity.h).
void conservative_certified(const ShadowFrustum& frustum, const BoxBatch& boxes, NearBoundary near,
                            std::span<Relation> relation);
void overlap_certified(const ShadowFrustum& frustum, const BoxBatch& boxes, NearBoundary near, std::span<Relation> relation);

/// The planes of shadow frusta, plane by plane. It refers to the frusta: they must outlive it and must not change.
class FrustumBatch {
 public:
  explicit FrustumBatch(std::span<const ShadowFrustum> frusta);

  [[nodiscard]] std::size_t size() const { return frusta_.size(); }
  [[nodiscard]] std::span<const ShadowFrustum> frusta() const { return frusta_; }

 private:
  friend struct BatchRows;

  /// The greatest plane_count() of the frusta.
  [[nodiscard]] std::size_t plane_count() const { return plane_count_; }
  /// Of one plane of every frustum: its normal (k = 0 to 2) and offset (3), size() of them, readable past the end by one
  /// SIMD vector. A frustum with fewer planes has a dummy there, which contains every box. REQUIRES: plane < plane_count().
  [[nodiscard]] const double* plane(std::size_t plane, std::size_t k) const {
    return planes_.data() + (plane * kRows + k) * stride_;
  }
  /// Of every frustum: the coordinates of its origin (k = 0 to 2), the slope (3) and the base (4) of its error bound;
  /// readable past the end likewise. The base is infinite for a frustum that is_none().
  [[nodiscard]] const double* frame(std::size_t k) const { return frames_.data() + k * stride_; }

  static constexpr std::size_t kRows = 4;  ///< numbers of a plane
  std::span<const ShadowFrustum> frusta_;
  std::size_t stride_, plane_count_ = 0;
  std::vector<double> planes_, frames_;
};

/// Sets relation[i] to the relation of the box to frustum i, as above. REQUIRES (not checked): relation.size() ==
/// frusta.size(), check(box) == Refusal::none, and rounding to nearest (validity.h).
void conservative_certified(const FrustumBatch& frusta, const Aabb& box, NearBoundary near, std::span<Relation> relation);
void overlap_certified(const FrustumBatch& frusta, const Aabb& box, NearBoundary near, std::span<Relation> relation);

}  // namespace occlude::kernel
