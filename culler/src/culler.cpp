// SPDX-License-Identifier: MIT
#include "occlude/culler/culler.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "bounds.h"
#include "node_tests.h"
#include "occlude/kernel/validity.h"
#include "occluder_choice.h"
#include "view_memory.h"

namespace occlude::culler {
namespace {

const PolygonSoup& checked(const PolygonSoup& soup) {
  if (soup.empty()) throw std::invalid_argument("the soup has no polygon");
  for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
    if (const auto refusal = kernel::check(to_kernel(soup.vertices[v])); refusal != kernel::Refusal::none) {
      throw std::invalid_argument("vertex " + std::to_string(v) + ": " + std::string(kernel::to_string(refusal)));
    }
  }
  return soup;
}

/// No point of the box is farther from the eye than this.
double depth(const kernel::Aabb& box, const glm::dvec3& eye) {
  glm::dvec3 farthest{};
  for (int axis = 0; axis < 3; ++axis) {
    farthest[axis] = std::max(std::fabs(box.min[axis] - eye[axis]), std::fabs(box.max[axis] - eye[axis]));
  }
  return farthest.x + farthest.y + farthest.z;
}

auto volumes_of(const Hierarchy& hierarchy) {
  return [&](std::uint32_t node, auto&& question) { return hierarchy.ask(node, question); };
}

}  // namespace

Culler::Culler(const PolygonSoup& soup, const BuildConfig& config)
    : config_(config),
      hierarchy_(Hierarchy::build(checked(soup), config.hierarchy)),
      occluders_(PotentialOccluders::find(hierarchy_.soup(), config.occluders)),
      grid_(OccluderGrid::build(occluders_, hierarchy_.nodes()[0].box, config.grid)) {}

Culler::Culler(const PolygonSoup& soup, const Preprocess& preprocess)
    : config_(preprocess.config),
      hierarchy_(Hierarchy::restore(checked(soup), preprocess.config.hierarchy, preprocess.layout)),
      occluders_(PotentialOccluders::find(hierarchy_.soup(), preprocess.config.occluders)),
      grid_(OccluderGrid::restore(occluders_, hierarchy_.nodes()[0].box, preprocess.config.grid, preprocess.lists)) {}

CullResult Culler::cull(const Camera& camera, const CullOptions& options) const {
  View view;
  cull(camera, options, view);
  return std::move(view.memory().result);
}

const CullResult& Culler::cull(const Camera& camera, const CullOptions& options, View& view) const {
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument("camera: " + reason);
  View::Memory& memory = view.memory();
  memory.begin_frame();
  append_view_frustum(camera, depth(hierarchy_.nodes()[0].box, camera.eye), memory.result.view);
  choose_occluders({hierarchy_.soup(), occluders_, grid_}, camera, options, memory);
  traverse(
      hierarchy_.nodes(), volumes_of(hierarchy_), [](const Occluder&, const auto&) {}, options, memory);
  memory.history.record(occluders_.size(), memory.result.occluders, memory.probes);
  return memory.result;
}

void Culler::visit_shadow_tests(const CullResult& frame, const CullOptions& options,
                                const std::function<void(const Occluder& occluder, const Box& box)>& visit) const {
  View::Memory memory;
  memory.result.view = frame.view;
  memory.result.occluders = frame.occluders;
  traverse(hierarchy_.nodes(), volumes_of(hierarchy_), visit, options, memory);
}

}  // namespace occlude::culler
