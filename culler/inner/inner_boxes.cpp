// SPDX-License-Identifier: MIT
#include "occlude/culler/inner_boxes.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "frusta/closed_parts.h"
#include "frusta/solid.h"
#include "inner/solid_cells.h"
#include "model/adjacency.h"
#include "model/bounds.h"
#include "model/legal_soup.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

using kernel::Aabb;

/// A box with an eighth of the volume has a quarter of the area: a smaller one hides little beside the first.
constexpr std::size_t kSmaller = 8;
/// A double has 53 bits: so many halvings place a face to the last bit, unless its coordinate is much smaller than the box.
constexpr int kHalvings = 64;
/// Cells between a block and the box that is tried first: rounding moves no triangle so far out of the cell that it marks,
/// if the part has some thousand doubles across. Growing makes up for it.
constexpr double kInset = 0x1p-10;

/// What came of a part.
struct PartResult {
  bool is_closed = false;
  std::vector<Aabb> boxes;
  double volume = 0;  ///< of the smallest box that holds the part
};

double volume(const Aabb& box) { return (box.max.x - box.min.x) * (box.max.y - box.min.y) * (box.max.z - box.min.z); }

/// Whether the box may be asked about: it and its middle are legal, and the middle is not on its borders.
bool is_askable(const Aabb& box) {
  const kernel::Vec3 inner = middle(box);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] < inner[axis] && inner[axis] < box.max[axis])) return false;
  }
  return kernel::check(box) == kernel::Refusal::none && kernel::check(inner) == kernel::Refusal::none;
}

using Triangles = std::vector<const SolidTriangle*>;

/// Those of the triangles that come into the box without its borders.
Triangles meeting(const Triangles& triangles, const Aabb& box) {
  Triangles result;
  for (const SolidTriangle* const triangle : triangles) {
    if (meets_interior(*triangle, box)) result.push_back(triangle);
  }
  return result;
}

/// Boxes in one solid, all of them proven.
class BoxMaker {
 public:
  BoxMaker(const Solid& solid, const Checkpoint& checkpoint) : solid_(solid), checkpoint_(checkpoint) {
    for (const SolidTriangle& triangle : solid.triangles) all_.push_back(&triangle);
  }

  /// The proof: the box without its borders is connected, and no triangle comes into it; so it is inside if one point is.
  [[nodiscard]] bool is_proven(const Aabb& box) const {
    checkpoint_();
    return is_askable(box) && meeting(all_, box).empty() && is_inside(solid_, middle(box));
  }

  /// `box` with its faces moved outwards towards those of `limit` together, as far as no triangle comes in. REQUIRES: a
  /// proven box, within the limit. Then so is the result.
  [[nodiscard]] Aabb grown(Aabb box, Aabb limit) const {
    checkpoint_();
    if (!is_askable(limit)) return box;
    Triangles in_limit = meeting(all_, limit);
    if (in_limit.empty()) return limit;
    for (int i = 0; i < kHalvings; ++i) {
      checkpoint_();
      const Aabb between{middle(box.min, limit.min), middle(box.max, limit.max)};
      if (between == box || between == limit || !is_askable(between)) break;
      Triangles in_between = meeting(in_limit, between);
      if (in_between.empty()) {
        box = between;
      } else {
        limit = between;
        in_limit = std::move(in_between);
      }
    }
    return box;
  }

 private:
  const Solid& solid_;
  const Checkpoint& checkpoint_;
  Triangles all_;
};

/// The proven box with all faces moved outwards together, to `around` at most, so that none takes the room of another; then
/// one face after another, to that of `space` at most.
Aabb filled(const BoxMaker& maker, const Aabb& core, const Aabb& around, const Aabb& space) {
  Aabb box = maker.grown(core, around);
  for (int axis = 0; axis < 3; ++axis) {
    Aabb lower = box;
    lower.min[axis] = space.min[axis];
    box = maker.grown(box, lower);
    Aabb upper = box;
    upper.max[axis] = space.max[axis];
    box = maker.grown(box, upper);
  }
  return box;
}

std::vector<Aabb> boxes_in(const Solid& solid, const InnerBoxOptions& options, const Checkpoint& checkpoint) {
  std::vector<Aabb> boxes;
  if (!is_askable(solid.box)) return boxes;
  SolidCells cells(solid, std::clamp<std::size_t>(options.cells, 3, SolidCells::kMostCells), checkpoint);
  const BoxMaker maker(solid, checkpoint);
  std::size_t largest = 0;
  for (std::size_t i = 0; i < options.boxes; ++i) {
    const std::optional<SolidCells::Block> block = cells.largest();
    if (!block || block->cells() * kSmaller < largest) break;
    largest = std::max(largest, block->cells());
    cells.take(*block);
    const Aabb core = cells.box(*block, kInset);
    if (maker.is_proven(core)) boxes.push_back(filled(maker, core, cells.box(cells.one_more(*block)), solid.box));
  }
  return boxes;
}

}  // namespace

InnerBoxes find_inner_boxes(SoupView soup, const InnerBoxOptions& options,
                            const std::function<void(std::size_t done, std::size_t all)>& progress,
                            const Checkpoint& checkpoint) {
  require_legal(soup);
  const std::vector<std::uint32_t> weld = welded(soup.vertices, checkpoint);
  const std::vector<std::vector<std::uint32_t>> parts = find_parts(soup, weld, checkpoint);
  std::vector<PartResult> results(parts.size());
  std::mutex mutex;
  std::size_t done = 0;
  const auto work = [&](std::size_t i) {
    if (is_closed(soup, weld, parts[i])) {
      const Solid solid(soup, parts[i]);
      results[i] = {true, boxes_in(solid, options, checkpoint), volume(solid.box)};
    }
    if (!progress) return;
    const std::lock_guard lock(mutex);
    progress(++done, parts.size());
  };
  parallel_for(parts.size(), work, checkpoint);

  InnerBoxes found;
  found.parts = parts.size();
  double first = 0, all = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PartResult& result = results[i];
    for (const Aabb& box : result.boxes) found.boxes.push_back({box, parts[i].front()});
    found.closed_parts += result.is_closed ? 1 : 0;
    found.filled_parts += result.boxes.empty() ? 0 : 1;
    first += result.boxes.empty() ? 0 : volume(result.boxes.front());
    all += result.volume;
  }
  if (all > 0) found.share = first / all;
  return found;
}

PolygonSoup soup_of(std::span<const InnerBox> boxes) {
  PolygonSoup soup;
  for (const InnerBox& inner : boxes) soup.add_box(to_glm(inner.box.min), to_glm(inner.box.max));
  return soup;
}

}  // namespace occlude::culler
