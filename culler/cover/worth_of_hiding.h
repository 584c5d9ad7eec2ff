// SPDX-License-Identifier: MIT
// How far the next frame of a view looks for what is hidden, by what its frames have found.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "camera/frame_view.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// It decides how much is culled, never whether it may be, and depends on the frames alone, not on time.
class WorthOfHiding {
 public:
  enum class Frame : std::uint8_t {
    whole,  ///< looks at everything, and finds nothing for later ones
    looks,  ///< at everything, and finds what is idle
    saves,  ///< the work on what was idle when one looked (IdleSet)
    rests   ///< hides nothing, because it does not pay
  };

  /// Where a look takes less work than this, saving is not worth it, and frames are whole: 0.3 ms on an AMD EPYC. Tests set
  /// 0.
  std::size_t cheap = 12288;

  /// Begins the next frame. `has_changed` says whether other things may hide than when one looked.
  void begin_next(const FrameView& view, bool has_changed = false) {
    ++since_look_;
    if (is_cheap_) {
      frame_ = Frame::whole;
    } else if (since_look_ >= (has_changed ? kInterval : interval_) || is_elsewhere(view)) {
      frame_ = Frame::looks;
      since_look_ = 0;
      eye_ = view.eye;
      forward_ = view.axes.forward;
    } else {
      frame_ = pays() ? Frame::saves : Frame::rests;
    }
  }
  [[nodiscard]] Frame frame() const { return frame_; }
  /// The options of the frame.
  [[nodiscard]] CoverOptions limited(CoverOptions options) const {
    if (frame_ == Frame::rests) options.work = 0;
    return options;
  }

  /// Learns how many polygons, or objects, the frame has hidden and drawn, with how much work.
  void learn(std::size_t hidden, std::size_t drawn, const CoverWork& work) {
    if (frame_ == Frame::rests) return;
    const std::size_t total = work.drawing + work.asking;
    if (frame_ <= Frame::looks) is_cheap_ = total < cheap;
    const Sums now{static_cast<double>(hidden), static_cast<double>(hidden + drawn), static_cast<double>(total)};
    if (is_first_ || !pays()) sums_ = now.of_frames(kFramesOfFirst);
    if (is_first_) sums_.hidden = kHoped * sums_.all;
    is_first_ = false;
    sums_.add(now);
    if (frame_ == Frame::looks) interval_ = pays() ? kInterval : std::min(2 * interval_, kMostInterval);
  }

 private:
  /// One frame in six looks. With one in four, frames take 1 to 7 % more; with one in eight, Sponza hides half a point less.
  /// While it does not pay, the next look comes after twelve frames, then after 24, then after 48 ever.
  static constexpr std::size_t kInterval = 6, kMostInterval = 48;
  /// Hiding pays while at least this share of what was in view in the last frames, each counted by how much it had in view,
  /// was hidden. Where all is drawn, that costs at most a third more than without what is hidden. Above landscapes it is a
  /// fifth. Of the paths through Sponza, where up to sixty frames in a row hide less than a quarter, all still pays. Frames
  /// that take less than this much work, 2.3 ms on an AMD EPYC, need hide less by as much: a budget that is larger then also
  /// hides more.
  static constexpr double kLeastShare = 0.25, kFrames = 32, kWorkOfShare = 98304;
  /// What the first frame finds counts for the share of all that it is hoped to be, in so many frames. So a view that begins
  /// with a poor frame looks for twenty more.
  static constexpr double kHoped = 0.35, kFramesOfFirst = 8;

  /// A view that has turned so far, or whose eye has moved by such a share of how far the model reaches, sees something else
  /// than when it looked.
  static constexpr double kCosineOfTurn = 0.7, kMove = 1.0 / 8;

  [[nodiscard]] bool is_elsewhere(const FrameView& view) const {
    return glm::dot(forward_, view.axes.forward) < kCosineOfTurn || glm::distance(eye_, view.eye) > kMove * view.depth;
  }
  [[nodiscard]] bool pays() const {
    return sums_.hidden >= kLeastShare * std::min(1.0, sums_.work / sums_.frames / kWorkOfShare) * sums_.all;
  }

  /// Sums over the last frames, in which older ones count for less.
  struct Sums {
    double hidden = 0, all = 0, work = 0, frames = 1;

    /// Of so many frames like this one.
    [[nodiscard]] Sums of_frames(double n) const { return {n * hidden, n * all, n * work, n}; }
    void add(const Sums& frame) {
      hidden += frame.hidden - hidden / kFrames;
      all += frame.all - all / kFrames;
      work += frame.work - work / kFrames;
      frames += 1 - frames / kFrames;
    }
  };

  Frame frame_ = Frame::looks;
  std::size_t interval_ = kInterval, since_look_ = kInterval;  ///< the first frame looks
  glm::dvec3 eye_{}, forward_{};                               ///< of the frame that looked
  bool is_first_ = true, is_cheap_ = false;
  Sums sums_;
};

}  // namespace occlude::culler
