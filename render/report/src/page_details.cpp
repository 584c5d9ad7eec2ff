// SPDX-License-Identifier: MIT
#include "page_details.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>

#include "frame/culler_access.h"
#include "occlude/render/why.h"

namespace occlude::render {
namespace {

/// Of a shadow: 0 for its near side, 1 + i for the side through corners i and i + 1 of its silhouette.
std::size_t plane_of(const kernel::ShadowFrustum& shadow, std::size_t plane) {
  return plane < shadow.near_count() ? 0 : 1 + plane - shadow.near_count();
}

}  // namespace

void PageDetails::add(const ShownFrame& frame, double ms) {
  const std::size_t number = seen_++;
  note_time(number, ms);
  if (!is_kept(number)) return;
  frames_.emplace(number, packed(frame));
  forget();
}

bool PageDetails::is_kept(std::size_t frame) const {
  return frame % every_ == 0 ||
         std::ranges::find(slowest_, frame, &std::pair<double, std::size_t>::second) != slowest_.end();
}

/// Of equally slow frames the first count.
void PageDetails::note_time(std::size_t frame, double ms) {
  const auto place = std::ranges::find_if(slowest_, [&](const auto& slow) { return slow.first < ms; });
  slowest_.insert(place, {ms, frame});
  if (slowest_.size() > kSlowest) slowest_.pop_back();
}

void PageDetails::forget() {
  const auto bytes = [&] {
    return std::accumulate(frames_.begin(), frames_.end(), std::size_t{0},
                           [](std::size_t sum, const auto& entry) { return sum + entry.second.text().size(); });
  };
  const auto forget_others = [&] { std::erase_if(frames_, [&](const auto& entry) { return !is_kept(entry.first); }); };
  forget_others();
  for (; bytes() > most_bytes_ && every_ < seen_; forget_others()) every_ *= 2;
}

std::string PageDetails::packed() const {
  Bytes all;
  std::size_t before = 0;
  for (const auto& [frame, bytes] : frames_) {
    all.number(frame - before);
    all.block(bytes);
    before = frame;
  }
  return all.text();
}

Bytes PageDetails::packed(const ShownFrame& frame) {
  Bytes bytes;
  pack_distances(frame.culled, bytes);
  if (frame.missed) pack_reasons(*frame.missed, bytes);
  return bytes;
}

void PageDetails::pack_distances(const culler::CullResult& frame, Bytes& bytes) const {
  std::vector<std::pair<std::size_t, double>> planes;
  for (const culler::Culled& culled : frame.culled) {
    if (culled.by == culler::Culled::By::view) planes.emplace_back(culled.index, beyond_view(culler_, frame, culled));
    if (culled.by != culler::Culled::By::shadow) continue;
    for (const auto& [occluder, clearance] : against_shadows(culler_, frame, culled)) {
      planes.emplace_back(plane_of(frame.occluders[occluder].frustum, clearance.plane), clearance.distance);
    }
  }
  bytes.number(planes.size());
  for (const auto& [plane, distance] : planes) bytes.number(plane);
  bytes.planes(planes.size(), sizeof(float),
               [&](std::size_t i) { return std::bit_cast<std::uint32_t>(static_cast<float>(planes[i].second)); });
}

void PageDetails::pack_reasons(const culler::MissedReasons::Answers& missed, Bytes& bytes) {
  struct Run {
    std::uint32_t first, end;  // places
    std::optional<culler::MissedReasons::Answer> answer;
  };
  std::vector<Run> runs;
  for (const auto& [polygon, answer] : missed) {
    const std::uint32_t place = model_.place(polygon);
    if (place != PageModel::kNone) runs.push_back({place, place + 1, answer});
  }
  std::ranges::sort(runs, {}, &Run::first);
  std::uint32_t at = 0;
  for (auto run = runs.begin(); run != runs.end();) {
    Run joined = *run;
    for (++run; run != runs.end() && run->first == joined.end && run->answer == joined.answer; ++run) joined.end = run->end;
    bytes.number(joined.first - at);
    bytes.number(joined.end - joined.first);
    bytes.number(joined.answer ? static_cast<std::size_t>(joined.answer->reason) : culler::kMissedReasons);
    const bool is_alone = joined.answer && joined.answer->occluder != culler::Culled::kNone;
    bytes.number(is_alone ? 1 + number_of(joined.answer->occluder) : 0);
    at = joined.end;
  }
}

std::size_t PageDetails::number_of(std::uint32_t occluder) {
  const auto [found, is_new] = numbers_.try_emplace(occluder, occluders_.size());
  if (is_new) occluders_.emplace_back(occluders_of(culler_), occluder, model_);
  return found->second;
}

}  // namespace occlude::render
