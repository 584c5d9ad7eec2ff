// SPDX-License-Identifier: MIT
#include "occlude/render/methods.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "occlude/render/summary.h"
#include "occlude/render/walk_frames.h"

namespace occlude::render {
namespace {

/// A row of the given members of the frames.
MethodRow row(const std::string& method, const WalkResult& walk, bool is_drawn, std::size_t FrameRecord::*drawn,
              double FrameRecord::*cull_ms, double FrameRecord::*frame_ms) {
  MethodRow row;
  row.method = method;
  row.in_view = mean(walk, &FrameRecord::view_frustum_polygons);
  row.drawn = mean(walk, drawn);
  row.culled_share = row.in_view == 0 ? 0 : 1 - row.drawn / row.in_view;
  if (is_drawn) {
    const double hidden = mean_hidden(walk);
    if (hidden > 0) row.hidden_culled = std::min((row.in_view - row.drawn) / hidden, 1.0);  // means round
    row.frame_ms = mean(walk, frame_ms);
    row.frame_ms_view_frustum_only = mean(walk, &FrameRecord::view_frustum_frame_ms);
    row.speedup = *row.frame_ms_view_frustum_only / *row.frame_ms;
  }
  if (cull_ms == nullptr) return row;
  row.cull_ms = mean(walk, cull_ms);
  row.worst_cull_ms = std::ranges::max(walk.frames, {}, cull_ms).*cull_ms;
  return row;
}

MethodRow row_of(const MethodWalk& of, bool is_drawn) {
  const WalkResult& walk = *of.walk;
  MethodRow result = row(method_text(*of.options), walk, is_drawn, &FrameRecord::rendered_polygons, &FrameRecord::cull_ms,
                         &FrameRecord::frame_ms);
  result.by = of.options->cull.method;
  result.cull_processor_ms = mean(walk, &FrameRecord::cull_processor_ms);
  if (!is_drawn) return result;
  result.wrong_pixels = result.false_culls = 0;
  for (const FrameRecord& record : walk.frames) {
    *result.wrong_pixels += record.wrong_pixels - record.snapped_pixels;
    *result.false_culls += record.false_culls;
  }
  return result;
}

struct Names {
  const char *name, *words;
};

Names names_of(culler::Method method) {
  switch (method) {
    case culler::Method::automatic:
      return {"automatic", "automatic"};
    case culler::Method::frusta:
      return {"frusta", "shadow frusta"};
    case culler::Method::cover:
      return {"cover", "joined shadows"};
  }
  return {"", ""};
}

/// Nothing was culled where it takes no time.
std::string ms_of_culling(double ms) { return ms > 0 ? rounded(ms, 2) : "-"; }

}  // namespace

Methods methods_of(const std::vector<MethodWalk>& walks, bool is_drawn) {
  const WalkResult& first = *walks.front().walk;
  Methods methods{row("view frustum alone", first, is_drawn, &FrameRecord::view_frustum_polygons,
                      &FrameRecord::view_frustum_cull_ms, &FrameRecord::view_frustum_frame_ms)};
  for (const MethodWalk& walk : walks) methods.push_back(row_of(walk, is_drawn));
  if (is_drawn) {
    methods.push_back(
        row("visible polygons only", first, true, &FrameRecord::visible_polygons, nullptr, &FrameRecord::visible_frame_ms));
  }
  return methods;
}

std::vector<WalkOptions> options_beside(const WalkOptions& options) {
  std::vector<WalkOptions> others;
  WalkOptions alone = options;
  alone.witness.reset();
  alone.log.reset();
  alone.on_shadow_test = nullptr;
  alone.plates = false;
  if (options.hold > 0) {
    others.emplace_back(alone).hold = 0;
    return others;
  }
  const bool is_best = options.build.hierarchy.leaf_size == culler::leaf_size_for(options.cull.method);
  for (const culler::Method method : kMethods) {
    if (method == options.cull.method) continue;
    WalkOptions& other = others.emplace_back(alone);
    other.cull.method = method;
    if (is_best) other.build.hierarchy.leaf_size = culler::leaf_size_for(method);
  }
  return others;
}

WalkResult walk_beside(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options) {
  const Drawing drawing(culler, options);
  return walk_frames(culler, path, options, drawing);
}

const char* name_of(culler::Method method) { return names_of(method).name; }
const char* text_of(culler::Method method) { return names_of(method).words; }

std::string method_text(const WalkOptions& options) {
  return std::string(text_of(options.cull.method)) + (options.hold > 0 ? ", held" : "");
}

Table table_of(const Methods& methods) {
  Table table{"",
              {{"Averages per frame", "method"},
               {"in view", "in_view"},
               {"drawn", "drawn"},
               {"culled", "culled_share", percent},
               {"of the hidden", "hidden_culled", percent},
               {"cull, ms", "cull_ms", ms_of_culling},
               {"of processor", "cull_processor_ms", rounded<2>},
               {"", "worst_cull_ms"},
               {"frame, ms", "frame_ms", rounded<1>},
               {"without, ms", "frame_ms_view_frustum_only", rounded<1>},
               {"speedup", "speedup", rounded<2>},
               {"wrong pixels", "wrong_pixels"},
               {"false culls", "false_culls"}},
              {}};
  for (const MethodRow& m : methods) {
    table.rows.push_back({m.method, m.in_view, m.drawn, m.culled_share, if_known(m.hidden_culled), m.cull_ms,
                          if_known(m.cull_processor_ms), m.worst_cull_ms, if_known(m.frame_ms),
                          if_known(m.frame_ms_view_frustum_only), if_known(m.speedup), if_known(m.wrong_pixels),
                          if_known(m.false_culls)});
  }
  return table;
}

}  // namespace occlude::render
