// SPDX-License-Identifier: MIT
#include "occlude/culler/culler.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

#include "bounds.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/validity.h"
#include "occluder_choice.h"
#include "traverse.h"

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

/// What is coplanar with an occluder is drawn: the near plane is open.
template <class Box>
kernel::Decision decide(const Occluder& occluder, const Box& box, const CullOptions& options) {
  return kernel::decide(occluder.frustum, box, options.arithmetic, options.test, kernel::NearBoundary::open);
}

}  // namespace

/// The descent of a frame whose half-spaces and occluders are known, the shadow tests done by `shadow_test(occluder, box)`.
template <class ShadowTest>
void Culler::traverse(CullResult& frame, const CullOptions& options, ShadowTest&& shadow_test) const {
  std::vector<kernel::HalfSpace> planes;
  for (const HalfSpace& h : frame.view) planes.push_back({to_kernel(h.normal), h.offset});
  auto test_view = [&](std::uint32_t i, std::uint32_t node) {
    return hierarchy_.ask(node, [&](const auto& box) { return kernel::relation(planes[i], box, options.arithmetic); });
  };
  auto test_shadow = [&](std::uint32_t i, std::uint32_t node) {
    const kernel::Decision decision =
        hierarchy_.ask(node, [&](const auto& box) { return shadow_test(frame.occluders[i], box); });
    if (decision.stage == kernel::Stage::exact) ++frame.stats.exact_shadow_tests;
    return decision.relation;
  };
  Traversal(hierarchy_, test_view, test_shadow, frame).run();
}

CullResult Culler::cull_frame(const Camera& camera, const CullOptions& options, const OccluderHistory& history) const {
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument("camera: " + reason);
  CullResult result;
  result.view = view_frustum(camera, depth(hierarchy_.nodes()[0].box, camera.eye));
  result.occluders =
      choose_occluders(hierarchy_.soup(), occluders_, grid_, history, camera, result.view, options, result.stats);
  traverse(result, options, [&](const Occluder& occluder, const auto& box) { return decide(occluder, box, options); });
  return result;
}

Culler::Culler(const PolygonSoup& soup, const Config& config)
    : hierarchy_(Hierarchy::build(checked(soup), config.hierarchy)),
      occluders_(ConvexRegions::find(hierarchy_.soup())),
      grid_(OccluderGrid::build(hierarchy_.soup(), occluders_, hierarchy_.nodes()[0].box, config.grid)) {}

CullResult Culler::cull(const Camera& camera, const CullOptions& options) const {
  return cull_frame(camera, options, OccluderHistory());
}

CullResult Culler::cull(const Camera& camera, const CullOptions& options, OccluderHistory& history) const {
  CullResult result = cull_frame(camera, options, history);
  history.record(occluders_.size(), result.occluders);
  return result;
}

void Culler::visit_shadow_tests(const CullResult& frame, const CullOptions& options,
                                const std::function<void(const Occluder& occluder, const Box& box)>& visit) const {
  CullResult again;
  again.view = frame.view;
  again.occluders = frame.occluders;
  traverse(again, options, [&](const Occluder& occluder, const auto& box) {
    visit(occluder, box);
    return decide(occluder, box, options);
  });
}

}  // namespace occlude::culler
