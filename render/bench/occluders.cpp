// SPDX-License-Identifier: MIT
#include "occluders.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include "bench.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/scene.h"
#include "occlude/culler/simplified_occluders.h"
#include "occlude/render/processor_time.h"
#include "occlude/render/progress.h"
#include "rounds.h"

namespace occlude::experiments {
namespace {

constexpr std::array<std::size_t, 6> kTriangles{100'000, 60'000, 30'000, 20'000, 10'000, 3'000};

/// A scene of the same objects and other occluders, and its timings, one number per round.
struct OccludersTrial {
  OccludersPoint point;
  culler::CoverOptions cover;
  culler::Scene scene;
  std::vector<double> cull_ms;
};

std::vector<culler::Box> leaves_of(const culler::PolygonSoup& soup) {
  const culler::Hierarchy tree = culler::Hierarchy::build(soup, {.leaf_size = 16}, render::check_interrupt);
  std::vector<culler::Box> leaves;
  for (const culler::Hierarchy::Node& node : tree.nodes()) {
    if (node.is_leaf()) leaves.emplace_back(node.box);
  }
  return leaves;
}

culler::Scene scene_of(const std::vector<culler::Box>& objects, culler::PolygonSoup occluders) {
  culler::Scene scene;
  std::vector<culler::ObjectId> ids(objects.size());
  scene.add(objects, {}, ids);
  scene.add(std::make_shared<culler::OccluderMesh>(std::move(occluders), render::check_interrupt));
  scene.update();
  return scene;
}

/// The first triangles of occluders, which are the best.
culler::PolygonSoup best_of(const culler::PolygonSoup& occluders, std::size_t triangles) {
  culler::PolygonSoup soup;
  soup.vertices = occluders.vertices;
  for (std::size_t t = 0; t < triangles; ++t) soup.add_polygon(occluders.loop(t));
  return soup;
}

/// With pictures whose sides are a third longer. Few occluders leave time for them.
culler::CoverOptions finer(culler::CoverOptions cover) {
  cover.width = std::min(cover.width * 4 / 3, culler::kMostCoverSide);
  cover.height = std::min(cover.height * 4 / 3, culler::kMostCoverSide);
  return cover;
}

void run(OccludersTrial& trial, const Subject& subject, const Options& options) {
  culler::SceneView view;
  double hidden = 0, in_view = 0, triangles = 0, ms = 0;
  const auto frames = frames_of(subject.path, options.walk);
  for (const std::size_t frame : frames) {
    render::check_interrupt();
    const culler::Camera camera = subject.path.camera(frame, aspect(options.walk));
    const render::ProcessorTime time(render::ProcessorTime::Of::thread);
    // Each frame looks at all occluders, so that these alone are compared.
    const culler::SceneOptions how{.cover = trial.cover, .is_adaptive = false};
    const culler::SceneStats& stats = trial.scene.cull(camera, how, view).stats;
    ms += time.milliseconds();
    hidden += static_cast<double>(stats.hidden);
    in_view += static_cast<double>(stats.hidden + stats.drawn);
    triangles += static_cast<double>(stats.work.cover_triangles);
  }
  const auto count = static_cast<double>(frames.size());
  trial.cull_ms.push_back(ms / count);
  trial.point.hidden_share = in_view > 0 ? hidden / in_view : 0;
  trial.point.cover_triangles = triangles / count;
}

}  // namespace

Occluders measure_occluders(const Subject& subject, const Options& options) {
  const std::vector<culler::Box> objects = leaves_of(subject.soup);
  std::vector<OccludersTrial> trials;
  const culler::CoverOptions& cover = options.walk.cull.cover;
  const auto add = [&](const char* chosen, const culler::CoverOptions& how, culler::PolygonSoup soup) {
    std::size_t triangles = 0;
    for (std::size_t p = 0; p < soup.size(); ++p) triangles += soup.triangles(p);
    trials.push_back(
        {.point = {chosen, triangles}, .cover = how, .scene = scene_of(objects, std::move(soup)), .cull_ms = {}});
  };
  add("what is drawn", cover, subject.soup);
  const std::vector<culler::Camera> views = subject.path.views(aspect(options.walk));
  for (const std::size_t boxes : {std::size_t{0}, culler::InnerBoxOptions().boxes}) {
    const culler::SimplifyOptions all{std::numeric_limits<std::size_t>::max(), views, {.boxes = boxes}};
    const culler::PolygonSoup best = simplified_occluders(subject.soup, all, render::check_interrupt).soup;
    if (boxes == 0) add("its flat regions", cover, best);
    for (const std::size_t triangles : kTriangles) {
      if (triangles >= best.size()) continue;
      add(boxes == 0 ? "the best" : "the best, with boxes", cover, best_of(best, triangles));
      if (boxes == 0) add("the best, in a finer picture", finer(cover), best_of(best, triangles));
    }
  }

  run_in_rounds("occluders", options.repetitions, trials, [&](OccludersTrial& trial) { run(trial, subject, options); });
  Occluders occluders{objects.size(), {}};
  for (OccludersTrial& trial : trials) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < trial.cull_ms.size(); ++i) ratios.push_back(trial.cull_ms[i] / trials[0].cull_ms[i]);
    trial.point.cull_ms = bench::median(trial.cull_ms);
    trial.point.cull_ratio = bench::median(ratios);
    occluders.points.push_back(trial.point);
  }
  return occluders;
}

}  // namespace occlude::experiments
