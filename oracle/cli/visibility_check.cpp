// SPDX-License-Identifier: MIT
#include "visibility_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "exact_visibility.h"
#include "occlude/render/progress.h"

namespace occlude::cli {
namespace {

std::vector<bool> shown(const std::vector<std::uint32_t>& pixels) {
  std::vector<bool> result;
  for (const std::uint32_t count : pixels) result.push_back(count != 0);
  return result;
}

/// For each polygon of the tree, whether it passes view-frustum culling alone.
std::vector<bool> in_view(const culler::Culler& culler, const culler::Camera& camera) {
  return culler::polygons_of(culler.cull(camera, {.method = culler::Method::frusta, .occluders = 0}).drawn,
                             culler.hierarchy().soup().size());
}

/// Adds the counts of a frame. `pixels` is the number of pixels in which each polygon shows.
void add(Visibility& result, const CheckedWalk& walk, std::size_t frame, const std::vector<CulledRun>& culled,
         const std::vector<bool>& drawn, const std::vector<std::uint32_t>& pixels) {
  FrameVisibility& counts = result.frames.emplace_back();
  counts.frame = frame;
  const std::vector<bool> viewed = in_view(walk.culler, walk.path.camera(frame, walk.aspect));
  for (std::uint32_t p = 0; p < drawn.size(); ++p) {
    const bool is_drawn = drawn[p], is_hidden = viewed[p] && pixels[p] == 0;
    counts.in_view += viewed[p];
    counts.drawn += is_drawn;
    counts.hidden += is_hidden;
    counts.hidden_culled += is_hidden && !is_drawn;
    if (pixels[p] == 0) continue;
    ++counts.visible;
    if (is_drawn) continue;
    counts.wrong_pixels += pixels[p];
    if (counts.false_culls++ < kNamed) {
      result.false_culls.push_back({frame, p, witness_of(walk.culler.hierarchy(), culled, p)});
    }
  }
  if (walk.turns.is_reference(frame)) counts.shows = shown(pixels);
}

/// For each polygon, 1 if a triangle of its fan shows, else 0.
std::vector<std::uint32_t> polygons_with(const culler::Hierarchy& hierarchy, const std::vector<bool>& triangles) {
  std::vector<std::uint32_t> shows;
  for (std::size_t p = 0; p < hierarchy.soup().size(); ++p) {
    const auto begin = triangles.begin() + static_cast<std::ptrdiff_t>(hierarchy.first_triangle(p));
    const auto end = triangles.begin() + static_cast<std::ptrdiff_t>(hierarchy.first_triangle(p + 1));
    shows.push_back(std::find(begin, end, true) != end ? 1 : 0);
  }
  return shows;
}

}  // namespace

Visibility check_exactly(const CheckedWalk& walk, const CulledSets& culled) {
  const culler::Hierarchy& hierarchy = walk.culler.hierarchy();
  std::vector<std::pair<std::size_t, const std::vector<CulledRun>*>> frames;
  for (const auto& [frame, runs] : culled) frames.emplace_back(frame, &runs);
  std::vector<std::vector<std::uint32_t>> shows(frames.size());
  culler::parallel_for(frames.size(), [&](std::size_t i) {
    render::check_interrupt();
    const culler::Camera camera = walk.path.camera(frames[i].first, walk.aspect);
    shows[i] = polygons_with(hierarchy, proof::visible_triangles(hierarchy.soup(), camera));
  });
  Visibility result;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto& [frame, runs] = frames[i];
    add(result, walk, frame, *runs, drawn_polygons(hierarchy, *runs), shows[i]);
  }
  return result;
}

Visibility check_rendered(const CheckedWalk& walk, const CulledSets& culled, ItemBuffers& buffers) {
  const culler::Hierarchy& hierarchy = walk.culler.hierarchy();
  Visibility result;
  for (const auto& [frame, runs] : culled) {
    render::check_interrupt();
    const std::size_t turn = walk.turns.turn(frame);
    const std::vector<std::uint32_t> pixels =
        buffers.draw(turn, walk.path.camera(frame, walk.aspect)).pixels_of(hierarchy.soup().size());
    add(result, walk, frame, runs, drawn_polygons(hierarchy, runs), pixels);
  }
  return result;
}

}  // namespace occlude::cli
