// SPDX-License-Identifier: MIT
#include "scene_bench.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <random>
#include <span>

namespace occlude::experiments {
namespace {

using culler::DrawnObject;
using culler::ObjectFate;
using culler::ObjectId;

class Check {
 public:
  Check(const SceneWorld& world, const SceneBenchOptions& options, const Prove& prove, SceneBenchResult& result)
      : world_(world), options_(options), prove_(prove), result_(result) {}

  /// Holds the last frame of the views against a scene made anew, unless there is a budget, which ends elsewhere in other
  /// trees; and proves some culls.
  void run(std::span<const culler::SceneView> views, const culler::SceneOptions& how, std::size_t frame) {
    ++result_.frames_checked;
    std::vector<ObjectId> ids;
    const culler::Scene anew = world_.made_anew(ids);
    for (std::size_t v = 0; v < views.size(); ++v) {
      const culler::Camera camera = world_.camera(v);
      std::vector<std::uint32_t> drawn;
      for (const DrawnObject& object : views[v].result().drawn) drawn.push_back(object.id.slot());
      std::ranges::sort(drawn);
      if (!has_budget(how.cover)) compare(anew, camera, how, ids, drawn);
      prove_some(views[v], camera, how, ids, drawn, frame);
    }
  }

 private:
  void compare(const culler::Scene& anew, const culler::Camera& camera, const culler::SceneOptions& how,
               std::span<const ObjectId> ids, std::span<const std::uint32_t> drawn) {
    culler::SceneView view;
    std::vector<std::uint32_t> drawn_anew, different;
    for (const DrawnObject& object : anew.cull(camera, how, view).drawn) {
      drawn_anew.push_back(ids[object.id.slot()].slot());
    }
    std::ranges::sort(drawn_anew);
    std::ranges::set_symmetric_difference(drawn, drawn_anew, std::back_inserter(different));
    result_.objects_compared += ids.size();
    result_.different += different.size();
  }

  void prove_some(const culler::SceneView& view, const culler::Camera& camera, const culler::SceneOptions& how,
                  std::span<const ObjectId> ids, std::span<const std::uint32_t> drawn, std::size_t frame) {
    std::mt19937_64 random(options_.seed + frame);
    std::vector<ObjectId> chosen;
    // Most objects are out of view. So many are enough to find those that are hidden.
    for (std::size_t i = 0; i < 50 * options_.proofs; ++i) {
      const ObjectId id = ids[random() % ids.size()];
      if (!std::ranges::binary_search(drawn, id.slot())) chosen.push_back(id);
    }
    const std::vector<ObjectFate> fates = world_.scene().why(camera, how, view, chosen);
    std::size_t left = options_.proofs;
    for (std::size_t i = 0; i < fates.size() && left > 0; ++i) {
      if (fates[i].reason != ObjectFate::Reason::hidden) continue;
      --left;
      ++(prove_(camera, fates[i], world_.box(chosen[i])) ? result_.proved : result_.unproved);
    }
  }

  const SceneWorld& world_;
  const SceneBenchOptions& options_;
  const Prove& prove_;
  SceneBenchResult& result_;
};

/// What happens in a frame of the world.
struct Frame {
  std::size_t number;  ///< of all frames
  bool counts;
  double change_ms, update_ms;
  std::array<double, SceneWorld::kViews> cull_ms;
};

/// Goes through all frames of the world, each culled from all cameras, and calls done(frame) after each.
template <class Done>
void for_each_frame(SceneWorld& world, const SceneBenchOptions& options, const culler::SceneOptions& how,
                    std::array<culler::SceneView, SceneWorld::kViews>& views, const Done& done) {
  for (std::size_t number = 0; number < options.settling + options.frames; ++number) {
    Frame frame{number, number >= options.settling, 0, 0, {}};
    world.prepare();
    frame.change_ms = milliseconds([&] { world.change(); });
    frame.update_ms = milliseconds([&] { world.scene().update(); });
    for (std::size_t v = 0; v < views.size(); ++v) {
      const culler::Camera camera = world.camera(v);
      frame.cull_ms[v] = milliseconds([&] { world.scene().cull(camera, how, views[v]); });
    }
    done(frame);
  }
}

/// Milliseconds of culls by the view frustum alone, of the same frames: in a world of their own, because such a frame reads
/// so much that the next one finds nothing in the caches.
std::array<Spread, SceneWorld::kViews> bench_view_frustum(const SceneBenchOptions& options,
                                                          const std::function<void(std::size_t)>& progress) {
  SceneWorld world(options.world, options.seed);
  std::array<culler::SceneView, SceneWorld::kViews> views;
  std::array<std::vector<double>, SceneWorld::kViews> cull_ms;
  for_each_frame(world, options, {.cover = {.work = 0}}, views, [&](const Frame& frame) {
    for (std::size_t v = 0; frame.counts && v < views.size(); ++v) cull_ms[v].push_back(frame.cull_ms[v]);
    progress(frame.number + 1);
  });
  std::array<Spread, SceneWorld::kViews> spreads;
  std::ranges::transform(cull_ms, spreads.begin(), spread_of);
  return spreads;
}

}  // namespace

SceneBenchResult bench_scene(const SceneBenchOptions& options, const Prove& prove,
                             const std::function<void(std::size_t, std::size_t)>& progress) {
  SceneBenchResult result;
  std::optional<SceneWorld> made;
  result.build_ms = milliseconds([&] { made.emplace(options.world, options.seed); });
  SceneWorld& world = *made;
  Check check(world, options, prove, result);
  // A frame that saved work by what earlier ones found could not be held against that of a scene made anew.
  const culler::SceneOptions how{.cover = options.cover, .is_adaptive = false};
  std::array<culler::SceneView, SceneWorld::kViews> views;
  std::array<ViewSamples, SceneWorld::kViews> samples;
  std::array<culler::SceneStats, SceneWorld::kViews> sums;
  std::vector<double> change_ms, update_ms;
  const std::size_t all = options.settling + options.frames;
  for_each_frame(world, options, how, views, [&](const Frame& frame) {
    progress(frame.number + 1, 2 * all);
    if (!frame.counts) return;
    change_ms.push_back(frame.change_ms);
    update_ms.push_back(frame.update_ms);
    for (std::size_t v = 0; v < views.size(); ++v) {
      const culler::SceneStats& stats = views[v].result().stats;
      samples[v].add(frame.cull_ms[v], stats);
      sums[v].hidden += stats.hidden;
      sums[v].drawn += stats.drawn;
    }
    if (options.check_every != 0 && (frame.number - options.settling) % options.check_every == 0) {
      check.run(views, how, frame.number);
    }
  });
  result.objects = world.scene().objects();
  result.occluders = world.occluders();
  result.bytes_of_object = static_cast<double>(world.scene().object_bytes()) / static_cast<double>(result.objects);
  result.change_ms = spread_of(change_ms);
  result.update_ms = spread_of(update_ms);
  made.reset();  // before there is another one
  const auto view_frustum_ms = bench_view_frustum(options, [&](std::size_t done) { progress(all + done, 2 * all); });
  for (std::size_t v = 0; v < views.size(); ++v) {
    const double in_view = static_cast<double>(std::max<std::size_t>(sums[v].hidden + sums[v].drawn, 1));
    result.views.push_back({samples[v].spread(), view_frustum_ms[v], static_cast<double>(sums[v].hidden) / in_view});
  }
  return result;
}

}  // namespace occlude::experiments
