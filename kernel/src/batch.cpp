// SPDX-License-Identifier: MIT
// Compiled once for every instruction set, chosen at run time. Boxes that the filter cannot decide are left to the test of a
// single box.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h goes first.
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "batch_values-inl.h"
#include "occlude/kernel/batch.h"

#ifndef OCCLUDE_BATCH_ONCE
#define OCCLUDE_BATCH_ONCE
namespace occlude::kernel {
namespace {

/// So many tests run between two rounds of finishing what is left.
constexpr std::size_t kChunk = 1024;

/// Indices of the tests that the filter leaves.
struct Undecided {
  std::array<std::size_t, kChunk> index;
  std::size_t count = 0;
};

double twice_error(const FilterBound& bound, double reach) { return 2 * (bound.slope * reach + bound.base); }

static_assert(sizeof(Relation) == sizeof(std::int32_t));

}  // namespace
}  // namespace occlude::kernel
#endif

HWY_BEFORE_NAMESPACE();
namespace occlude::kernel {
namespace {
namespace HWY_NAMESPACE {

using Mask = hn::Mask<Doubles>;

/// What the filter knows of the tests in the lanes of a vector: inside when none of these is set.
struct Lanes {
  Mask outside, straddling, unknown;
};

/// From the least values of all planes at the extremal vertices of the boxes, nearest and farthest. One bound serves all
/// planes of a frustum: these two are all that the filter needs.
HWY_INLINE Lanes classify(Vector least_low, Vector least_high, Vector error) {
  const Vector minus_error = hn::Neg(error);
  const Mask outside = hn::Lt(least_high, minus_error);
  const Mask straddling = hn::And(hn::Lt(least_low, minus_error), hn::Gt(least_high, error));
  return {outside, straddling, hn::Not(hn::Or(hn::Or(outside, straddling), hn::Gt(least_low, error)))};
}

/// Writes the relations of the first `count` lanes to `out`, and lists those that are not known.
HWY_INLINE void store(const Lanes& lanes, std::size_t first, std::size_t count, Relation* out, Undecided& undecided) {
  const Doubles d;
  const hn::Rebind<std::int32_t, Doubles> d32;
  const auto code = [&](Relation relation) { return hn::Set(d, static_cast<double>(static_cast<int>(relation))); };
  const Vector within = hn::IfThenElse(lanes.straddling, code(Relation::partial), code(Relation::inside));
  const auto codes = hn::DemoteTo(d32, hn::IfThenElse(lanes.outside, code(Relation::outside), within));
  if (count >= hn::Lanes(d)) {
    hn::StoreU(codes, d32, reinterpret_cast<std::int32_t*>(out + first));
  } else {
    std::array<std::int32_t, kMaxLanes> all;
    hn::StoreU(codes, d32, all.data());
    std::memcpy(out + first, all.data(), count * sizeof(std::int32_t));
  }
  if (HWY_LIKELY(hn::AllFalse(d, lanes.unknown))) return;
  std::array<double, kMaxLanes> is_left;
  hn::StoreU(hn::IfThenElseZero(lanes.unknown, hn::Set(d, 1.0)), d, is_left.data());
  for (std::size_t i = 0; i < std::min(count, hn::Lanes(d)); ++i) {
    if (is_left[i] != 0) undecided.index[undecided.count++] = first + i;
  }
}

HWY_INLINE Block load_block(const BoxBatch& boxes, std::size_t first, const Vec3& origin) {
  const Doubles d;
  const auto relative = [&](std::size_t k, double o) {
    return hn::Sub(hn::LoadU(d, boxes.coordinate(k) + first), hn::Set(d, o));
  };
  const Vector x0 = relative(0, origin.x), y0 = relative(1, origin.y), z0 = relative(2, origin.z);
  const Vector x1 = relative(3, origin.x), y1 = relative(4, origin.y), z1 = relative(5, origin.z);
  return {hn::Add(x0, x1), hn::Add(y0, y1), hn::Add(z0, z1), hn::Sub(x1, x0), hn::Sub(y1, y0), hn::Sub(z1, z0)};
}

/// Moves the boxes that planes of the profile part from the frustum from straddling to outside.
HWY_INLINE void part_by_profile(const ShadowFrustum& frustum, const Block& block, double reach, Lanes& lanes) {
  const Doubles d;
  Vector least_high = hn::Set(d, HUGE_VAL);
  for (const FilterPlane& plane : frustum.filter_planes().subspan(frustum.plane_count())) {
    const Values twice = values(block, plane);
    least_high = hn::Min(least_high, hn::Add(twice.center, twice.spread));
  }
  const Vector error = hn::Set(d, twice_error(frustum.profile_bound(), reach));
  const Mask parted = hn::And(lanes.straddling, hn::Lt(least_high, hn::Neg(error)));
  lanes.outside = hn::Or(lanes.outside, parted);
  lanes.unknown = hn::Or(lanes.unknown, hn::AndNot(parted, hn::AndNot(hn::Gt(least_high, error), lanes.straddling)));
}

HWY_ATTR void BoxesAgainstFrustum(const ShadowFrustum& frustum, const BoxBatch& boxes, Test test, double reach,
                                  std::size_t begin, std::size_t end, Relation* out, Undecided& undecided) {
  const Doubles d;
  const auto planes = frustum.filter_planes().first(frustum.plane_count());
  const Vector error = hn::Set(d, twice_error(frustum.filter_bound(), reach));
  for (std::size_t first = begin; first < end; first += hn::Lanes(d)) {
    const Block block = load_block(boxes, first, frustum.origin());
    Vector low = hn::Set(d, HUGE_VAL), high = low;
    for (const FilterPlane& plane : planes) {
      const Values twice = values(block, plane);
      low = hn::Min(low, hn::Sub(twice.center, twice.spread));
      high = hn::Min(high, hn::Add(twice.center, twice.spread));
    }
    Lanes lanes = classify(low, high, error);
    if (test == Test::overlap && !hn::AllFalse(d, lanes.straddling)) part_by_profile(frustum, block, reach, lanes);
    store(lanes, first, end - first, out, undecided);
  }
}

HWY_ATTR void FrustaAgainstBox(const FrustumBatch& frusta, const Aabb& box, std::size_t begin, std::size_t end,
                               Relation* out, Undecided& undecided) {
  const Doubles d;
  for (std::size_t first = begin; first < end; first += hn::Lanes(d)) {
    const auto frame = [&](std::size_t k) { return hn::LoadU(d, frusta.frame(k) + first); };
    const auto relative = [&](double x, std::size_t k) { return hn::Sub(hn::Set(d, x), frame(k)); };
    const Vector x0 = relative(box.min.x, 0), y0 = relative(box.min.y, 1), z0 = relative(box.min.z, 2);
    const Vector x1 = relative(box.max.x, 0), y1 = relative(box.max.y, 1), z1 = relative(box.max.z, 2);
    const auto larger = [](Vector a, Vector b) { return hn::Max(hn::Abs(a), hn::Abs(b)); };
    const Vector reach = hn::Max(hn::Max(larger(x0, x1), larger(y0, y1)), larger(z0, z1));
    Vector low = hn::Set(d, HUGE_VAL), high = low;
    for (std::size_t i = 0; i < frusta.plane_count(); ++i) {
      const auto row = [&](FrustumBatch::Row which) { return hn::LoadU(d, frusta.row(i, which) + first); };
      const Vector nx = row(FrustumBatch::normal_x), ny = row(FrustumBatch::normal_y), nz = row(FrustumBatch::normal_z);
      // The normals differ from lane to lane: so do the extremal vertices.
      const Vector ax = hn::Mul(nx, x0), ay = hn::Mul(ny, y0), az = hn::Mul(nz, z0);
      const Vector bx = hn::Mul(nx, x1), by = hn::Mul(ny, y1), bz = hn::Mul(nz, z1);
      const Vector offset = row(FrustumBatch::offset);
      low = hn::Min(low, hn::Add(hn::Add(hn::Min(ax, bx), hn::Min(ay, by)), hn::Add(hn::Min(az, bz), offset)));
      high = hn::Min(high, hn::Add(hn::Add(hn::Max(ax, bx), hn::Max(ay, by)), hn::Add(hn::Max(az, bz), offset)));
    }
    const Vector error = hn::Add(hn::Mul(frame(3), reach), frame(4));
    store(classify(low, high, error), first, end - first, out, undecided);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace occlude::kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace occlude::kernel {
namespace {

HWY_EXPORT(BoxesAgainstFrustum);
HWY_EXPORT(FrustaAgainstBox);

std::size_t padded(std::size_t size) { return size + kMaxLanes; }

double reach_of(const Aabb& bounds, const Vec3& origin) {
  double reach = 0;
  for (int k = 0; k < 3; ++k) {
    reach = std::max({reach, std::fabs(bounds.min[k] - origin[k]), std::fabs(bounds.max[k] - origin[k])});
  }
  return reach;
}

/// Calls `run(begin, end, undecided)` for parts of [0, size), and `decide(i)` for what each leaves.
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
  if (frustum.is_none()) return static_cast<void>(std::ranges::fill(out, Relation::partial));
  const double reach = reach_of(boxes.bounds(), frustum.origin());
  in_chunks(
      boxes.size(), out,
      [&](std::size_t begin, std::size_t end, Undecided& undecided) {
        HWY_DYNAMIC_DISPATCH(BoxesAgainstFrustum)(frustum, boxes, test, reach, begin, end, out.data(), undecided);
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
  const auto at = [&](std::size_t k) { return coordinate(k)[i]; };
  return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}};
}

FrustumBatch::FrustumBatch(std::span<const ShadowFrustum> frusta) : frusta_(frusta), stride_(padded(frusta.size())) {
  for (const ShadowFrustum& frustum : frusta) plane_count_ = std::max(plane_count_, frustum.plane_count());
  planes_.resize(plane_count_ * rows * stride_);
  frames_.resize(5 * stride_);
  for (std::size_t i = 0; i < frusta.size(); ++i) {
    const Vec3& origin = frusta[i].origin();
    const auto& [slope, base] = frusta[i].filter_bound();
    // Of a frustum that was never made no value is known: it is left to the test of a single box.
    const std::array frame{origin.x, origin.y, origin.z, slope, frusta[i].is_none() ? HUGE_VAL : base};
    for (std::size_t k = 0; k < frame.size(); ++k) frames_[k * stride_ + i] = frame[k];
    // Beyond every bound: a plane that no box reaches.
    const FilterPlane none{.normal = {}, .magnitudes = {}, .offset = HUGE_VAL, .farther = {}};
    for (std::size_t j = 0; j < plane_count_; ++j) {
      const FilterPlane& plane = j < frusta[i].plane_count() ? frusta[i].filter_planes()[j] : none;
      const std::array<double, rows> values{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
      for (std::size_t r = 0; r < rows; ++r) planes_[(j * rows + r) * stride_ + i] = values[r];
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
