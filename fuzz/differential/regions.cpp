// SPDX-License-Identifier: MIT
#include <string>
#include <utility>

#include "cull_judge.h"
#include "occlude/culler/culler.h"
#include "region_scenes.h"
#include "rows.h"
#include "sight_judge.h"
#include "verdict.h"

namespace occlude::fuzz {

void run_regions(std::uint64_t seed, Report& report) {
  Random random(seed);
  RegionScene scene = some_region_scene(random);
  culler::BuildConfig config;
  config.hierarchy.leaf_size = 1;
  config.lists.regions = 1;                                                  // covers need no regions
  const culler::Checkpoint on_one_thread(culler::Executor::own_threads(1));  // others take longer to begin
  const culler::Culler culler(std::move(scene.soup), config, on_one_thread);
  culler.prepare(culler::Method::cover, on_one_thread);
  const culler::CullResult result = culler.cull(scene.camera, scene.options);
  report.tally.cases += culler.hierarchy().soup().size();
  report.tally.relations[0] += result.stats.shadow_culled_polygons;
  report.tally.relations[1] += result.stats.drawn_polygons;
  report.tally.relations[2] += result.stats.view_culled_polygons;
  report.tally.stages[0] += culler.hierarchy().soup().size();
  std::string wrong = fault_of_sight(random, culler, scene.camera, result, report.tally.lines_of_sight);
  if (wrong.empty()) wrong = fault_of(culler, scene.camera, scene.options, result);
  if (!wrong.empty()) add_finding(report, "frame", wrong);
}

}  // namespace occlude::fuzz
