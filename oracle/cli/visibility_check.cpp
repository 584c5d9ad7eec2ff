// SPDX-License-Identifier: MIT
#include "visibility_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <span>
#include <utility>

#include "differential/exact_visibility.h"
#include "occlude/culler/parallel.h"
#include "occlude/render/progress.h"

namespace occlude::cli {
namespace {

constexpr std::size_t kReferenceFrames = 48, kNamed = 64;

/// Counts a frame whose polygons show in so many pixels.
void add(Visibility& result, const culler::Hierarchy& hierarchy, std::size_t frame, const std::vector<CulledRun>& culled,
         const std::vector<Fate>& fates, const std::vector<std::uint32_t>& pixels, const std::string& where) {
  FrameVisibility& counts = result.frames.emplace_back();
  counts.frame = frame;
  for (std::uint32_t p = 0; p < fates.size(); ++p) {
    counts.drawn += fates[p] == Fate::drawn;
    if (pixels[p] == 0) continue;
    ++counts.visible;
    if (fates[p] == Fate::drawn) continue;
    counts.wrong_pixels += pixels[p];
    if (counts.false_culls++ < kNamed) {
      result.false_culls.push_back({frame, p, witness_of(hierarchy, culled, p), where});
    }
  }
}

std::vector<bool> shown(const std::vector<std::uint32_t>& pixels) {
  std::vector<bool> result;
  for (const std::uint32_t count : pixels) result.push_back(count != 0);
  return result;
}

/// How many polygons pass view-frustum culling alone.
std::size_t in_view(const culler::Culler& culler, const culler::Camera& camera) {
  return culler.cull(camera, {.occluders = 0}).stats.drawn_polygons;
}

std::vector<culler::PolygonRange> not_out_of_view(const std::vector<Fate>& fates) {
  std::vector<culler::PolygonRange> ranges;
  for (std::uint32_t p = 0; p < fates.size(); ++p) {
    if (fates[p] == Fate::out_of_view) continue;
    if (!ranges.empty() && ranges.back().first + ranges.back().count == p) {
      ++ranges.back().count;
    } else {
      ranges.push_back({p, 1});
    }
  }
  return ranges;
}

/// Of each polygon 1 where a triangle of its fan shows.
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

bool is_reference(std::size_t i, std::size_t frames) { return i % std::max<std::size_t>(1, frames / kReferenceFrames) == 0; }

Visibility check_exactly(const culler::Culler& culler, const render::CameraPath& path, double aspect,
                         const CulledSets& culled) {
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  std::vector<std::pair<std::size_t, const std::vector<CulledRun>*>> frames;
  for (const auto& [frame, runs] : culled) frames.emplace_back(frame, &runs);
  std::vector<std::vector<std::uint32_t>> shows(frames.size());
  render::Progress progress("exact visibility, frame", frames.size());
  std::mutex mutex;
  std::size_t done = 0;
  culler::parallel_for(frames.size(), [&](std::size_t i) {
    render::check_interrupt();
    shows[i] = polygons_with(hierarchy, fuzz::visible_triangles(hierarchy.soup(), path.camera(frames[i].first, aspect)));
    const std::lock_guard lock(mutex);
    progress.update(++done);
  });
  Visibility result;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto& [frame, runs] = frames[i];
    add(result, hierarchy, frame, *runs, fates_of(hierarchy, *runs), shows[i], "in exact arithmetic");
    if (is_reference(i, frames.size())) result.frames.back().shows = shown(shows[i]);
    result.frames.back().in_view = in_view(culler, path.camera(frame, aspect));
    result.frames.back().wrong_pixels = 0;  // there are none
  }
  return result;
}

Visibility check_rendered(const culler::Culler& culler, const render::CameraPath& path, double aspect,
                          const CulledSets& culled, ItemBuffers& buffers) {
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  Visibility result;
  render::Progress progress("item buffer, frame", culled.size());
  std::size_t turn = 0;
  for (const auto& [frame, runs] : culled) {
    render::check_interrupt();
    const bool reference = is_reference(turn, culled.size());
    const std::vector<Fate> fates = fates_of(hierarchy, runs);
    const culler::PolygonRange all{0, static_cast<std::uint32_t>(fates.size())};
    const std::vector<culler::PolygonRange> ranges = reference ? std::vector{all} : not_out_of_view(fates);
    const culler::Camera camera = path.camera(frame, aspect);
    const render::ItemBuffer items = buffers.draw(turn, camera, ranges);
    std::vector<std::uint32_t> pixels(fates.size());
    for (const std::uint32_t p : items.pixels) {
      if (p != render::kNothing) ++pixels[p];
    }
    add(result, hierarchy, frame, runs, fates, pixels, "in " + buffers.describe(turn));
    result.frames.back().in_view = in_view(culler, camera);
    if (reference) result.frames.back().shows = shown(pixels);
    progress.update(++turn);
  }
  return result;
}

}  // namespace occlude::cli
