// SPDX-License-Identifier: MIT
#include "methods.h"

#include <algorithm>

#include "occlude/culler/culler.h"
#include "occlude/render/summary.h"
#include "occlude/render/walk_frames.h"

namespace occlude::experiments {
namespace {

using render::FrameRecord;
using render::WalkResult;

/// The row of one method, from the given members of the frames.
MethodRow row(const std::string& name, const WalkResult& walk, bool is_drawn, std::size_t FrameRecord::*drawn,
              double FrameRecord::*cull_ms, double FrameRecord::*frame_ms) {
  MethodRow row;
  row.name = name;
  row.drawn = mean(walk, drawn);
  if (is_drawn) {
    const double viewed = mean(walk, &FrameRecord::view_frustum_polygons), hidden = mean_hidden(walk);
    if (hidden > 0) row.hidden_culled = (viewed - row.drawn) / hidden;
    row.frame_ms = mean(walk, frame_ms);
  }
  if (cull_ms == nullptr) return row;
  row.cull_ms = mean(walk, cull_ms);
  row.worst_cull_ms = std::ranges::max(walk.frames, {}, cull_ms).*cull_ms;
  return row;
}

render::WalkResult walk_by_other(const Subject& subject, const Options& options, culler::Method other) {
  render::WalkOptions walk = options.walk;
  std::uint32_t& leaf = walk.build.hierarchy.leaf_size;
  if (leaf == culler::leaf_size_for(walk.cull.method)) leaf = culler::leaf_size_for(other);
  walk.cull.method = other;
  const culler::Culler culler = make_culler(subject.soup, walk);
  const render::Drawing drawing(culler, walk);
  return walk_frames(culler, subject.path, walk, drawing);
}

}  // namespace

Methods measure_methods(const Subject& subject, const Options& options, const render::WalkResult& walked) {
  const bool is_drawn = options.walk.render, is_by_cover = options.walk.cull.method == culler::Method::cover;
  const WalkResult other = walk_by_other(subject, options, is_by_cover ? culler::Method::frusta : culler::Method::cover);
  const auto by = [&](const char* name, const WalkResult& walk) {
    return row(name, walk, is_drawn, &FrameRecord::rendered_polygons, &FrameRecord::cull_ms, &FrameRecord::frame_ms);
  };
  Methods methods{row("view frustum alone", walked, is_drawn, &FrameRecord::view_frustum_polygons,
                      &FrameRecord::view_frustum_cull_ms, &FrameRecord::view_frustum_frame_ms),
                  by("shadow frusta", is_by_cover ? other : walked), by("joined shadows", is_by_cover ? walked : other)};
  if (is_drawn) {
    methods.push_back(
        row("visible polygons only", walked, true, &FrameRecord::visible_polygons, nullptr, &FrameRecord::visible_frame_ms));
  }
  return methods;
}

}  // namespace occlude::experiments
