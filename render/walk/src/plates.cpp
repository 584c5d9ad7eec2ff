// SPDX-License-Identifier: MIT
#include "occlude/render/plates.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "occlude/render/scene_renderer.h"
#include "occlude/render/view_along_path.h"

namespace occlude::render {
namespace {

constexpr int kWidth = 1280, kHeight = 720;
constexpr std::size_t kMoments = 4;

constexpr Rgba kShadowCulled{214, 60, 48, 190};
constexpr Rgba kViewCulled{226, 229, 232, 215};
constexpr Rgba kOccluder{255, 196, 0, 235};
constexpr Rgba kMarked{230, 0, 200, 255};
constexpr Rgba kNodeLine{200, 20, 20, 255};
constexpr Rgba kFrustumLine{20, 60, 200, 255};
constexpr Rgba kShadowLine{255, 160, 0, 255};

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
    for (const std::uint32_t polygon : culler.occluders().parts(occluder.index)) ranges.push_back({polygon, 1});
  }
  std::sort(ranges.begin(), ranges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return ranges;
}

/// The depth of the interesting part of a frame: two fifths of the drawn polygons are nearer, most others far and small.
double depth_of_scene(const culler::Culler& culler, const culler::Camera& camera, const std::vector<PolygonRange>& drawn) {
  const culler::PolygonSoup& soup = culler.hierarchy().soup();
  std::vector<double> distances;
  for (const PolygonRange& range : drawn) {
    for (std::uint32_t p = range.first; p < range.first + range.count; ++p) {
      distances.push_back(glm::distance(soup.vertices[soup.loop(p)[0]], camera.eye));
    }
  }
  if (distances.empty()) return 1;
  const auto quantile = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 2 / 5);
  std::nth_element(distances.begin(), quantile, distances.end());
  return std::max(*quantile, 100 * camera.near);
}

/// A camera above and behind `camera` that looks down on its view.
culler::Camera outside_camera(const culler::Camera& camera, double depth) {
  culler::Camera outside = camera;
  const glm::dvec3 up = glm::normalize(camera.up);
  glm::dvec3 ahead = camera.axes().forward;
  ahead -= glm::dot(ahead, up) * up;
  ahead = glm::length(ahead) > 0 ? glm::normalize(ahead) : camera.axes().up;
  outside.projection = culler::Projection::perspective;
  outside.fov_y_deg = 50;
  outside.aspect = static_cast<double>(kWidth) / kHeight;
  outside.near = depth / 1000;
  outside.far = std::numeric_limits<double>::infinity();
  outside.eye = camera.eye - 0.55 * depth * ahead + 0.95 * depth * up;
  outside.target = camera.eye + 0.42 * depth * ahead;
  return outside;
}

/// The frame with the most visible polygons in each of up to kMoments equal parts of the walk.
std::vector<std::size_t> moments(const std::vector<FrameRecord>& frames) {
  const std::size_t parts = std::min(kMoments, frames.size());
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < parts; ++i) {
    const auto at = [&](std::size_t k) { return frames.begin() + static_cast<std::ptrdiff_t>(k * frames.size() / parts); };
    const auto richest = std::max_element(at(i), at(i + 1), [](const FrameRecord& a, const FrameRecord& b) {
      return a.visible_polygons < b.visible_polygons;
    });
    chosen.push_back(richest->frame);
  }
  return chosen;
}

/// The edges of the view frustum out to `depth`.
void add_frustum(std::vector<Line>& lines, const culler::Camera& camera, double depth) {
  const auto [right, up, forward] = camera.axes();
  const bool perspective = camera.projection == culler::Projection::perspective;
  const double half = perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) * depth : camera.height / 2;
  std::array<glm::dvec3, 4> base, corner;
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = i == 0 || i == 3 ? -1 : 1, y = i < 2 ? -1 : 1;
    const glm::dvec3 offset = half * (x * camera.aspect * right + y * up);
    base[i] = perspective ? camera.eye : camera.eye + offset;
    corner[i] = camera.eye + depth * forward + offset;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    lines.push_back({base[i], corner[i], kFrustumLine});
    lines.push_back({corner[i], corner[(i + 1) % 4], kFrustumLine});
  }
}

/// The side edges of a shadow frustum, from the occluder's corners to `depth` beyond.
void add_shadow(std::vector<Line>& lines, const culler::Occluder& occluder, const culler::Camera& camera, double depth) {
  for (const kernel::Vec3& c : occluder.frustum.silhouette()) {
    const glm::dvec3 corner{c.x, c.y, c.z};
    const glm::dvec3 along =
        camera.projection == culler::Projection::perspective ? glm::normalize(corner - camera.eye) : camera.axes().forward;
    lines.push_back({corner, corner + depth * along, kShadowLine});
  }
}

/// Draws a frame from outside, with `marked` polygons and lines.
void draw_outside(SceneRenderer& renderer, const culler::Culler& culler, const culler::Camera& camera,
                  const culler::CullResult& result, double depth, std::span<const PolygonRange> marked,
                  std::span<const Line> lines) {
  const auto occluders = occluder_ranges(culler, result);
  const auto shadowed = culled_ranges(culler, result, false);
  const auto out_of_view = culled_ranges(culler, result, true);
  // Marked polygons and occluders come first: other layers contain them too, and of equal surfaces the first one stays.
  const std::array<Layer, 5> layers{Layer{marked, kMarked}, Layer{occluders, kOccluder}, Layer{result.drawn, std::nullopt},
                                    Layer{shadowed, kShadowCulled}, Layer{out_of_view, kViewCulled}};
  renderer.draw(outside_camera(camera, depth), layers, lines);
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

std::vector<DrawnPlate> draw_plates(const culler::Culler& culler, const CameraPath& path,
                                    const std::vector<FrameRecord>& frames, const WalkOptions& options) {
  SceneRenderer renderer(culler.hierarchy().soup(), kWidth, kHeight);
  WalkOptions walk = options;
  walk.width = kWidth;
  walk.height = kHeight;
  ViewAlongPath along(culler, path, walk, walk.cull);
  std::vector<DrawnPlate> plates;
  for (const std::size_t frame : moments(frames)) {
    const culler::Camera camera = path.camera(frame, aspect(walk));
    const culler::CullResult& result = culler.cull(camera, walk.cull, along.before(frame));
    const std::string name = fmt::format("frame_{:06}", frame);

    const Layer drawn{result.drawn, std::nullopt};
    renderer.draw(camera, std::span(&drawn, 1));
    plates.push_back({{name + "_view.png", fmt::format("Frame {}: the view of the camera.", frame)}, renderer.image()});

    const double depth = depth_of_scene(culler, camera, result.drawn);
    std::vector<Line> lines;
    add_frustum(lines, camera, depth);
    for (const culler::Occluder& occluder : result.occluders) add_shadow(lines, occluder, camera, depth);
    draw_outside(renderer, culler, camera, result, depth, {}, lines);
    const culler::CullStats& stats = result.stats;
    plates.push_back(
        {{name + "_outside.png",
          fmt::format("Frame {} from outside: {} polygons drawn (their own colours), {} culled by shadow (red), {} "
                      "outside the view (pale), {} occluders (yellow), the edges of their shadows (orange) and of "
                      "the view frustum (blue).",
                      frame, stats.drawn_polygons, stats.shadow_culled_polygons, stats.view_culled_polygons,
                      result.occluders.size())},
         renderer.image()});
  }
  return plates;
}

WhyPlates draw_why(const ReplayedFrame& frame, const Account& account) {
  const culler::Culler& culler = frame.culler();
  const culler::CullResult& result = frame.result();
  const culler::PolygonSoup& soup = culler.hierarchy().soup();
  SceneRenderer renderer(soup, frame.options().width, frame.options().height);
  const PolygonRange marked{account.polygon, 1};

  std::vector<kernel::Vec3> loop;
  for (const std::uint32_t i : soup.loop(account.polygon)) {
    loop.push_back({soup.vertices[i].x, soup.vertices[i].y, soup.vertices[i].z});
  }
  std::vector<Line> lines;
  add_loop(lines, loop, kMarked);
  add_box(lines, culler.hierarchy().volume(account.node), kNodeLine);
  const std::size_t told = std::min<std::size_t>(account.shadows.size(), account.cull ? 2 : 1);
  const auto shadows = std::span(account.shadows).first(told);
  for (const AgainstShadow& against : shadows) {
    add_loop(lines, result.occluders[against.occluder].frustum.silhouette(), kShadowLine);
  }
  const std::array<Layer, 2> layers{Layer{std::span(&marked, 1), kMarked}, Layer{result.drawn, std::nullopt}};
  renderer.draw(frame.camera(), layers, lines);
  Image view = renderer.image();

  double depth = depth_of_scene(culler, frame.camera(), result.drawn);
  depth = std::max(depth, glm::distance(glm::dvec3{loop[0].x, loop[0].y, loop[0].z}, frame.camera().eye));
  add_frustum(lines, frame.camera(), depth);
  for (const AgainstShadow& against : shadows) add_shadow(lines, result.occluders[against.occluder], frame.camera(), depth);
  draw_outside(renderer, culler, frame.camera(), result, depth, std::span(&marked, 1), lines);
  return {std::move(view), renderer.image()};
}

}  // namespace occlude::render
