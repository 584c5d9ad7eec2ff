// SPDX-License-Identifier: MIT
#include "occlude/render/hidden_witness.h"

#include <fmt/format.h>

#include <cstddef>

#include "witness_text.h"

namespace occlude::render {
namespace {

/// [first, count] of each run of those that are true.
std::string runs_of(const std::vector<bool>& faces) {
  std::vector<culler::PolygonRange> runs;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    if (!faces[i]) continue;
    const bool is_next = !runs.empty() && runs.back().first + runs.back().count == i;
    is_next ? void(++runs.back().count) : runs.push_back({i, 1});
  }
  return text::list(runs, [](const culler::PolygonRange& run) { return fmt::format("[{},{}]", run.first, run.count); });
}

}  // namespace

std::string claim_from(std::span<const kernel::Aabb> boxes, const std::vector<bool>& faces) {
  return fmt::format(R"({{"claim":{},"from":{}}})", runs_of(faces),
                     text::list(boxes, [](const kernel::Aabb& box) { return text::box(box); }));
}

std::string claim_outside(const kernel::Aabb& box, bool may_touch, const std::vector<bool>& faces) {
  return fmt::format(R"({{"claim":{},"outside":{}{}}})", runs_of(faces), text::box(box),
                     may_touch ? R"(,"touching":true)" : "");
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
