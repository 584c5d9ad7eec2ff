// SPDX-License-Identifier: MIT
#include "page_frames.h"

#include <algorithm>
#include <set>

#include "frame/culler_access.h"

namespace occlude::render {
namespace {

constexpr std::size_t kDrawn = 0, kOutOfView = 1, kCovered = 2, kFirstColour = 3;

constexpr std::uint32_t kAlone = culler::Culled::kNone;

}  // namespace

void PageFrames::add(const culler::CullResult& frame) {
  count(frame);
  choose_colours(frame);
  if (seen_++ % every_ != 0) return;
  frames_.push_back(packed(frame));
  bytes_ += frames_.back().text().size();
  while (bytes_ > most_bytes_ && frames_.size() > 1) {
    bytes_ = 0;
    std::vector<Bytes> kept;
    for (std::size_t i = 0; i < frames_.size(); i += 2) {
      bytes_ += frames_[i].text().size();
      kept.push_back(std::move(frames_[i]));
    }
    frames_ = std::move(kept);
    every_ *= 2;
  }
}

std::string PageFrames::packed() const {
  Bytes all;
  for (const Bytes& frame : frames_) all.block(frame);
  return all.text();
}

std::vector<PageFrames::Outline> PageFrames::outlines() const {
  std::vector<Outline> result(outlines_.size());
  for (const auto& [outline, number] : outlines_) result[number] = outline;
  return result;
}

void PageFrames::count(const culler::CullResult& frame) {
  for (const culler::Occluder& occluder : frame.occluders) {
    auto found = occluders_.find(occluder.index);
    if (found == occluders_.end()) {
      const OccluderRecord record{{occluders_of(culler_), occluder.index, model_}};
      found = occluders_.emplace(occluder.index, record).first;
    }
    found->second.did.add(seen_, occluder.hidden);
  }
}

PageFrames::Hider PageFrames::hider_of(const culler::CullResult& frame, const culler::Culled& culled) const {
  return {frame.occluders[culled.index].index,
          culled.second == culler::Culled::kNone ? kAlone : frame.occluders[culled.second].index};
}

void PageFrames::choose_colours(const culler::CullResult& frame) {
  std::set<Hider> hiders;
  for (const culler::Culled& culled : frame.culled) {
    if (culled.by == culler::Culled::By::shadow) hiders.insert(hider_of(frame, culled));
  }
  std::erase_if(colours_, [&](const auto& entry) { return !hiders.contains(entry.first); });
  std::set<std::size_t> used;
  for (const auto& [hider, colour] : colours_) used.insert(colour);
  std::size_t next = 0;
  for (const Hider& hider : hiders) {
    if (colours_.contains(hider)) continue;
    while (used.contains(next)) ++next;
    colours_[hider] = next++;
  }
}

Bytes PageFrames::packed(const culler::CullResult& frame) {
  Bytes bytes;
  pack_occluders(frame, bytes);
  pack_hiders(frame, bytes);
  pack_fates(frame, bytes);
  return bytes;
}

void PageFrames::pack_occluders(const culler::CullResult& frame, Bytes& bytes) {
  bytes.number(frame.occluders.size());
  for (const culler::Occluder& occluder : frame.occluders) {
    Outline outline{occluder.index, {}};
    for (const kernel::Vec3& corner : occluder.frustum.silhouette()) {
      outline.corners.push_back(model_.grid().at({corner.x, corner.y, corner.z}));
    }
    bytes.number(outlines_.try_emplace(std::move(outline), outlines_.size()).first->second);
    bytes.number(occluder.hidden);
  }
}

void PageFrames::pack_hiders(const culler::CullResult& frame, Bytes& bytes) const {
  const auto place_of = [&](std::uint32_t occluder) {
    return static_cast<std::size_t>(std::ranges::find(frame.occluders, occluder, &culler::Occluder::index) -
                                    frame.occluders.begin());
  };
  bytes.number(colours_.size());
  for (const auto& [hider, colour] : colours_) {
    bytes.number(colour);
    bytes.number(place_of(hider.first));
    bytes.number(hider.second == kAlone ? 0 : 1 + place_of(hider.second));
  }
}

void PageFrames::pack_fates(const culler::CullResult& frame, Bytes& bytes) const {
  const auto add = [&](std::size_t fate, std::size_t leaves) {
    if (leaves == 0) return;
    bytes.number(fate);
    bytes.number(leaves);
  };
  std::size_t leaf = 0;
  for (const culler::Culled& culled : frame.culled) {
    const culler::HierarchyNode& node = culler_.hierarchy().nodes()[culled.node];
    const auto [first, count] = model_.leaves_of({node.first, node.count});
    add(kDrawn, first - leaf);
    leaf = first + count;
    switch (culled.by) {
      case culler::Culled::By::view:
        add(kOutOfView, count);
        break;
      case culler::Culled::By::cover:
        add(kCovered, count);
        break;
      case culler::Culled::By::shadow:
        add(kFirstColour + colours_.at(hider_of(frame, culled)), count);
        break;
    }
  }
  add(kDrawn, model_.leaves() - leaf);
}

}  // namespace occlude::render
