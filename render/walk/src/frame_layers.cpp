// SPDX-License-Identifier: MIT
#include "occlude/render/frame_layers.h"

#include <fmt/format.h>

#include <algorithm>

#include "frame/culler_access.h"
#include "model/append_range.h"

namespace occlude::render {
namespace {

std::vector<PolygonRange> culled_ranges(const culler::Culler& culler, const culler::CullResult& result, bool is_by_view) {
  std::vector<PolygonRange> ranges;
  for (const culler::Culled& culled : result.culled) {
    const auto& node = culler.hierarchy().nodes()[culled.node];
    if ((culled.by == culler::Culled::By::view) == is_by_view) ranges.push_back({node.first, node.count});
  }
  return ranges;
}

std::vector<PolygonRange> occluder_ranges(const culler::Culler& culler, const culler::CullResult& result) {
  std::vector<PolygonRange> ranges;
  for (const culler::Occluder& occluder : result.occluders) {
    for (const std::uint32_t polygon : occluders_of(culler).parts(occluder.index)) ranges.push_back({polygon, 1});
  }
  std::ranges::sort(ranges, {}, &PolygonRange::first);
  return ranges;
}

}  // namespace

std::size_t count(const std::vector<PolygonRange>& ranges) {
  std::size_t sum = 0;
  for (const PolygonRange& range : ranges) sum += range.count;
  return sum;
}

std::vector<PlateLayer> FrameLayers::all() const {
  return {{occluders, Style::occluder},
          {seen, Style::drawn},
          {missed, Style::missed},
          {culled, Style::culled},
          {out_of_view, Style::out_of_view}};
}

std::vector<LegendEntry> FrameLayers::legend() const {
  std::vector<LegendEntry> entries;
  const auto add = [&](Style style, const std::vector<PolygonRange>& ranges, const char* what) {
    if (!ranges.empty()) entries.push_back({style, fmt::format("{} {}", count(ranges), what)});
  };
  add(Style::drawn, seen, "drawn and seen");
  add(Style::missed, missed, "drawn, but hidden");
  add(Style::culled, culled, "culled, hidden");
  add(Style::out_of_view, out_of_view, "culled, out of view");
  add(Style::occluder, occluders, "of them in occluders");
  return entries;
}

FrameLayers layers_of(const culler::Culler& culler, const culler::Camera& camera, const culler::CullResult& result,
                      PlateRenderer& renderer) {
  FrameLayers layers{
      occluder_ranges(culler, result), {}, {}, culled_ranges(culler, result, false), culled_ranges(culler, result, true)};
  const std::vector<bool> is_seen = renderer.seen(camera, result.drawn);
  for (const PolygonRange& range : result.drawn) {
    for (std::uint32_t p = range.first; p < range.first + range.count; ++p) {
      culler::append_range(is_seen[p] ? layers.seen : layers.missed, {p, 1});
    }
  }
  return layers;
}

}  // namespace occlude::render
