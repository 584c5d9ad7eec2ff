// SPDX-License-Identifier: MIT
#include "occlude/culler/held_cull.h"

#include <memory>
#include <utility>

#include "held/held_frames.h"
#include "held/held_model.h"
#include "held/held_world.h"

namespace occlude::culler {

struct HeldCull::State {
  State(const Culler& culler, HeldOptions options)
      : frames(HeldModel(culler, std::move(options.cull)), options.way, options.later, options.is_repeatable) {}

  HeldFrames<HeldModel> frames;
};

HeldCull::HeldCull(const Culler& culler, HeldOptions options)
    : state_(std::make_unique<State>(culler, std::move(options))) {}
HeldCull::~HeldCull() = default;
HeldCull::HeldCull(HeldCull&&) noexcept = default;
HeldCull& HeldCull::operator=(HeldCull&&) noexcept = default;

const HeldResult& HeldCull::cull(const Camera& camera, double seconds) {
  state_->frames.cull(camera, seconds);
  return state_->frames.source().result();
}
const HeldResult& HeldCull::cull(const MatrixCamera& camera, double seconds) {
  state_->frames.cull(camera, seconds);
  return state_->frames.source().result();
}
const HeldStats& HeldCull::stats() const { return state_->frames.stats(); }

struct HeldSceneCull::State {
  State(const Scene& scene, HeldSceneOptions options)
      : frames(HeldWorld(scene, options.cull), options.way, options.later, options.is_repeatable) {}

  HeldFrames<HeldWorld> frames;
};

HeldSceneCull::HeldSceneCull(const Scene& scene, HeldSceneOptions options)
    : state_(std::make_unique<State>(scene, std::move(options))) {}
HeldSceneCull::~HeldSceneCull() = default;
HeldSceneCull::HeldSceneCull(HeldSceneCull&&) noexcept = default;
HeldSceneCull& HeldSceneCull::operator=(HeldSceneCull&&) noexcept = default;

const SceneResult& HeldSceneCull::cull(const Camera& camera, double seconds) {
  state_->frames.cull(camera, seconds);
  return state_->frames.source().result();
}
const SceneResult& HeldSceneCull::cull(const MatrixCamera& camera, double seconds) {
  state_->frames.cull(camera, seconds);
  return state_->frames.source().result();
}
bool HeldSceneCull::is_of_point() const { return state_->frames.source().is_of_point(); }
const HeldStats& HeldSceneCull::stats() const { return state_->frames.stats(); }

}  // namespace occlude::culler
