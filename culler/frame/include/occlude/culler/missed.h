// SPDX-License-Identifier: MIT
// Why hidden polygons are drawn: what a better choice of occluders, a finer tree, or joined shadows could still cull.
// Reading order: 17.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude::culler {

class CoverBuffer;
class ShadowMargin;
struct FrameView;

/// Reasons, in the order in which they are tested: the first that holds is the answer.
/// 1. Frames by frusta have the first six.
/// 2. Frames by cover have the first two and the last four. For them read "hidden by the frame's final coarse picture" where
///    coarse_node says "in the shadow".
enum class Missed {
  out_of_view,     ///< the polygon is beyond a half-space of the view, its leaf is not
  coarse_node,     ///< the polygon's own box is in the shadow of an occluder of the frame, its leaf's box is not
  straddling_box,  ///< the polygon is in the shadow of an occluder of the frame, its box is not
  several,         ///< each corner is in the shadow of some occluder of the frame, but not all in the same one
  not_chosen,      ///< the polygon is in the shadow of an occluder of the region's list that the frame did not choose
  no_single_one,   ///< no occluder of the list hides it alone: several do, or what it shows is less than a pixel
  beyond_picture,  ///< its box reaches beyond the coarse picture or in front of the near plane
  over_budget,     ///< it would be hidden if the options set no budget for what is drawn into the picture
  open_pixel,      ///< a pixel that its box touches is open: a border runs there, or nothing closes it
  not_behind       ///< all pixels that its box touches are closed, but in one of them not strictly in front of the box
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

/// Finds the reasons for one frame. Shadows are less the frame's margin, begin strictly beyond their near planes, and are
/// decided exactly. For analysis, not for every frame: it makes the shadow of every occluder that the region lists.
/// Const calls may run on several threads at once.
class MissedReasons {
 public:
  /// The most occluders of the region's list that are tried: those that look largest from the eye. Nearly all lists of the
  /// models tried are shorter.
  static constexpr std::size_t kMostListed = 4096;
  /// The default work of answers(): about a second of one processor. The unit is one plane of a shadow that a box or a
  /// corner is tested against (README.md, Budgets).
  static constexpr std::size_t kMostWork = std::size_t{1} << 28U;

  /// REQUIRES: `frame` is what `culler` made of this camera with these options, which is not checked; `culler` and `frame`
  /// outlive this object. For a frame by cover, culls the frame again, and throws as Culler::cull().
  MissedReasons(const Culler& culler, const Camera& camera, const CullOptions& options, const CullResult& frame);
  MissedReasons(const Culler& culler, const MatrixCamera& camera, const CullOptions& options, const CullResult& frame);

  struct Answer {
    Missed reason;
    std::uint32_t occluder = Culled::kNone;  ///< one that hides the polygon alone, as Occluder::index, or kNone

    friend bool operator==(const Answer&, const Answer&) = default;
  };
  /// Why polygon p of Hierarchy::soup() was not culled. Takes as much work as it needs. REQUIRES: p is hidden, and drawn by
  /// the frame.
  [[nodiscard]] Answer answer(std::uint32_t p) const;

  /// A polygon that is hidden and drawn.
  struct MissedPolygon {
    std::uint32_t polygon;
    std::optional<Answer> answer;  ///< as of answer(polygon); none if there was too little work

    friend bool operator==(const MissedPolygon&, const MissedPolygon&) = default;
  };
  using Answers = std::vector<MissedPolygon>;
  /// Everything that the frame missed, ascending, with the reasons as far as `most_work` goes. Runs on all processors; the
  /// result does not depend on their number. shows[p] tells whether polygon p of Hierarchy::soup() is visible in the frame.
  /// What `checkpoint` throws is thrown on. Throws std::invalid_argument unless shows.size() is the number of polygons.
  [[nodiscard]] Answers answers(const std::vector<bool>& shows, const Checkpoint& checkpoint = {},
                                std::size_t most_work = kMostWork) const;

  struct Counts {
    std::size_t missed = 0;                             ///< polygons that are hidden and drawn
    std::array<std::size_t, kMissedReasons> reasons{};  ///< how many of them were missed for each, of those that were asked

    [[nodiscard]] std::size_t asked() const { return std::accumulate(reasons.begin(), reasons.end(), std::size_t{0}); }
    Counts& operator+=(const Counts& other);
  };
  [[nodiscard]] static Counts count(const Answers& answers);

 private:
  struct Shadow {
    std::uint32_t occluder;
    kernel::ShadowFrustum frustum;
  };
  /// The shadows that meet a node.
  struct Meeting {
    std::vector<const Shadow*> chosen, others;
    const Shadow* holder = nullptr;  ///< one of the others, that has all of it
  };
  struct Subtree {
    std::uint32_t node;
    Meeting meeting;
  };
  class Asking;
  class Work;

  template <class AnyCamera>
  void find_what_hides(const AnyCamera& camera, const CullOptions& options);
  void keep_others(const FrameView& view, const CullOptions& options);
  [[nodiscard]] Meeting all() const;
  [[nodiscard]] Meeting narrowed(const Meeting& above, std::uint32_t node, Work& work) const;
  [[nodiscard]] Answer answer(std::uint32_t p, const Meeting& meeting, Work& work) const;
  template <class AnyBox>
  [[nodiscard]] kernel::Relation relation(const Shadow& shadow, const AnyBox& box, Work& work) const;
  [[nodiscard]] bool hides(const Shadow& shadow, std::uint32_t p, Work& work) const;
  [[nodiscard]] bool hides(const Shadow& shadow, const kernel::Aabb& box, Work& work) const;
  [[nodiscard]] bool is_out_of_view(std::uint32_t p, Work& work) const;
  [[nodiscard]] Missed missed_by_cover(const kernel::Aabb& box, Work& work) const;

  const Culler& culler_;
  const Hierarchy& hierarchy_;
  const CullResult& frame_;
  std::vector<Shadow> chosen_, others_;
  std::shared_ptr<const ShadowMargin> margin_;    ///< of a frame by frusta
  std::shared_ptr<const CoverBuffer> cover_;      ///< of a frame by cover
  std::shared_ptr<const CoverBuffer> unlimited_;  ///< the same without a budget, if the frame has spent one
};

}  // namespace occlude::culler
