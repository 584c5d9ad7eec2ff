// SPDX-License-Identifier: MIT
// One descent of a tree, front to back, that culls by the view and by what a cover buffer has closed.
//
// What is not culled goes to `see`, a leaf at a time, and a few leaves together may close pixels for what comes behind them.
// Nothing hides itself: a box reaches what it holds, and is not strictly beyond it.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "bounds.h"
#include "cover_buffer.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/half_space.h"

namespace occlude::culler {

/// Which of two boxes is nearer to a camera: a heuristic.
class FrontToBack {
 public:
  explicit FrontToBack(const Camera& camera)
      : eye_(camera.eye), forward_(camera.axes().forward), is_perspective_(camera.projection == Projection::perspective) {}

  [[nodiscard]] double distance(const kernel::Aabb& box) const {
    if (!is_perspective_) return least(forward_, to_kernel(eye_), box);
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double outside = std::max({box.min[axis] - eye_[axis], eye_[axis] - box.max[axis], 0.0});
      squared += outside * outside;
    }
    return squared;
  }

 private:
  glm::dvec3 eye_, forward_;
  bool is_perspective_;
};

/// `ask` calls a question with the bounding volume of a node; see(leaf, footprint) is told what is not culled,
/// cull(Culled) what is. After
/// each subtree of few items join() is called, and may add to the buffer what was seen. REQUIRES: at most 32 planes.
template <class Ask, class See, class Cull, class Join>
class CoverDescent {
 public:
  /// A subtree of so many items at most is few; a leaf is, however many it has. Fewer draw more that was drawn before, more
  /// delay what is seen for what comes behind it: from 64 to 2,048 it is all the same.
  static constexpr std::uint32_t kFew = 256;

  CoverDescent(std::span<const HierarchyNode> nodes, const Ask& ask, std::span<const kernel::HalfSpace> planes,
               const CullOptions& options, const Camera& camera, const CoverBuffer& buffer, CullStats& stats, const See& see,
               const Cull& cull, const Join& join)
      : nodes_(nodes),
        ask_(ask),
        planes_(planes),
        arithmetic_(options.arithmetic),
        order_(camera),
        buffer_(buffer),
        stats_(stats),
        see_(see),
        cull_(cull),
        join_(join) {}

  void run() { visit(0, planes_.size() < 32 ? (std::uint32_t{1} << planes_.size()) - 1 : ~std::uint32_t{0}, false); }

 private:
  /// `across`: a bit for each plane that the node may be across. `is_part`: of a subtree of few items.
  void visit(std::uint32_t index, std::uint32_t across, bool is_part) {
    const HierarchyNode& node = nodes_[index];
    ++stats_.nodes_visited;
    for (std::uint32_t left = across; left != 0; left &= left - 1) {
      const auto plane = static_cast<std::uint32_t>(std::countr_zero(left));
      ++stats_.view_tests;
      const kernel::Relation relation =
          ask_(index, [&](const auto& box) { return kernel::relation(planes_[plane], box, arithmetic_); });
      if (relation == kernel::Relation::outside) return cull_({index, Culled::By::view, plane});
      if (relation == kernel::Relation::inside) across &= ~(std::uint32_t{1} << plane);
    }
    ++stats_.cover_tests;
    const CoverBuffer::Footprint footprint = buffer_.footprint(node.box);
    if (buffer_.hides(footprint)) return cull_({index, Culled::By::cover});
    const bool is_few = node.is_leaf() || node.count <= kFew;
    if (node.is_leaf()) {
      see_(index, footprint);
    } else {
      const std::uint32_t left = index + 1, right = node.right;
      const bool is_left_first = order_.distance(nodes_[left].box) <= order_.distance(nodes_[right].box);
      visit(is_left_first ? left : right, across, is_part || is_few);
      visit(is_left_first ? right : left, across, is_part || is_few);
    }
    if (is_few && !is_part) join_();
  }

  std::span<const HierarchyNode> nodes_;
  const Ask& ask_;
  std::span<const kernel::HalfSpace> planes_;
  kernel::Arithmetic arithmetic_;
  FrontToBack order_;
  const CoverBuffer& buffer_;
  CullStats& stats_;
  const See& see_;
  const Cull& cull_;
  const Join& join_;
};

}  // namespace occlude::culler
