// SPDX-License-Identifier: MIT
#include "occlude/render/plates.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include "occlude/render/frame_painter.h"
#include "occlude/render/frames_along_path.h"

namespace occlude::render {
namespace {

/// Names of plates: with the number of the frame between.
constexpr std::string_view kPrefix = "frame_", kView = "_view.png", kOutside = "_outside.png";

constexpr Rgba kMarkedLine{200, 0, 170, 255}, kNodeLine{150, 20, 20, 255}, kOccluderLine{255, 160, 0, 255};

/// A frame to show, and what is special about it.
struct Moment {
  const FrameRecord* frame;
  const char* what;
};

/// Moments at which culling does well and at which it does not, each frame once, in their order.
std::vector<Moment> moments(const std::vector<FrameRecord>& frames) {
  const auto culled = [](const FrameRecord& f) { return f.view_frustum_polygons - f.rendered_polygons; };
  const auto missed = [](const FrameRecord& f) { return f.rendered_polygons - f.visible_polygons; };
  const auto share = [&](const FrameRecord& f) {
    return static_cast<double>(culled(f)) / static_cast<double>(std::max<std::size_t>(culled(f) + missed(f), 1));
  };
  std::vector<const FrameRecord*> by_share;
  for (const FrameRecord& frame : frames) by_share.push_back(&frame);
  const auto middle = by_share.begin() + static_cast<std::ptrdiff_t>(by_share.size() / 2);
  std::ranges::nth_element(by_share, middle, {}, [&](const FrameRecord* f) { return share(*f); });
  std::vector<Moment> moments;
  const auto add = [&](const FrameRecord* frame, const char* what) {
    if (std::ranges::find(moments, frame, &Moment::frame) == moments.end()) moments.push_back({frame, what});
  };
  add(&*std::ranges::max_element(frames, {}, culled), "where the most is culled");
  add(&*std::ranges::max_element(frames, {}, missed), "where the most is drawn in vain");
  add(*middle, "where the usual share is culled");
  add(&*std::ranges::max_element(frames, {}, &FrameRecord::visible_polygons), "where the most is seen");
  std::ranges::sort(moments, {}, [](const Moment& m) { return m.frame->frame; });
  return moments;
}

/// A closed loop of lines.
void add_loop(std::vector<Line>& lines, std::span<const kernel::Vec3> loop, const Rgba& colour) {
  const auto point = [&](std::size_t i) { return glm::dvec3{loop[i].x, loop[i].y, loop[i].z}; };
  for (std::size_t i = 0; i < loop.size(); ++i) lines.push_back({point(i), point((i + 1) % loop.size()), colour});
}

std::array<glm::dvec3, 8> corners_of(const culler::Box& box) {
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec3 s{i & 1U ? 1 : -1, i & 2U ? 1 : -1, i & 4U ? 1 : -1};
    if (const auto* aabb = std::get_if<kernel::Aabb>(&box)) {
      corners[i] = {(s.x > 0 ? aabb->max : aabb->min).x, (s.y > 0 ? aabb->max : aabb->min).y,
                    (s.z > 0 ? aabb->max : aabb->min).z};
    } else {
      const auto& [c, h] = std::get<kernel::Obb>(box);
      for (int k = 0; k < 3; ++k) corners[i][k] = c[k] + s.x * h[0][k] + s.y * h[1][k] + s.z * h[2][k];
    }
  }
  return corners;
}

void add_box(std::vector<Line>& lines, const culler::Box& box, const Rgba& colour) {
  const std::array<glm::dvec3, 8> corners = corners_of(box);
  for (std::size_t i = 0; i < 8; ++i) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((i & bit) == 0) lines.push_back({corners[i], corners[i | bit], colour});
    }
  }
}

}  // namespace

bool is_plate(const std::string& name) {
  return name.starts_with(kPrefix) && (name.ends_with(kView) || name.ends_with(kOutside));
}

std::optional<std::size_t> frame_of_outside_plate(const std::string& name) {
  if (!name.starts_with(kPrefix) || !name.ends_with(kOutside)) return std::nullopt;
  std::size_t frame = 0;
  const char* const end = name.data() + name.size() - kOutside.size();
  const auto [next, error] = std::from_chars(name.data() + kPrefix.size(), end, frame);
  return error == std::errc() && next == end ? std::optional(frame) : std::nullopt;
}

std::vector<DrawnPlate> draw_plates(const culler::Culler& culler, const CameraPath& path,
                                    const std::vector<FrameRecord>& frames, const WalkOptions& options) {
  // Large enough to look at, small enough for a report to hold.
  constexpr double kLarger = 2, kWidest = 1280, kHighest = 720;
  const double scale = std::min({kLarger, kWidest / options.width, kHighest / options.height});
  const auto scaled = [&](int pixels) { return std::max(1, static_cast<int>(std::lround(pixels * scale))); };
  FramePainter painter(culler, scaled(options.width), scaled(options.height));
  FramesAlongPath along(culler, path, options);
  std::vector<DrawnPlate> plates;
  for (const auto& [record, what] : moments(frames)) {
    const culler::Camera camera = path.camera(record->frame, aspect(options));
    along.go_to(record->frame);
    along.cull();
    const culler::CullResult& result = along.result();
    const std::string name = fmt::format("{}{:06}", kPrefix, record->frame);
    plates.push_back({{name + std::string(kView), fmt::format("Frame {}, {}: the view of the camera.", record->frame, what)},
                      painter.view(camera, result.drawn)});
    const culler::CullStats& stats = result.stats;
    plates.push_back(
        {{name + std::string(kOutside),
          fmt::format("Frame {}, {}, from outside: {} polygons drawn, {} culled because they are hidden, {} because "
                      "they are out of view. Lines: the edges of the view frustum (blue){}.",
                      record->frame, what, stats.drawn_polygons, stats.shadow_culled_polygons, stats.view_culled_polygons,
                      result.occluders.empty() ? "" : " and of the shadows (orange)")},
         painter.outside(camera, result)});
  }
  return plates;
}

WhyPlates draw_why(const ReplayedFrame& frame, const Account& account) {
  const culler::Culler& culler = frame.culler();
  const culler::CullResult& result = frame.result();
  const culler::SoupView soup = culler.hierarchy().soup();
  const PolygonRange marked{account.polygon, 1};

  std::vector<kernel::Vec3> loop;
  for (const std::uint32_t i : soup.loop(account.polygon)) {
    loop.push_back({soup.vertices[i].x, soup.vertices[i].y, soup.vertices[i].z});
  }
  std::vector<Line> lines;
  add_loop(lines, loop, kMarkedLine);
  add_box(lines, culler.hierarchy().volume(account.node), kNodeLine);
  const std::size_t told = std::min<std::size_t>(account.shadows.size(), account.cull ? 2 : 1);
  for (const AgainstShadow& against : std::span(account.shadows).first(told)) {
    add_loop(lines, result.occluders[against.occluder].frustum.silhouette(), kOccluderLine);
  }
  FramePainter painter(culler, frame.options().width, frame.options().height);
  return {painter.view(frame.camera(), result.drawn, marked, lines), painter.outside(frame.camera(), result, marked, lines)};
}

}  // namespace occlude::render
