// SPDX-License-Identifier: MIT
// What each piece of the covers of a walk hid. A piece is a leaf of the tree: its polygons are drawn into the coarse picture
// together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hider_record.h"
#include "occlude/culler/cull_result.h"
#include "page_model.h"

namespace occlude::render {

class PagePieces {
 public:
  /// `model` must stay as long as this object.
  explicit PagePieces(const PageModel& model) : model_(model), records_(model.leaves()), hidden_(model.leaves()) {}

  /// A frame uses the leaves that it draws and those that hide something. What several pieces hide together counts for each.
  void add(const culler::CullResult& frame, std::span<const culler::CoverWitness> covers);

  /// Of each leaf.
  [[nodiscard]] const std::vector<HiderRecord>& records() const { return records_; }

  struct Ranking {
    std::size_t used = 0, useless = 0;  ///< pieces
    std::size_t uses = 0, idle = 0;     ///< of a piece in a frame, and those of them in which it hid nothing
    std::vector<std::uint32_t> best;    ///< leaves, those that hid most first
    std::vector<std::uint32_t> worst;   ///< useless leaves, those that hid nothing in most frames first
  };
  /// Lists `most` pieces of each kind.
  [[nodiscard]] Ranking ranking(std::size_t most) const;

 private:
  void count(const culler::CoverWitness& cover);

  const PageModel& model_;
  std::vector<HiderRecord> records_;
  std::vector<std::size_t> hidden_;    ///< by each leaf in this frame
  std::vector<std::uint32_t> leaves_;  ///< of a cover
  std::size_t frame_ = 0;
};

}  // namespace occlude::render
