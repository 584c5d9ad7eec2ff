// SPDX-License-Identifier: MIT
#include "occlude/culler/scene.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <utility>

#include "camera/holds_for.h"
#include "camera/sound_camera.h"
#include "cover/asked_box.h"
#include "scene/scene_frame.h"
#include "scene/scene_number.h"
#include "scene/scene_objects.h"
#include "scene/scene_occluders.h"

namespace occlude::culler {
namespace {

template <class AnyCamera>
FrameView view_of(const SceneObjects& objects, const SceneOccluders& occluders, const AnyCamera& camera) {
  require_sound(camera);
  return FrameView(camera, reach(objects, occluders, eye_of(camera)));
}

/// A number that no other scene has, nor this one before.
std::uint64_t new_edition() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

/// `scene` is a Scene::Parts; so below.
template <class Parts, class AnyCamera>
const SceneResult& cull_any(const Parts& scene, const AnyCamera& camera, const SceneOptions& options, SceneView& view) {
  SceneView::Memory& memory = memory_of(view);
  memory.view = view_of(scene.objects, scene.occluders, camera);
  memory.edition = scene.edition;
  cull_scene(scene.objects, scene.occluders, options, memory);
  return view.result();
}

template <class Parts>
void require_frame_of(const Parts& scene, const SceneView& view) {
  if (memory_of(view).edition == scene.edition) return;
  throw std::invalid_argument("the view's last frame is not of this scene as the last update() left it");
}

/// The options that repeat the last frame of the view.
SceneOptions repeated(const SceneView& view, SceneOptions options) {
  options.cover = repeated(view.result().stats.work, options.cover);
  return options;
}

template <class Parts, class AnyCamera>
std::vector<ObjectFate> why_any(const Parts& scene, const AnyCamera& camera, const SceneOptions& options,
                                const SceneView& view, std::span<const ObjectId> ids) {
  scene.objects.require(ids);
  require_frame_of(scene, view);
  const FrameView again = view_of(scene.objects, scene.occluders, camera);
  return fates_of(scene.objects, scene.occluders, again, repeated(view, options), ids);
}

template <class Parts, class AnyCamera>
void append_any(const Parts& scene, const AnyCamera& camera, const SceneOptions& options, const SceneView& view,
                std::vector<ObjectWitness>& witnesses) {
  require_frame_of(scene, view);
  const FrameView again = view_of(scene.objects, scene.occluders, camera);
  append_witnesses_of(scene.objects, scene.occluders, again, repeated(view, options), witnesses);
}

}  // namespace

SceneView::SceneView() : memory_(std::make_unique<Memory>()) {}
SceneView::~SceneView() = default;
SceneView::SceneView(SceneView&&) noexcept = default;
SceneView& SceneView::operator=(SceneView&&) noexcept = default;

SceneView::Memory& memory_of(const SceneView& view) { return *view.memory_; }

const SceneResult& SceneView::result() const { return memory_->result; }

Visibility SceneView::visibility(const Box& box) const {
  return visibility_of(box, memory_->view, memory_->result.view,
                       [&](const auto& b) { return hides_any(memory_->cover.buffer, b); });
}

bool SceneView::holds_for(const Camera& camera) const {
  return !result().view.empty() && culler::holds_for(memory_->view, camera);
}
bool SceneView::holds_for(const MatrixCamera& camera) const {
  return !result().view.empty() && culler::holds_for(memory_->view, camera);
}

struct Scene::Parts {
  SceneNumber number;
  SceneObjects objects{number};
  SceneOccluders occluders{number};
  std::uint64_t edition = new_edition();  ///< that of what views see

  /// Throws std::invalid_argument unless the object that draws an occluder, if any, is there.
  void require_drawn(const OccluderOptions& options) const {
    const std::string reason = options.object.is_none() ? "" : objects.fault(options.object);
    if (!reason.empty()) throw std::invalid_argument("the object that draws the occluder: " + reason);
  }
};

Scene::Scene() : parts_(std::make_unique<Parts>()) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

ObjectId Scene::add(const Box& box, const ObjectOptions& options) { return parts_->objects.add(box, options); }
void Scene::add(std::span<const Box> boxes, const ObjectOptions& options, std::span<ObjectId> ids) {
  parts_->objects.add(boxes, options, ids);
}
void Scene::remove(ObjectId object) { parts_->objects.remove(object); }
void Scene::remove(std::span<const ObjectId> objects) { parts_->objects.remove(objects); }
void Scene::move(ObjectId object, const Box& box) { parts_->objects.move(object, box); }
void Scene::move(std::span<const ObjectId> objects, std::span<const Box> boxes) { parts_->objects.move(objects, boxes); }
void Scene::set_enabled(ObjectId object, bool is_enabled) { parts_->objects.set_enabled(object, is_enabled); }
void Scene::set_mask(ObjectId object, std::uint32_t mask) { parts_->objects.set_mask(object, mask); }
bool Scene::contains(ObjectId object) const { return parts_->objects.contains(object); }
std::string Scene::fault(ObjectId object) const { return parts_->objects.fault(object); }

OccluderId Scene::add(std::shared_ptr<const OccluderMesh> mesh, const Placement& placement, const OccluderOptions& options) {
  parts_->require_drawn(options);
  return parts_->occluders.add(std::move(mesh), placement, options);
}
void Scene::add(const std::shared_ptr<const OccluderMesh>& mesh, std::span<const Placement> placements,
                const OccluderOptions& options, std::span<OccluderId> ids) {
  parts_->require_drawn(options);
  parts_->occluders.add(mesh, placements, options, ids);
}
void Scene::remove(OccluderId occluder) { parts_->occluders.remove(occluder); }
void Scene::remove(std::span<const OccluderId> occluders) { parts_->occluders.remove(occluders); }
void Scene::move(OccluderId occluder, const Placement& placement) { parts_->occluders.move(occluder, placement); }
void Scene::move(std::span<const OccluderId> occluders, std::span<const Placement> placements) {
  parts_->occluders.move(occluders, placements);
}
void Scene::replace(OccluderId occluder, std::shared_ptr<const OccluderMesh> mesh) {
  parts_->occluders.replace(occluder, std::move(mesh));
}
void Scene::set_enabled(OccluderId occluder, bool is_enabled) { parts_->occluders.set_enabled(occluder, is_enabled); }
void Scene::set_mask(OccluderId occluder, std::uint32_t mask) { parts_->occluders.set_mask(occluder, mask); }
bool Scene::contains(OccluderId occluder) const { return parts_->occluders.contains(occluder); }
std::string Scene::fault(OccluderId occluder) const { return parts_->occluders.fault(occluder); }

void Scene::update(const Executor& executor) {
  parts_->edition = new_edition();
  parts_->objects.update(executor);
  parts_->occluders.update();
}

const SceneResult& Scene::cull(const Camera& camera, const SceneOptions& options, SceneView& view) const {
  return cull_any(*parts_, camera, options, view);
}
const SceneResult& Scene::cull(const MatrixCamera& camera, const SceneOptions& options, SceneView& view) const {
  return cull_any(*parts_, camera, options, view);
}

std::vector<ObjectFate> Scene::why(const Camera& camera, const SceneOptions& options, const SceneView& view,
                                   std::span<const ObjectId> objects) const {
  return why_any(*parts_, camera, options, view, objects);
}
std::vector<ObjectFate> Scene::why(const MatrixCamera& camera, const SceneOptions& options, const SceneView& view,
                                   std::span<const ObjectId> objects) const {
  return why_any(*parts_, camera, options, view, objects);
}

void Scene::append_witnesses(const Camera& camera, const SceneOptions& options, const SceneView& view,
                             std::vector<ObjectWitness>& witnesses) const {
  append_any(*parts_, camera, options, view, witnesses);
}
void Scene::append_witnesses(const MatrixCamera& camera, const SceneOptions& options, const SceneView& view,
                             std::vector<ObjectWitness>& witnesses) const {
  append_any(*parts_, camera, options, view, witnesses);
}

std::size_t Scene::objects() const { return parts_->objects.size(); }
std::size_t Scene::occluders() const { return parts_->occluders.size(); }
std::size_t Scene::object_bytes() const { return parts_->objects.bytes(); }

}  // namespace occlude::culler
