// SPDX-License-Identifier: MIT
#include "page_pieces.h"

#include <algorithm>
#include <functional>

namespace occlude::render {

void PagePieces::count(const culler::CoverWitness& cover) {
  leaves_.clear();
  for (const std::uint32_t p : cover.polygons) {  // ascending, and so are their leaves
    const std::uint32_t leaf = model_.leaf_of(p);
    if (leaves_.empty() || leaves_.back() != leaf) leaves_.push_back(leaf);
  }
  for (const std::uint32_t leaf : leaves_) hidden_[leaf] += cover.range.count;
}

void PagePieces::add(const culler::CullResult& frame, std::span<const culler::CoverWitness> covers) {
  std::ranges::fill(hidden_, 0);
  for (const culler::CoverWitness& cover : covers) count(cover);
  std::uint32_t leaf = 0;
  const auto add_culled = [&](std::uint32_t end) {
    for (; leaf < end; ++leaf) {
      if (hidden_[leaf] > 0) records_[leaf].add(frame_, hidden_[leaf]);
    }
  };
  for (const culler::PolygonRange& range : frame.drawn) {
    const auto [first, count] = model_.leaves_of(range);
    add_culled(first);
    for (; leaf < first + count; ++leaf) records_[leaf].add(frame_, hidden_[leaf]);
  }
  add_culled(static_cast<std::uint32_t>(hidden_.size()));
  ++frame_;
}

PagePieces::Ranking PagePieces::ranking(std::size_t most) const {
  Ranking result;
  for (std::uint32_t leaf = 0; leaf < records_.size(); ++leaf) {
    const HiderRecord& record = records_[leaf];
    if (record.frames == 0) continue;
    ++result.used;
    result.uses += record.frames;
    result.idle += record.useless;
    if (record.hidden > 0) result.best.push_back(leaf);
    if (!record.is_useless()) continue;
    ++result.useless;
    result.worst.push_back(leaf);
  }
  const auto keep = [&](std::vector<std::uint32_t>& leaves, std::size_t HiderRecord::*by) {
    const auto end = leaves.begin() + static_cast<std::ptrdiff_t>(std::min(most, leaves.size()));
    std::ranges::partial_sort(leaves, end, [&](std::uint32_t a, std::uint32_t b) {
      return records_[a].*by != records_[b].*by ? records_[a].*by > records_[b].*by : a < b;
    });
    leaves.erase(end, leaves.end());
  };
  keep(result.best, &HiderRecord::hidden);
  keep(result.worst, &HiderRecord::useless);
  return result;
}

}  // namespace occlude::render
