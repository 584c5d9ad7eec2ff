// SPDX-License-Identifier: MIT
// This file is compiled once for every instruction set; the one that runs is chosen at run time. Boxes that the filter
// cannot decide are left to the test of a single box.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "least_extremes-inl.h"
#include "occlude/kernel/batch.h"
#include "stored_frustum.h"

#ifndef OCCLUDE_BATCH_ONCE
#define OCCLUDE_BATCH_ONCE
namespace occlude::kernel {
namespace {

/// The number of tests that run before the undecided ones among them are finished.
constexpr std::size_t kChunk = 1024;

/// Indices of the tests that the filter leaves undecided.
struct Undecided {
  std::array<std::size_t, kChunk> index;
  std::size_t count = 0;
};

static_assert(sizeof(Relation) == sizeof(std::int32_t));

}  // namespace

/// What the tests read of batches.
struct BatchRows {
  static const double* of(const BoxBatch& boxes, std::size_t k) { return boxes.row(k); }
  static const double* of_frame(const FrustumBatch& frusta, std::size_t k) { return frusta.frame(k); }
  static const double* of_plane(const FrustumBatch& frusta, std::size_t plane, std::size_t k) {
    return frusta.plane(plane, k);
  }
  static std::size_t plane_count(const FrustumBatch& frusta) { return frusta.plane_count(); }
};

}  // namespace occlude::kernel
#endif

HWY_BEFORE_NAMESPACE();
namespace occlude::kernel {
namespace HWY_NAMESPACE {
namespace {

/// Writes the relations of the first `count` lanes to `out`, and lists those that are not known.
HWY_INLINE void store(const Known& known, std::size_t first, std::size_t count, Relation* out, Undecided& undecided) {
  const Doubles d;
  const hn::Rebind<std::int32_t, Doubles> d32;
  const auto code = [&](Relation relation) { return hn::Set(d, static_cast<double>(static_cast<int>(relation))); };
  const auto within = hn::IfThenElse(known.straddling, code(Relation::partial), code(Relation::inside));
  const auto codes = hn::DemoteTo(d32, hn::IfThenElse(known.outside, code(Relation::outside), within));
  if (count >= hn::Lanes(d)) {
    hn::StoreU(codes, d32, reinterpret_cast<std::int32_t*>(out + first));
  } else {
    std::array<std::int32_t, kMaxLanes> all;
    hn::StoreU(codes, d32, all.data());
    std::memcpy(out + first, all.data(), count * sizeof(std::int32_t));
  }
  if (HWY_LIKELY(hn::AllFalse(d, known.unknown))) return;
  std::array<double, kMaxLanes> is_left;
  hn::StoreU(hn::IfThenElseZero(known.unknown, hn::Set(d, 1.0)), d, is_left.data());
  for (std::size_t i = 0; i < std::min(count, hn::Lanes(d)); ++i) {
    if (is_left[i] != 0) undecided.index[undecided.count++] = first + i;
  }
}

/// Loads three neighbouring rows of a batch, k to k + 2, from column `first` on. `row(k)` is the beginning of row k.
template <class Row>
HWY_INLINE LaneVector load(const Row& row, std::size_t first, std::size_t k) {
  return {Lanes::load(row(k) + first), Lanes::load(row(k + 1) + first), Lanes::load(row(k + 2) + first)};
}

/// Moves the boxes that planes of the profile separate from the frustum from straddling to outside.
HWY_INLINE void separate_by_profile(const StoredFrustum& frustum, const Frame& frame, const Frame& bounds, Known& known) {
  if (!frustum.has_profile) {
    known.unknown = hn::Or(known.unknown, known.straddling);
    return;
  }
  Least least;
  for (const FilterPlane& plane : frustum.profile_planes()) {
    least.include(frame.extremes(plane));
  }
  const Lanes error = bounds.error(frustum.profile_bound);
  const Mask separated = hn::And(known.straddling, hn::Lt(least.high.v, hn::Neg(error.v)));
  known.outside = hn::Or(known.outside, separated);
  known.unknown = hn::Or(known.unknown, hn::AndNot(separated, hn::AndNot(hn::Gt(least.high.v, error.v), known.straddling)));
}

HWY_ATTR void BoxesAgainstFrustum(const StoredFrustum& frustum, const BoxBatch& boxes, Test test, std::size_t begin,
                                  std::size_t end, Relation* out, Undecided& undecided) {
  const auto planes = frustum.own_planes();
  const auto origin = constants<LaneArithmetic>(frustum.origin);
  const auto row = [&](std::size_t k) { return BatchRows::of(boxes, k); };
  const Frame bounds(boxes.bounds(), frustum.origin);
  const Lanes error = bounds.error(frustum.filter_bound);
  for (std::size_t first = begin; first < end; first += hn::Lanes(Doubles())) {
    const Frame frame(load(row, first, 0) - origin, load(row, first, 3) - origin);
    Least least;
    for (const FilterPlane& plane : planes) least.include(frame.extremes(plane));
    Known known = classify(least, error);
    if (test == Test::overlap && !hn::AllFalse(Doubles(), known.straddling)) {
      separate_by_profile(frustum, frame, bounds, known);
    }
    store(known, first, end - first, out, undecided);
  }
}

HWY_ATTR void FrustaAgainstBox(const FrustumBatch& frusta, const Aabb& box, std::size_t begin, std::size_t end,
                               Relation* out, Undecided& undecided) {
  const auto box_min = constants<LaneArithmetic>(box.min), box_max = constants<LaneArithmetic>(box.max);
  const auto row_of_frame = [&](std::size_t k) { return BatchRows::of_frame(frusta, k); };
  for (std::size_t first = begin; first < end; first += hn::Lanes(Doubles())) {
    const LaneVector origin = load(row_of_frame, first, 0);
    const Frame frame(box_min - origin, box_max - origin);
    Least least;
    for (std::size_t i = 0; i < BatchRows::plane_count(frusta); ++i) {
      const auto row_of_plane = [&](std::size_t k) { return BatchRows::of_plane(frusta, i, k); };
      const LaneVector normal = load(row_of_plane, first, 0);
      const Lanes offset = Lanes::load(row_of_plane(3) + first);
      least.include(frame.extremes(normal, magnitudes(normal), offset + offset));
    }
    const BasicFilterBound<Lanes> bound{Lanes::load(row_of_frame(3) + first), Lanes::load(row_of_frame(4) + first)};
    store(classify(least, frame.error(bound)), first, end - first, out, undecided);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace occlude::kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace occlude::kernel {
namespace {

HWY_EXPORT(BoxesAgainstFrustum);
HWY_EXPORT(FrustaAgainstBox);

std::size_t padded(std::size_t size) { return size + kMaxLanes; }

/// Calls `run(begin, end, undecided)` for one chunk of [0, size) after another, and `decide(i)` for each test that a chunk
/// leaves.
template <class Run, class Decide>
void in_chunks(std::size_t size, std::span<Relation> out, const Run& run, const Decide& decide) {
  Undecided undecided;
  for (std::size_t begin = 0; begin < size; begin += kChunk) {
    undecided.count = 0;
    run(begin, std::min(begin + kChunk, size), undecided);
    for (std::size_t i = 0; i < undecided.count; ++i) out[undecided.index[i]] = decide(undecided.index[i]);
  }
}

void relate(const ShadowFrustum& frustum, const BoxBatch& boxes, NearBoundary near, Test test, std::span<Relation> out) {
  const StoredFrustum* const planes = stored(frustum);
  if (!planes) return static_cast<void>(std::ranges::fill(out, Relation::partial));
  in_chunks(
      boxes.size(), out,
      [&](std::size_t begin, std::size_t end, Undecided& undecided) {
        HWY_DYNAMIC_DISPATCH(BoxesAgainstFrustum)(*planes, boxes, test, begin, end, out.data(), undecided);
      },
      [&](std::size_t i) { return decide(frustum, boxes.box(i), Arithmetic::certified, test, near).relation; });
}

void relate_planes(const FrustumBatch& frusta, const Aabb& box, NearBoundary near, std::span<Relation> out) {
  in_chunks(
      frusta.size(), out,
      [&](std::size_t begin, std::size_t end, Undecided& undecided) {
        HWY_DYNAMIC_DISPATCH(FrustaAgainstBox)(frusta, box, begin, end, out.data(), undecided);
      },
      [&](std::size_t i) { return conservative_certified(frusta.frusta()[i], box, near).relation; });
}

}  // namespace

BoxBatch::BoxBatch(std::span<const Aabb> boxes)
    : size_(boxes.size()), stride_(padded(size_)), coordinates_(6 * stride_), bounds_(boxes.empty() ? Aabb{} : boxes[0]) {
  for (std::size_t i = 0; i < size_; ++i) {
    for (int k = 0; k < 3; ++k) {
      coordinates_[static_cast<std::size_t>(k) * stride_ + i] = boxes[i].min[k];
      coordinates_[static_cast<std::size_t>(k + 3) * stride_ + i] = boxes[i].max[k];
      bounds_.min[k] = std::min(bounds_.min[k], boxes[i].min[k]);
      bounds_.max[k] = std::max(bounds_.max[k], boxes[i].max[k]);
    }
  }
}

Aabb BoxBatch::box(std::size_t i) const {
  const auto at = [&](std::size_t k) { return row(k)[i]; };
  return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}};
}

FrustumBatch::FrustumBatch(std::span<const ShadowFrustum> frusta) : frusta_(frusta), stride_(padded(frusta.size())) {
  for (const ShadowFrustum& frustum : frusta) plane_count_ = std::max(plane_count_, frustum.plane_count());
  planes_.resize(plane_count_ * kRows * stride_);
  frames_.resize(5 * stride_);
  for (std::size_t i = 0; i < frusta.size(); ++i) {
    const StoredFrustum* const frustum = stored(frusta[i]);
    const auto planes = frustum ? frustum->own_planes() : std::span<const FilterPlane>();
    const Vec3 origin = frustum ? frustum->origin : Vec3{};
    // Of a frustum that was never made no value is known: it is left to the test of a single box.
    const auto& [slope, base] = frustum ? frustum->filter_bound : FilterBound{0, HUGE_VAL};
    const std::array frame{origin.x, origin.y, origin.z, slope, base};
    for (std::size_t k = 0; k < frame.size(); ++k) frames_[k * stride_ + i] = frame[k];
    // A plane with an infinite value decides nothing: every box is on its inner side, beyond every bound.
    const FilterPlane none{.normal = {}, .magnitudes = {}, .offset = HUGE_VAL, .farther = {}};
    for (std::size_t j = 0; j < plane_count_; ++j) {
      const FilterPlane& plane = j < planes.size() ? planes[j] : none;
      const std::array<double, kRows> values{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
      for (std::size_t r = 0; r < kRows; ++r) planes_[(j * kRows + r) * stride_ + i] = values[r];
    }
  }
}

void conservative_certified(const ShadowFrustum& frustum, const BoxBatch& boxes, NearBoundary near,
                            std::span<Relation> relation) {
  relate(frustum, boxes, near, Test::conservative, relation);
}

void overlap_certified(const ShadowFrustum& frustum, const BoxBatch& boxes, NearBoundary near,
                       std::span<Relation> relation) {
  relate(frustum, boxes, near, Test::overlap, relation);
}

void conservative_certified(const FrustumBatch& frusta, const Aabb& box, NearBoundary near, std::span<Relation> relation) {
  relate_planes(frusta, box, near, relation);
}

void overlap_certified(const FrustumBatch& frusta, const Aabb& box, NearBoundary near, std::span<Relation> relation) {
  relate_planes(frusta, box, near, relation);
  for (std::size_t i = 0; i < relation.size(); ++i) {
    if (relation[i] == Relation::partial) relation[i] = overlap_certified(frusta.frusta()[i], box, near).relation;
  }
}

}  // namespace occlude::kernel
#endif
