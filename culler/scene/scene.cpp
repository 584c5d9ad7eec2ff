// SPDX-License-Identifier: MIT
#include "occlude/culler/scene.h"

#include <atomic>
#include <mutex>
#include <shared_mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <variant>

#include "camera/holds_for.h"
#include "camera/sound_camera.h"
#include "cover/asked_box.h"
#include "scene/scene_access.h"
#include "scene/scene_box.h"
#include "scene/scene_frame.h"
#include "scene/scene_number.h"
#include "scene/scene_occluders.h"
#include "scene/scene_things.h"

namespace occlude::culler {
namespace {

/// So many times as far as the scene reaches do views reach that later frames are held against: things may come and go.
constexpr double kRoomOfHeld = 2;

template <class AnyCamera>
FrameView view_of(const SceneObjects& objects, const SceneOccluders& occluders, const AnyCamera& camera,
                  const SceneOptions& options) {
  require_sound(camera);
  const double farthest = reach(objects, occluders, eye_of(camera));
  return FrameView(camera, options.is_to_be_held ? kRoomOfHeld * farthest : farthest);
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
  memory.view = view_of(scene.objects, scene.occluders, camera, options);
  memory.edition = scene.edition;
  memory.standing = options.is_to_be_held ? scene.standing : 0;
  memory.mask = options.mask;
  memory.least_size = options.least_size;
  cull_scene(scene.objects, scene.occluders, options, memory);
  return view.result();
}

template <class Parts, class AnyCamera>
bool holds_any(const Parts& scene, const SceneView& held, const AnyCamera& camera, const SceneOptions& options) {
  const SceneView::Memory& memory = memory_of(held);
  if (!held.holds_for(camera) || memory.standing != scene.standing) return false;
  if (memory.mask != options.mask || memory.least_size != options.least_size) return false;
  return std::visit(
      [&](const auto& of) {
        return FrameView(of, reach(scene.objects, scene.occluders, memory.view.eye)).depth <= memory.view.depth;
      },
      memory.view.any_camera);
}

template <class Parts, class AnyCamera>
const SceneResult& cull_held_any(const Parts& scene, const AnyCamera& camera, const SceneOptions& options,
                                 const SceneView& held, SceneView& view) {
  if (&held == &view) throw std::invalid_argument("a frame cannot be held against its own view");
  if (!holds_any(scene, held, camera, options)) throw std::invalid_argument("the held frame does not hold");
  SceneView::Memory& memory = memory_of(view);
  memory.view = view_of(scene.objects, scene.occluders, camera, {});
  memory.edition = memory.standing = 0;
  cull_scene_held(scene.objects, scene.occluders, options, memory_of(held).cover.buffer, memory);
  return view.result();
}

template <class Parts>
void require_frame_of(const Parts& scene, const SceneView& view) {
  if (memory_of(view).edition == scene.edition) return;
  throw std::invalid_argument("the view's last frame is not of this scene as the last update() left it");
}

void require_legal(std::span<const Box> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::string_view reason = fault(boxes[i]);
    if (!reason.empty()) throw std::invalid_argument("object " + std::to_string(i) + ": " + std::string(reason));
  }
}

/// The options that repeat the last frame of the view.
SceneOptions repeated(const SceneView& view, SceneOptions options) {
  options.cover.as_before = {view.result().stats.work.cover_work, memory_of(view).occluders.taken};
  return options;
}

template <class Parts, class AnyCamera>
std::vector<ObjectFate> why_any(const Parts& scene, const AnyCamera& camera, const SceneOptions& options,
                                const SceneView& view, std::span<const ObjectId> ids) {
  scene.objects.require(ids);
  require_frame_of(scene, view);
  const FrameView again = view_of(scene.objects, scene.occluders, camera, options);
  return fates_of(scene.objects, scene.occluders, again, repeated(view, options), ids);
}

template <class Parts, class AnyCamera>
void append_any(const Parts& scene, const AnyCamera& camera, const SceneOptions& options, const SceneView& view,
                std::vector<ObjectWitness>& witnesses) {
  require_frame_of(scene, view);
  const FrameView again = view_of(scene.objects, scene.occluders, camera, options);
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
  /// That of the last change by which something that stands still may hide less.
  std::uint64_t standing = new_edition();
  std::unordered_set<std::uint64_t> drawing;  ///< numbers of objects that draw occluders
  bool has_lost = false;                      ///< one of them no longer does in all frames
  std::shared_mutex seen;                     ///< shared by frames that are culled whenever there is time

  void change(ObjectId object) { has_lost = has_lost || drawing.contains(object.number()); }
  void remove(ObjectId object) { has_lost = drawing.erase(object.number()) > 0 || has_lost; }

  void note_drawing(const OccluderOptions& options) {
    if (!options.object.is_none()) drawing.insert(options.object.number());
  }
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

ObjectId Scene::add(const Box& box, const ObjectOptions& options) { return parts_->objects.add(SceneBox::of(box), options); }
void Scene::add(std::span<const Box> boxes, const ObjectOptions& options, std::span<ObjectId> ids) {
  require_legal(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) ids[i] = parts_->objects.add(SceneBox::of(boxes[i]), options);
}
void Scene::remove(ObjectId object) {
  parts_->objects.remove(object);
  parts_->remove(object);
}
void Scene::remove(std::span<const ObjectId> objects) {
  parts_->objects.remove(objects);
  for (const ObjectId object : objects) parts_->remove(object);
}
void Scene::move(ObjectId object, const Box& box) { parts_->objects.move(object, SceneBox::of(box)); }
void Scene::move(std::span<const ObjectId> objects, std::span<const Box> boxes) {
  parts_->objects.require(objects);
  require_legal(boxes);
  for (std::size_t i = 0; i < objects.size(); ++i) parts_->objects.move(objects[i], SceneBox::of(boxes[i]));
}
void Scene::set_enabled(ObjectId object, bool is_enabled) {
  parts_->objects.set_enabled(object, is_enabled);
  parts_->change(object);
}
void Scene::set_mask(ObjectId object, std::uint32_t mask) {
  parts_->objects.set_mask(object, mask);
  parts_->change(object);
}
bool Scene::contains(ObjectId object) const { return parts_->objects.contains(object); }
std::string Scene::fault(ObjectId object) const { return parts_->objects.fault(object); }

OccluderId Scene::add(std::shared_ptr<const OccluderMesh> mesh, const Placement& placement, const OccluderOptions& options) {
  parts_->require_drawn(options);
  const OccluderId id = parts_->occluders.add(std::move(mesh), placement, options);
  parts_->note_drawing(options);
  return id;
}
void Scene::add(const std::shared_ptr<const OccluderMesh>& mesh, std::span<const Placement> placements,
                const OccluderOptions& options, std::span<OccluderId> ids) {
  parts_->require_drawn(options);
  parts_->occluders.add(mesh, placements, options, ids);
  parts_->note_drawing(options);
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

std::shared_lock<std::shared_mutex> SceneAccess::keep_from_updates(const Scene& scene) {
  return std::shared_lock(scene.parts_->seen);
}

void Scene::update(const Executor& executor) {
  const std::unique_lock alone(parts_->seen);
  const bool has_lost = parts_->occluders.update(executor);  // which may throw, and has then done nothing
  parts_->edition = new_edition();
  parts_->objects.update(executor);
  if (std::exchange(parts_->has_lost, false) || has_lost) parts_->standing = new_edition();
}

const SceneResult& Scene::cull(const Camera& camera, const SceneOptions& options, SceneView& view) const {
  return cull_any(*parts_, camera, options, view);
}
const SceneResult& Scene::cull(const MatrixCamera& camera, const SceneOptions& options, SceneView& view) const {
  return cull_any(*parts_, camera, options, view);
}

bool Scene::holds(const SceneView& held, const Camera& camera, const SceneOptions& options) const {
  return holds_any(*parts_, held, camera, options);
}
bool Scene::holds(const SceneView& held, const MatrixCamera& camera, const SceneOptions& options) const {
  return holds_any(*parts_, held, camera, options);
}

const SceneResult& Scene::cull(const Camera& camera, const SceneOptions& options, const SceneView& held,
                               SceneView& view) const {
  return cull_held_any(*parts_, camera, options, held, view);
}
const SceneResult& Scene::cull(const MatrixCamera& camera, const SceneOptions& options, const SceneView& held,
                               SceneView& view) const {
  return cull_held_any(*parts_, camera, options, held, view);
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
