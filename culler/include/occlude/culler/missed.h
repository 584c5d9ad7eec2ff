// SPDX-License-Identifier: MIT
// Why hidden polygons are drawn: what a better choice of occluders, a finer tree, or shadows taken together would still
// cull. Reading order: 15.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string_view>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude::culler {

/// In the order in which they are asked: the first that holds is the reason. The first two and the last four are those of
/// frames by cover, where what a cover closes takes the place of the shadow of an occluder: its picture as the frame leaves
/// it.
enum class Missed {
  out_of_view,     ///< no shadow is asked for: all of it is beyond a half-space of the view, its leaf is not
  coarse_node,     ///< the polygon's own box is in the shadow of an occluder of the frame, that of its leaf is not
  straddling_box,  ///< the polygon is in the shadow of an occluder of the frame, its box is not
  several,         ///< each corner is in the shadow of some occluder of the frame, but no shadow has all
  not_chosen,      ///< no occluder of the frame, but another of the region's list has the polygon in its shadow
  no_single_one,   ///< no occluder of the list hides it alone: several do, or what it shows is less than a pixel
  beyond_picture,  ///< its box reaches out of the coarse picture, or before the near plane
  over_budget,     ///< it would be hidden if the frame had drawn all that is seen into its picture
  open_pixel,      ///< a pixel that its box touches is open: a border runs there, or nothing closes it
  not_behind       ///< all of these are closed, but in one nothing is nearer than the box
};
inline constexpr std::size_t kMissedReasons = 10;

/// Whether a frame by this method can miss a polygon for this reason.
[[nodiscard]] constexpr bool is_of(Missed reason, Method method) {
  if (reason <= Missed::coarse_node) return true;
  return (reason >= Missed::beyond_picture) == (method == Method::cover);
}

[[nodiscard]] constexpr std::string_view to_string(Missed reason) {
  constexpr std::array<std::string_view, kMissedReasons> kNames{
      "out_of_view",   "coarse_node",    "straddling_box", "several",    "not_chosen",
      "no_single_one", "beyond_picture", "over_budget",    "open_pixel", "not_behind"};
  return kNames[static_cast<std::size_t>(reason)];
}

/// Shadows are taken less the frame's margin, strictly beyond their near planes, and decided exactly. Makes the shadows of
/// what the region lists: for analysis, not for every frame.
class MissedReasons {
 public:
  /// Of a list that is longer, what looks largest from the eye is asked. Nearly all lists of the models tried are shorter.
  static constexpr std::size_t kMostListed = 4096;
  /// Work is counted in planes of shadows that boxes and corners are held against (README.md, Budgets). For all nodes and
  /// polygons of a frame, a second or so of one processor: beyond, polygons are not asked.
  static constexpr std::size_t kMostWork = std::size_t{1} << 28U;

  /// `frame` is what the culler made of this camera with these options, and must outlive this.
  MissedReasons(const Culler& culler, const Camera& camera, const CullOptions& options, const CullResult& frame);

  struct Answer {
    Missed reason;
    std::uint32_t occluder = Culled::kNone;  ///< that hides the polygon alone, in Culler::occluders(); none if none does
  };
  /// Why polygon p of the tree, which is hidden and drawn, was not culled.
  [[nodiscard]] Answer answer(std::uint32_t p) const;

  struct Counts {
    std::size_t missed = 0;                             ///< polygons that are hidden and drawn
    std::array<std::size_t, kMissedReasons> reasons{};  ///< how many of them were missed for each, of those that were asked

    [[nodiscard]] std::size_t asked() const { return std::accumulate(reasons.begin(), reasons.end(), std::size_t{0}); }
    Counts& operator+=(const Counts& other);
  };
  /// Asks all that the frame missed, as far as `most_work` goes; on all processors, the same for any number of them. `shows`
  /// tells of each polygon of the tree whether the frame shows it.
  [[nodiscard]] Counts count(const std::vector<bool>& shows, const Checkpoint& checkpoint = {},
                             std::size_t most_work = kMostWork) const;

 private:
  struct Shadow {
    std::uint32_t occluder;
    kernel::ShadowFrustum frustum;
  };
  /// The shadows that meet a node.
  struct Near {
    std::vector<const Shadow*> chosen, others;
    const Shadow* holder = nullptr;  ///< one of the others, that has all of it
  };
  struct Subtree {
    std::uint32_t node;
    Near near;
  };
  class Asking;
  class Work;

  void keep_others(const Camera& camera, const CullOptions& options);
  [[nodiscard]] Near all() const;
  [[nodiscard]] Near narrowed(const Near& above, std::uint32_t node, Work& work) const;
  [[nodiscard]] Answer answer(std::uint32_t p, const Near& near, Work& work) const;
  template <class AnyBox>
  [[nodiscard]] kernel::Relation relation(const Shadow& shadow, const AnyBox& box, Work& work) const;
  [[nodiscard]] bool hides(const Shadow& shadow, std::uint32_t p, Work& work) const;
  [[nodiscard]] bool hides(const Shadow& shadow, const kernel::Aabb& box, Work& work) const;
  [[nodiscard]] bool is_out_of_view(std::uint32_t p, Work& work) const;
  [[nodiscard]] Missed missed_by_cover(const kernel::Aabb& box, Work& work) const;

  const Hierarchy& hierarchy_;
  const OccluderSet& occluders_;
  const CullResult& frame_;
  std::vector<Shadow> chosen_, others_;
  std::shared_ptr<const CoverBuffer> cover_;      ///< of a frame by cover
  std::shared_ptr<const CoverBuffer> unlimited_;  ///< the same without a budget, if the frame has spent one
};

}  // namespace occlude::culler
