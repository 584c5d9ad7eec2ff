// SPDX-License-Identifier: MIT
#include "occlude/render/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "occlude/render/page.h"
#include "occlude/render/summary.h"
#include "occlude/render/walk_frames.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

/// A row of the given members of the frames.
MethodRow row(const std::string& method, const WalkResult& walk, bool is_drawn, std::size_t FrameRecord::*drawn,
              double FrameRecord::*cull_ms, double FrameRecord::*frame_ms) {
  MethodRow row;
  row.method = method;
  row.drawn = mean(walk, drawn);
  const double viewed = mean(walk, &FrameRecord::view_frustum_polygons);
  row.culled_share = viewed == 0 ? 0 : 1 - row.drawn / viewed;
  if (is_drawn) {
    const double hidden = mean_hidden(walk);
    if (hidden > 0) row.hidden_culled = (viewed - row.drawn) / hidden;
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
  MethodRow result = row(text_of(of.method), walk, is_drawn, &FrameRecord::rendered_polygons, &FrameRecord::cull_ms,
                         &FrameRecord::frame_ms);
  result.by = of.method;
  if (!is_drawn) return result;
  result.wrong_pixels = result.false_culls = 0;
  for (const FrameRecord& record : walk.frames) {
    *result.wrong_pixels += record.wrong_pixels - record.snapped_pixels;
    *result.false_culls += record.false_culls;
  }
  return result;
}

/// Null if it is not known.
template <class Number>
Json if_known(const std::optional<Number>& number) {
  return number ? Json(*number) : Json();
}

/// The cells of a row but the first; `none` stands for what is not known.
std::vector<std::string> cells(const MethodRow& m, const char* none) {
  const auto if_culled = [&](double ms) { return m.worst_cull_ms > 0 ? fmt::format("{:.2f}", ms) : none; };
  const auto if_drawn = [&](const std::optional<double>& ms) { return ms ? fmt::format("{:.1f}", *ms) : none; };
  const auto count = [&](const std::optional<std::size_t>& n) { return n ? grouped(static_cast<double>(*n)) : none; };
  return {grouped(m.drawn),
          percent(m.culled_share),
          m.hidden_culled ? percent(*m.hidden_culled) : none,
          if_culled(m.cull_ms),
          if_drawn(m.frame_ms),
          if_drawn(m.frame_ms_view_frustum_only),
          m.speedup ? fmt::format("{:.2f}", *m.speedup) : none,
          count(m.wrong_pixels),
          count(m.false_culls)};
}

const std::vector<std::string> kHeads{"drawn",       "culled",  "of the hidden", "cull, ms",   "frame, ms",
                                      "without, ms", "speedup", "wrong pixels",  "false culls"};

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

WalkOptions by_other_method(WalkOptions options) {
  culler::Method& method = options.cull.method;
  std::uint32_t& leaf = options.build.hierarchy.leaf_size;
  const bool is_best = leaf == culler::leaf_size_for(method);
  method = method == culler::Method::cover ? culler::Method::frusta : culler::Method::cover;
  if (is_best) leaf = culler::leaf_size_for(method);
  return options;
}

WalkResult walk_beside(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options) {
  const Drawing drawing(culler, options);
  return walk_frames(culler, path, options, drawing);
}

const char* text_of(culler::Method method) { return method == culler::Method::cover ? "joined shadows" : "shadow frusta"; }

std::string text_of(const Methods& methods) {
  constexpr const char* kLine = "{:<22} {:>9} {:>8} {:>13} {:>9} {:>10} {:>12} {:>8} {:>13} {:>12}\n";
  const auto line = [&](const std::string& name, const std::vector<std::string>& c) {
    return fmt::format(kLine, name, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]);
  };
  std::string text = line("Averages per frame", kHeads);
  for (const MethodRow& m : methods) text += line(m.method, cells(m, "-"));
  return text;
}

std::string html_of(const Methods& methods) {
  std::string head = "<th>Averages per frame</th>", rows;
  for (const std::string& cell : kHeads) head += "<th>" + cell + "</th>";
  for (const MethodRow& m : methods) {
    rows += "<tr><td>" + m.method + "</td>";
    for (const std::string& cell : cells(m, "&ndash;")) rows += "<td>" + cell + "</td>";
    rows += "</tr>\n";
  }
  return "<div class=\"wide\"><table><thead><tr>" + head + "</tr></thead><tbody>\n" + rows + "</tbody></table></div>";
}

Json json_of(const Methods& methods) {
  Json json = Json::array();
  for (const MethodRow& m : methods) {
    json.push_back({{"method", m.method},
                    {"drawn", m.drawn},
                    {"culled_share", m.culled_share},
                    {"hidden_culled", if_known(m.hidden_culled)},
                    {"cull_ms", m.cull_ms},
                    {"worst_cull_ms", m.worst_cull_ms},
                    {"frame_ms", if_known(m.frame_ms)},
                    {"frame_ms_view_frustum_only", if_known(m.frame_ms_view_frustum_only)},
                    {"speedup", if_known(m.speedup)},
                    {"wrong_pixels", if_known(m.wrong_pixels)},
                    {"false_culls", if_known(m.false_culls)}});
  }
  return json;
}

}  // namespace occlude::render
