// SPDX-License-Identifier: MIT
#include "occlude/render/hidden_witness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "witness_text.h"

namespace occlude::render {
namespace {

/// The claim of each part of the faces, of which `about` says what is claimed.
std::vector<std::string> claims(const std::vector<bool>& faces, const std::string& about) {
  std::vector<culler::PolygonRange> runs;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    if (!faces[i]) continue;
    const bool is_next = !runs.empty() && runs.back().first + runs.back().count == i;
    is_next ? void(++runs.back().count) : runs.push_back({i, 1});
  }
  std::vector<std::string> lines;
  for (std::size_t i = 0; i == 0 || i < runs.size(); i += kMostInLine) {
    const auto part = std::span(runs).subspan(i, std::min(kMostInLine, runs.size() - i));
    const auto name = [](const culler::PolygonRange& run) { return fmt::format("[{},{}]", run.first, run.count); };
    lines.push_back(fmt::format(R"({{"claim":{},{}}})", text::list(part, name), about));
  }
  return lines;
}

}  // namespace

std::vector<std::string> claims_from(std::span<const kernel::Aabb> boxes, const std::vector<bool>& faces) {
  return claims(faces, R"("from":)" + text::list(boxes, [](const kernel::Aabb& box) { return text::box(box); }));
}

std::vector<std::string> claims_outside(const kernel::Aabb& box, bool may_touch, const std::vector<bool>& faces) {
  return claims(faces, R"("outside":)" + text::box(box) + (may_touch ? R"(,"touching":true)" : ""));
}

std::string hidden_witness(const culler::Hierarchy& hierarchy, std::span<const std::uint32_t> polygons,
                           const kernel::Aabb& from, const culler::Camera& camera, const std::array<double, 4>& drawn,
                           const culler::CoverWitness& cover) {
  const auto& [a, b, c, d] = drawn;
  return fmt::format(R"({{"hidden":{},"box":{},"from":{},{},"drawn":[{},{},{},{}],{}}})", text::names(hierarchy, polygons),
                     text::box(cover.box), text::box(from), text::sight_member(camera.viewpoint(), camera.eyes), a, b, c, d,
                     text::cover_members(hierarchy, cover));
}

std::string shell_witness(const culler::Hierarchy& hierarchy, std::span<const culler::FanTriangle> triangles,
                          std::span<const std::uint32_t> shell) {
  return fmt::format(R"({{"hidden":{},"shell":{}}})", text::triangles(hierarchy, triangles), text::names(hierarchy, shell));
}

}  // namespace occlude::render
