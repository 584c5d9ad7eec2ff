// SPDX-License-Identifier: MIT
// What a click on a polygon tells of some frames: by how much it was culled, or why it was drawn though it is hidden.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bytes.h"
#include "occlude/culler/culler.h"
#include "occlude/render/walk.h"
#include "page_model.h"
#include "page_occluder.h"

namespace occlude::render {

class PageDetails {
 public:
  /// Once the frames take so many bytes before compression, only every second one is kept, then every fourth, ...
  static constexpr std::size_t kMostBytes = std::size_t{1} << 20;
  /// The slowest frames are kept as well: page/tables.js lists them.
  static constexpr std::size_t kSlowest = 10;

  /// `culler` must stay until the last frame is added, `model` as long as this object.
  PageDetails(const culler::Culler& culler, const PageModel& model, std::size_t most_bytes = kMostBytes)
      : culler_(culler), model_(model), most_bytes_(most_bytes) {}

  /// `ms`: what the frame took.
  void add(const ShownFrame& frame, double ms);

  /// The frames kept, each after its distance from the one before, or of the first from frame 0, and its number of bytes. A
  /// frame is
  /// 1. what culled its subtrees, in their order, one half-space, shadow or pair of shadows each, without those culled by
  ///    cover: the number of planes; for each plane its number (plane_of), then for each one the distance of the subtree's
  ///    box from it, as float, in planes of bytes;
  /// 2. the hidden polygons that it drew, as runs with one answer: for each its distance in places from the end of the run
  ///    before, its length, the reason (kMissedReasons: not asked), and 1 + the number of the occluder that hides it alone
  ///    or 0.
  [[nodiscard]] std::string packed() const;

  /// The occluders that hide something alone, by their numbers.
  [[nodiscard]] const std::vector<PageOccluder>& occluders() const { return occluders_; }

 private:
  [[nodiscard]] bool is_kept(std::size_t frame) const;
  void note_time(std::size_t frame, double ms);
  void forget();
  Bytes packed(const ShownFrame& frame);
  void pack_distances(const culler::CullResult& frame, Bytes& bytes) const;
  void pack_reasons(const culler::MissedReasons::Answers& missed, Bytes& bytes);
  std::size_t number_of(std::uint32_t occluder);

  const culler::Culler& culler_;
  const PageModel& model_;
  std::size_t most_bytes_, seen_ = 0, every_ = 1;
  std::vector<std::pair<double, std::size_t>> slowest_;  ///< milliseconds and frame, the slowest first
  std::map<std::size_t, Bytes> frames_;
  std::vector<PageOccluder> occluders_;
  std::map<std::uint32_t, std::size_t> numbers_;  ///< of occluders_, by their index in the OccluderSet
};

}  // namespace occlude::render
