// SPDX-License-Identifier: MIT
#include "packed_visibility.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "occlude/render/packing.h"

namespace occlude::cli {
namespace {

/// The counts of a frame in their order here, by f(count), and what shows in it, by f(bits).
template <class Frame, class Each>
void for_each_member(Frame& frame, Each&& f) {
  for (auto* count : {&frame.frame, &frame.in_view, &frame.drawn, &frame.visible, &frame.false_culls, &frame.hidden,
                      &frame.hidden_culled, &frame.wrong_pixels}) {
    f(*count);
  }
  f(frame.shows);
}

void get(render::Unpacker& unpacker, std::size_t& count) { count = unpacker.get<std::size_t>(); }
void get(render::Unpacker& unpacker, std::vector<bool>& bits) { bits = unpacker.bits(); }

FalseCull get_false_cull(render::Unpacker& unpacker) {
  FalseCull found;
  found.frame = unpacker.get<std::size_t>();
  found.polygon = unpacker.get<std::uint32_t>();
  found.witness = unpacker.get<std::size_t>();
  found.where = unpacker.text();
  return found;
}

}  // namespace

std::string pack(const CulledSets& culled) {
  render::Packer packer;
  for (const auto& [frame, runs] : culled) packer.put(frame).put(runs);
  return packer.bytes();
}

CulledSets unpack_culled(const std::string& bytes) {
  CulledSets culled;
  for (render::Unpacker unpacker(bytes); !unpacker.is_empty();) {
    const auto frame = unpacker.get<std::size_t>();
    culled[frame] = unpacker.list<CulledRun>();
  }
  return culled;
}

std::string pack(const Visibility& visibility) {
  render::Packer packer;
  packer.put(std::uint64_t{visibility.frames.size()});
  for (const FrameVisibility& frame : visibility.frames) {
    for_each_member(frame, [&](const auto& member) { packer.put(member); });
  }
  for (const FalseCull& found : visibility.false_culls) {
    packer.put(found.frame).put(found.polygon).put(found.witness).put(found.where);
  }
  return packer.bytes();
}

Visibility unpack_visibility(const std::string& bytes) {
  render::Unpacker unpacker(bytes);
  Visibility visibility;
  visibility.frames.resize(unpacker.get<std::uint64_t>());
  for (FrameVisibility& frame : visibility.frames) {
    for_each_member(frame, [&](auto& member) { get(unpacker, member); });
  }
  while (!unpacker.is_empty()) visibility.false_culls.push_back(get_false_cull(unpacker));
  return visibility;
}

void append(Visibility& whole, Visibility&& part) {
  std::ranges::move(part.frames, std::back_inserter(whole.frames));
  std::ranges::move(part.false_culls, std::back_inserter(whole.false_culls));
}

}  // namespace occlude::cli
