// SPDX-License-Identifier: MIT
#include "proved_scene.h"

#include <glm/geometric.hpp>
#include <vector>

#include "cases/to_oracle.h"
#include "occlude/oracle/cover.h"
#include "occlude/render/progress.h"

namespace occlude::cli {
namespace {

oracle::Point point_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Asks the oracle whether the polygons hide the box beyond the camera's near plane.
bool is_proved(const culler::Camera& camera, const culler::ObjectFate& fate, const culler::Box& box) {
  std::vector<oracle::Loop> polygons;
  for (const auto& hiding : fate.by) polygons.push_back(cases::to_oracle(hiding.corners));
  const glm::dvec3 forward = camera.axes().forward;
  const oracle::HalfSpaceCoefficients drawn{forward.x, forward.y, forward.z,
                                            -glm::dot(forward, camera.eye) - camera.near_plane};
  const oracle::Answer answer =
      oracle::relation_to_cover({point_of(camera.eye), false}, polygons, cases::to_oracle(box), drawn);
  return answer.refusal.empty() && answer.relation == oracle::Relation::inside;
}

}  // namespace

experiments::SceneBenchResult measure_scene(const experiments::SceneBenchOptions& options) {
  render::Progress progress("frame", 2 * (options.settling + options.frames));
  return experiments::bench_scene(options, is_proved, [&](std::size_t done, std::size_t) {
    render::check_interrupt();
    progress.update(done);
  });
}

}  // namespace occlude::cli
