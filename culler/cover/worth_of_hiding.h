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
    tries,  ///< with little work, whether to look
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
    } else if (const bool is_new = is_elsewhere(view); is_new || since_look_ >= (has_changed ? kInterval : interval_)) {
      frame_ = is_new || is_hopeful_ ? Frame::looks : Frame::tries;
      since_look_ = 0;
      eye_ = view.eye;
      forward_ = view.axes.forward;
    } else {
      frame_ = sums_.pay() ? Frame::saves : Frame::rests;
    }
  }
  [[nodiscard]] Frame frame() const { return frame_; }
  /// The options of the frame.
  [[nodiscard]] CoverOptions limited(CoverOptions options) const {
    if (frame_ == Frame::rests) options.work = 0;
    if (frame_ == Frame::tries) options.work = std::min(options.work, kWorkOfTry);
    return options;
  }

  /// Learns how many polygons, or objects, the frame has hidden and drawn, with how much work.
  void learn(std::size_t hidden, std::size_t drawn, const CoverWork& work) {
    if (frame_ == Frame::rests) return;
    const std::size_t total = work.drawing + work.asking;
    if (frame_ != Frame::saves) is_cheap_ = total < cheap;
    const Sums now{static_cast<double>(hidden), static_cast<double>(hidden + drawn), static_cast<double>(total)};
    if (frame_ == Frame::tries) return learn_of_try(now);
    if (is_first_ || !sums_.pay()) sums_ = now.of_frames(kFramesOfFirst);
    if (is_first_) sums_.hidden = kHoped * sums_.all;
    sums_.add(now);
    if (frame_ == Frame::looks) {
      work_of_look_ = total;
      learn_of_look(now);
    } else if (!is_cheap_ && total > kMoreThanALook * work_of_look_) {
      since_look_ = interval_;  // the next one looks, or tries
    }
    is_first_ = false;
  }

 private:
  /// One frame in six looks. With one in four, frames take 1 to 7 % more; with one in eight, Sponza hides half a point less.
  /// While it does not pay, the next try comes after twelve frames, then after 24, then after 48 ever.
  static constexpr std::size_t kInterval = 6, kMostInterval = 48;
  /// A frame that takes so many times the work of the last look sees what that did not: what is idle was found where a wall
  /// hid nearly everything, say. In a forest that saves a seventh of the time.
  static constexpr std::size_t kMoreThanALook = 2;
  /// Hiding pays while at least this share of what was in view in the last frames, each counted by how much it had in view,
  /// was hidden. Where all is drawn, that costs at most a third more than without what is hidden. Above landscapes it is a
  /// fifth. Of the paths through Sponza, where up to sixty frames in a row hide less than a quarter, all still pays. Frames
  /// that take less than this much work, 2.3 ms on an AMD EPYC, need hide less by as much: a budget that is larger then also
  /// hides more.
  static constexpr double kLeastShare = 0.25, kFrames = 32, kWorkOfShare = 98304;
  /// What the first frame finds counts for the share of all that it is hoped to be, in so many frames. So a view that begins
  /// with a poor frame looks for twenty more, unless a try after it finds little, too.
  static constexpr double kHoped = 0.35, kFramesOfFirst = 8;
  /// A try takes up to 4.5 ms on an AMD EPYC, where looks take up to 20. If it hides such a share of what is in view, the
  /// next frame looks. Where looks hide less than a quarter, tries hide at most 0.09 above a landscape and up to 0.22 in
  /// Sponza and a castle; where they hide more, at least 0.12 in all three. With half the work, tries above the landscape
  /// hide 0.01 where looks hide 0.55.
  static constexpr std::size_t kWorkOfTry = 196608;
  static constexpr double kShareOfTry = 0.1;

  /// A view that has turned so far, or whose eye has moved by such a share of how far the model reaches, sees something else
  /// than when it looked.
  static constexpr double kCosineOfTurn = 0.7, kMove = 1.0 / 8;

  [[nodiscard]] bool is_elsewhere(const FrameView& view) const {
    return glm::dot(forward_, view.axes.forward) < kCosineOfTurn || glm::distance(eye_, view.eye) > kMove * view.depth;
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
    /// Whether such a share of all is hidden, or as much less as frames take less than this work.
    [[nodiscard]] bool hide(double share, double of_work) const {
      return hidden >= share * std::min(1.0, work / frames / of_work) * all;
    }
    [[nodiscard]] bool pay() const { return hide(kLeastShare, kWorkOfShare); }
  };

  void learn_of_look(const Sums& look) {
    is_hopeful_ = sums_.pay();
    interval_ = is_hopeful_ ? kInterval : std::min(2 * interval_, kMostInterval);
    if (!is_first_ || look.pay()) return;
    is_hopeful_ = false;
    since_look_ = interval_;  // the next frame tries
  }
  void learn_of_try(const Sums& found) {
    is_hopeful_ = found.hide(kShareOfTry, kWorkOfTry);
    if (is_hopeful_) {
      since_look_ = interval_;  // the next frame looks
    } else {
      sums_ = found;
      interval_ = std::min(2 * interval_, kMostInterval);
    }
  }

  Frame frame_ = Frame::looks;
  std::size_t interval_ = kInterval, since_look_ = kInterval;  ///< the first frame looks
  glm::dvec3 eye_{}, forward_{};                               ///< of the frame that looked, or tried
  std::size_t work_of_look_ = 0;                               ///< of the last one
  bool is_first_ = true, is_cheap_ = false;
  bool is_hopeful_ = true;  ///< the next look is not tried before
  Sums sums_;
};

}  // namespace occlude::culler
