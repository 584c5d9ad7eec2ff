// SPDX-License-Identifier: MIT
// The frames of a walk as its page holds them: what became of each leaf, and who hid it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bytes.h"
#include "hider_record.h"
#include "occlude/culler/culler.h"
#include "page_model.h"
#include "page_occluder.h"

namespace occlude::render {

/// An occluder, and what it did on the whole walk.
struct OccluderRecord {
  PageOccluder occluder;
  HiderRecord did = {};
};

class PageFrames {
 public:
  /// Once the frames take so many bytes before compression, only every second one is kept, then every fourth, ...
  static constexpr std::size_t kMostBytes = std::size_t{24} << 20;

  /// `culler` must stay until the last frame is added, `model` as long as this object.
  PageFrames(const culler::Culler& culler, const PageModel& model, std::size_t most_bytes = kMostBytes)
      : culler_(culler), model_(model), most_bytes_(most_bytes) {}

  void add(const culler::CullResult& frame);

  /// The number of frames from each one kept to the next.
  [[nodiscard]] std::size_t every() const { return every_; }
  /// All frames kept, one after another, each after its number of bytes. A frame is
  /// 1. its occluders: their number, and for each one the number of its outline and how many polygons it hid;
  /// 2. its hiders, each one occluder or a pair: their number, and for each one its colour, the occluder, and 1 + the other
  ///    occluder or 0, both by their place in this frame;
  /// 3. its leaves in their order, as culled subtrees and what is drawn between them: for each its fate and its number of
  ///    leaves. The fate is drawn (0), out of view (1), hidden by a cover (2) or by the hider of colour fate - 3.
  [[nodiscard]] std::string packed() const;

  /// By their index in the OccluderSet.
  [[nodiscard]] const std::map<std::uint32_t, OccluderRecord>& occluders() const { return occluders_; }
  struct Outline {
    std::uint32_t occluder = 0;  ///< index in the OccluderSet
    std::vector<GridPoint> corners;
    friend bool operator<(const Outline& a, const Outline& b) {
      return std::tie(a.occluder, a.corners) < std::tie(b.occluder, b.corners);
    }
  };
  /// The silhouettes of occluders, on the grid of the page, by their numbers.
  [[nodiscard]] std::vector<Outline> outlines() const;

 private:
  /// One or two occluders of the OccluderSet.
  using Hider = std::pair<std::uint32_t, std::uint32_t>;

  void count(const culler::CullResult& frame);
  void choose_colours(const culler::CullResult& frame);
  Hider hider_of(const culler::CullResult& frame, const culler::Culled& culled) const;
  Bytes packed(const culler::CullResult& frame);
  void pack_occluders(const culler::CullResult& frame, Bytes& bytes);
  void pack_hiders(const culler::CullResult& frame, Bytes& bytes) const;
  void pack_fates(const culler::CullResult& frame, Bytes& bytes) const;

  const culler::Culler& culler_;
  const PageModel& model_;
  std::size_t most_bytes_, bytes_ = 0, seen_ = 0, every_ = 1;
  std::vector<Bytes> frames_;
  std::map<std::uint32_t, OccluderRecord> occluders_;
  std::map<Outline, std::size_t> outlines_;
  /// A hider keeps its colour while it hides something in frame after frame.
  std::map<Hider, std::size_t> colours_;
};

}  // namespace occlude::render
