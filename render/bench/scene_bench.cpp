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

  /// Holds the last frame of the views against a scene made anew, and proves some culls.
  void run(std::span<const culler::SceneView> views, const culler::SceneOptions& how, std::size_t frame) {
    ++result_.frames_checked;
    std::vector<ObjectId> ids;
    const culler::Scene anew = world_.made_anew(ids);
    for (std::size_t v = 0; v < views.size(); ++v) {
      const culler::Camera camera = world_.camera(v);
      std::vector<std::uint32_t> drawn, drawn_anew, different;
      for (const DrawnObject& object : views[v].result().drawn) drawn.push_back(object.id.slot());
      culler::SceneView view;
      for (const DrawnObject& object : anew.cull(camera, how, view).drawn)
        drawn_anew.push_back(ids[object.id.slot()].slot());
      std::ranges::sort(drawn);
      std::ranges::sort(drawn_anew);
      std::ranges::set_symmetric_difference(drawn, drawn_anew, std::back_inserter(different));
      result_.objects_compared += ids.size();
      result_.different += different.size();
      prove_some(views[v], camera, how, ids, drawn, frame);
    }
  }

 private:
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

}  // namespace

SceneBenchResult bench_scene(const SceneBenchOptions& options, const Prove& prove,
                             const std::function<void(std::size_t, std::size_t)>& progress) {
  SceneBenchResult result;
  std::optional<SceneWorld> made;
  result.build_ms = milliseconds([&] { made.emplace(options.world, options.seed); });
  SceneWorld& world = *made;
  Check check(world, options, prove, result);
  const culler::SceneOptions how{.cover = options.cover};
  std::array<culler::SceneView, SceneWorld::kViews> views;
  std::array<ViewSamples, SceneWorld::kViews> samples;
  std::vector<double> change_ms, update_ms;
  const std::size_t all = options.settling + options.frames;
  for (std::size_t frame = 0; frame < all; ++frame) {
    world.prepare();
    const double change = milliseconds([&] { world.change(); });
    const double update = milliseconds([&] { world.scene().update(); });
    const bool counts = frame >= options.settling;
    if (counts) {
      change_ms.push_back(change);
      update_ms.push_back(update);
    }
    for (std::size_t v = 0; v < views.size(); ++v) {
      const culler::Camera camera = world.camera(v);
      const double cull = milliseconds([&] { world.scene().cull(camera, how, views[v]); });
      if (counts) samples[v].add(cull, views[v].result().stats);
    }
    if (counts && options.check_every != 0 && (frame - options.settling) % options.check_every == 0) {
      check.run(views, how, frame);
    }
    progress(frame + 1, all);
  }
  result.objects = world.scene().objects();
  result.occluders = world.occluders();
  result.bytes_of_object = static_cast<double>(world.scene().object_bytes()) / static_cast<double>(result.objects);
  result.change_ms = spread_of(change_ms);
  result.update_ms = spread_of(update_ms);
  for (const ViewSamples& of_view : samples) result.views.push_back(of_view.spread());
  return result;
}

}  // namespace occlude::experiments
