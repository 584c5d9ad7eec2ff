// SPDX-License-Identifier: MIT
#include "packed_visibility.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "culled_sets.h"
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

/// Whether the counts can be those of a frame of so many polygons.
bool is_sound(const FrameVisibility& f, std::size_t polygons) {
  const bool are_of_all = f.in_view <= polygons && f.drawn <= polygons && f.visible <= polygons && f.hidden <= polygons;
  // A sum of two of these is no larger than twice the number of polygons.
  return are_of_all && f.hidden <= f.in_view && f.in_view <= f.hidden + f.visible && f.hidden + f.visible <= polygons &&
         f.hidden_culled <= f.hidden && f.false_culls <= f.visible &&
         f.hidden_culled + f.false_culls <= polygons - f.drawn && f.visible - f.false_culls <= f.drawn &&
         f.wrong_pixels >= f.false_culls && (f.wrong_pixels == 0) == (f.false_culls == 0);
}

FrameVisibility get_frame(render::Unpacker& unpacker, const CheckedWalk& walk, std::size_t asked) {
  FrameVisibility frame;
  for_each_member(frame, [&](auto& member) { get(unpacker, member); });
  const std::size_t polygons = walk.culler.hierarchy().soup().size();
  render::require_part(frame.frame == asked, "a frame is not the one that was asked for");
  render::require_part(is_sound(frame, polygons), "the counts of a frame contradict each other");
  const bool is_reference = walk.turns.is_reference(asked);
  const auto shown = static_cast<std::size_t>(std::ranges::count(frame.shows, true));
  render::require_part(frame.shows.size() == (is_reference ? polygons : 0) && shown == (is_reference ? frame.visible : 0),
                       "what shows in a frame is not as much as it says");
  return frame;
}

/// The false culls that a frame names, in ascending order of their polygons.
std::vector<FalseCull> get_false_culls(render::Unpacker& unpacker, const CheckedWalk& walk, const FrameVisibility& frame,
                                       const std::vector<CulledRun>& culled) {
  const culler::Hierarchy& hierarchy = walk.culler.hierarchy();
  std::vector<FalseCull> found;
  std::uint32_t least = 0;
  for (std::size_t i = 0; i < std::min(frame.false_culls, kNamed); ++i) {
    const auto p = unpacker.get<std::uint32_t>();
    render::require_part(p >= least && p < hierarchy.soup().size(), "a false cull is of no polygon, or named twice");
    const std::size_t witness = witness_of(hierarchy, culled, p);
    render::require_part(witness != 0 && (frame.shows.empty() || frame.shows[p]),
                         "a false cull is of a polygon that is not culled, or does not show");
    found.push_back({frame.frame, p, witness});
    least = p + 1;
  }
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
  auto found = visibility.false_culls.begin();
  for (const FrameVisibility& frame : visibility.frames) {
    for_each_member(frame, [&](const auto& member) { packer.put(member); });
    for (; found != visibility.false_culls.end() && found->frame == frame.frame; ++found) packer.put(found->polygon);
  }
  return packer.bytes();
}

Visibility unpack_visibility(const std::string& bytes, const CheckedWalk& walk, const CulledSets& part) {
  render::Unpacker unpacker(bytes);
  Visibility visibility;
  for (const auto& [asked, culled] : part) {
    const FrameVisibility& frame = visibility.frames.emplace_back(get_frame(unpacker, walk, asked));
    std::ranges::move(get_false_culls(unpacker, walk, frame, culled), std::back_inserter(visibility.false_culls));
  }
  unpacker.finish();
  return visibility;
}

void append(Visibility& whole, Visibility&& part) {
  std::ranges::move(part.frames, std::back_inserter(whole.frames));
  std::ranges::move(part.false_culls, std::back_inserter(whole.false_culls));
}

}  // namespace occlude::cli
