// SPDX-License-Identifier: MIT
#include "witness_text.h"

#include <algorithm>

namespace occlude::render::text {
namespace {

std::string layer_members(const culler::Hierarchy& hierarchy, const culler::CoverLayer& layer);

std::string sheet_members(const culler::Hierarchy& hierarchy, const culler::CoverWindow& window) {
  const std::string polygons = R"("polygons":)" + names(hierarchy, window.polygons);
  return window.triangles.empty() ? polygons : polygons + R"(,"triangles":)" + triangles(hierarchy, window.triangles);
}

std::string layer_members(const culler::Hierarchy& hierarchy, const culler::CoverLayer& layer) {
  const auto& [point, normal, right] = layer.focus;
  const auto window = [&](const culler::CoverWindow& w) {
    return fmt::format(R"({{"rect":[{},{},{},{}],{}}})", w.x0, w.y0, w.x1, w.y1,
                       w.windows.empty() ? sheet_members(hierarchy, w) : layer_members(hierarchy, w));
  };
  return fmt::format(R"("focus":{{"point":{},"normal":{},"right":{}}},"windows":{})", triple(point), triple(normal),
                     triple(right), list(layer.windows, window));
}

}  // namespace

std::string box(const kernel::Aabb& box) {
  return fmt::format(R"({{"min":{},"max":{}}})", triple(box.min), triple(box.max));
}

std::string box(const kernel::Obb& box) {
  const auto& [x, y, z] = box.half_edges;
  return fmt::format(R"({{"center":{},"half_edges":[{},{},{}]}})", triple(box.center), triple(x), triple(y), triple(z));
}

std::string name(const culler::Hierarchy& hierarchy, std::uint32_t p) {
  const std::uint32_t face = hierarchy.face(p);
  const auto pieces = std::ranges::equal_range(hierarchy.faces(), face);
  if (pieces.size() < 2) return std::to_string(face);
  const auto first = static_cast<std::uint32_t>(pieces.begin() - hierarchy.faces().begin());
  return fmt::format("[{},{}]", face, hierarchy.original(p) - first);
}

std::string names(const culler::Hierarchy& hierarchy, std::span<const std::uint32_t> polygons) {
  return list(polygons, [&](std::uint32_t p) { return name(hierarchy, p); });
}

std::string triangles(const culler::Hierarchy& hierarchy, std::span<const culler::FanTriangle> triangles) {
  return list(triangles, [&](const culler::FanTriangle& triangle) {
    return fmt::format("[{},{}]", name(hierarchy, triangle.polygon), triangle.corner);
  });
}

std::string sight_member(const kernel::Viewpoint& viewpoint, const culler::EyeRegion& eyes) {
  if (!viewpoint.is_eye()) return fmt::format(R"("direction":{})", triple(viewpoint.value));
  if (eyes.is_point()) return fmt::format(R"("eye":{})", triple(viewpoint.value));
  const std::string shape = eyes.radius != 0 ? fmt::format(R"("radius":{})", eyes.radius)
                                             : R"("half_edges":)" + list(eyes.half_edges, triple<glm::dvec3>);
  return fmt::format(R"("eyes":{{"center":{},{}}})", triple(viewpoint.value), shape);
}

std::string cover_members(const culler::Hierarchy& hierarchy, const culler::CoverWitness& cover) {
  return cover.windows.empty() ? R"("polygons":)" + names(hierarchy, cover.polygons) : layer_members(hierarchy, cover);
}

}  // namespace occlude::render::text
