// SPDX-License-Identifier: MIT
#include "occlude/culler/held_cull.h"

#include <memory>
#include <utility>

#include "held/held_frames.h"
#include "held/held_model.h"
#include "held/held_world.h"

namespace occlude::culler {

struct HeldCull::State {
  State(const Culler& culler, HeldOptions options, const CullOptions& cull)
      : frames(HeldModel(culler, cull), std::move(options)) {}

  HeldFrames<HeldModel> frames;
};

HeldCull::HeldCull(const Culler& culler, HeldOptions options, const CullOptions& cull)
    : state_(std::make_unique<State>(culler, std::move(options), cull)) {}
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
  State(const Scene& scene, HeldOptions options, const SceneOptions& cull)
      : frames(HeldWorld(scene, cull), std::move(options)) {}

  HeldFrames<HeldWorld> frames;
};

HeldSceneCull::HeldSceneCull(const Scene& scene, HeldOptions options, const SceneOptions& cull)
    : state_(std::make_unique<State>(scene, std::move(options), cull)) {}
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
