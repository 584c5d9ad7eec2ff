// SPDX-License-Identifier: MIT
// Draws what is seen into the coarse picture of a frame, a few leaves at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/sparse_zero_array.h"
#include "cover/cover_buffer.h"
#include "cover/cover_group.h"
#include "cover/cover_triangles.h"
#include "cover/cull_budget.h"
#include "model/block_tree.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// Polygons that hide in frames by cover, in the order of a tree.
struct CoverSource {
  const CoverTriangles& triangles;
  OccluderInstance instance = {};  ///< how they stand in the scene
  std::size_t first = 0;           ///< the number of their first triangle among those of all sources of the frame
};

/// What is kept from frame to frame, so that only the first allocates.
struct CoverMemory {
  CoverBuffer buffer;                     ///< what the last frame closed
  CoverGroup group;                       ///< what is being drawn into it
  SparseZeroArray<std::uint32_t> stamps;  ///< for each triangle of the sources, the last frame that drew it
  std::uint32_t stamp = 0;                ///< of the frame
  struct Taken {
    ItemRange polygons;
    float nearness;  ///< no point of it is nearer
  };
  std::vector<Taken> taken;  ///< leaves whose polygons are drawn next
};

class CoverPainter {
 public:
  /// Empties the picture, and begins the budget. REQUIRES: `view` reaches as far as all that is tested or hides; what is
  /// given outlives this.
  CoverPainter(const FrameView& view, const CoverOptions& options, double margin, CoverMemory& memory, CullStats& stats);

  /// Reserves memory for sources that together have so many triangles.
  void reserve(std::size_t triangles) { memory_.stamps.grow(triangles); }
  /// The calls that follow are about this source, which outlives them. A frame may come back to a source. REQUIRES: nothing
  /// is enqueued.
  void use(const CoverSource& source);
  /// Keeps the polygons of a leaf of the source for flush_group(). No point of it has more than this nearness.
  void enqueue(const ItemRange& leaf, float nearness);
  /// Draws the kept polygons into the coarse picture, but for leaves that are too small in it to be worth drawing. With them
  /// it draws the triangles of the source that were drawn before and touch them, so that no seam between them stays open.
  /// Returns false if none were kept or the budget is spent. Else the group that was drawn has the number groups().
  bool flush_group();
  /// Ends drawing: layers take over what nearer ones have closed. What is left of the budget is for asking.
  void finish() {
    memory_.buffer.join_layers();
    stats_.cover_work = budget_.work();
    budget_.begin_asking();
  }
  /// Of the frame.
  [[nodiscard]] CullBudget& budget() { return budget_; }
  [[nodiscard]] std::uint32_t groups() const { return groups_; }
  /// Those of the source.
  [[nodiscard]] const CoverTriangles& triangles() const { return source_->triangles; }
  /// Whether more may be drawn.
  [[nodiscard]] bool may_draw() const { return !memory_.buffer.is_spent() && !budget_.is_spent(); }

 private:
  [[nodiscard]] std::size_t drop_small();
  [[nodiscard]] bool is_worth_drawing(const ItemRange& leaf) const;
  bool take_drawn(std::uint32_t triangle);

  const CoverSource* source_ = nullptr;
  CoverMemory& memory_;
  CullStats& stats_;
  CullBudget budget_;
  std::uint32_t groups_ = 0;
  std::size_t next_join_;  ///< when so many triangles are drawn
};

}  // namespace occlude::culler
