// SPDX-License-Identifier: MIT
#include "cover/idle_nodes.h"

#include <algorithm>
#include <cstddef>
#include <functional>

#include "cover/projected_boxes.h"

namespace occlude::culler {

void IdleNodes::begin(const CoverOptions& options) {
  is_looking_ = false;
  if (options.as_before) {
    set_.begin_again(options.as_before->idle);
  } else {
    set_.begin_alone();
  }
}

void IdleNodes::begin_next(WorthOfHiding::Frame kind, std::size_t nodes, CullResult& frame) {
  is_looking_ = kind == WorthOfHiding::Frame::looks;
  set_.begin_next(kind, nodes);
  const std::size_t most = frame.culled.capacity();  // one for each leaf at most
  frame.idle.reserve(most);
  entered_.clear();
  entered_.reserve(most);
  hiding_leaves_.reserve(most);
}

void IdleNodes::find(const Hierarchy& hierarchy, CoverBuffer& buffer, std::span<const SeenLeaf> seen,
                     const CullResult& frame) {
  hiding_.begin(buffer);
  hide(hierarchy, buffer, frame.culled);
  hiding_.find(buffer.closings());
  hiding_leaves_.clear();
  for (const SeenLeaf& leaf : seen) {
    if (!leaf.is_taken()) continue;
    if (hiding_.has_hidden(leaf.group, leaf.footprint.pixels)) {
      hiding_leaves_.push_back(leaf.items.first);
    } else {
      set_.set(leaf.node);
    }
  }
  std::ranges::sort(hiding_leaves_);
  const auto first_of = [&](const Culled& culled) { return hierarchy.nodes()[culled.node].first; };
  for (const std::uint32_t node : entered_) {
    const HierarchyNode& n = hierarchy.nodes()[node];
    const auto is_below = [&](const auto& sorted, const auto& first) {
      const auto next = std::ranges::lower_bound(sorted, n.first, {}, first);
      return next != sorted.end() && std::invoke(first, *next) < n.first + n.count;
    };
    if (!is_below(frame.culled, first_of) && !is_below(hiding_leaves_, std::identity())) set_.set(node);
  }
}

void IdleNodes::hide(const Hierarchy& hierarchy, const CoverBuffer& buffer, std::span<const Culled> culled) {
  ProjectedBoxes boxes;
  const auto hide = [&] {
    boxes.project(buffer.box_picture());
    hiding_.hide(boxes, boxes.all());
    boxes.size = 0;
  };
  for (const Culled& c : culled) {
    if (c.by != Culled::By::cover) continue;
    boxes.add(buffer.box_picture(), hierarchy.nodes()[c.node].box);
    if (boxes.size == BoxPixels::kMost) hide();
  }
  hide();
}

}  // namespace occlude::culler
