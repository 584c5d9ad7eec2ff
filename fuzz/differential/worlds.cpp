// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cases/to_oracle.h"
#include "model/bounds.h"
#include "occlude/culler/scene.h"
#include "occlude/oracle/cover.h"
#include "occlude/oracle/questions.h"
#include "proof/camera_picture.h"
#include "rows.h"
#include "scene/scene_frame.h"
#include "small_scenes.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using cases::to_oracle;
using culler::Camera;
using culler::ObjectFate;
using culler::ObjectId;
using culler::ObjectOptions;
using culler::ObjectWitness;
using culler::OccluderId;
using culler::OccluderMesh;
using culler::OccluderOptions;
using culler::Placement;
using culler::Scene;
using culler::SceneOptions;
using culler::SceneView;
using culler::to_glm;
using culler::to_kernel;
using culler::Visibility;
using glm::dvec3;
using kernel::Aabb;
using kernel::Vec3;
using Reason = ObjectFate::Reason;

struct Mesh {
  culler::PolygonSoup soup;
  std::shared_ptr<const OccluderMesh> prepared;
};

Mesh mesh_of(culler::PolygonSoup soup) {
  auto prepared = std::make_shared<OccluderMesh>(soup);
  return {std::move(soup), std::move(prepared)};
}

/// The box from -1 to 1 on each axis.
culler::PolygonSoup box_soup() {
  culler::PolygonSoup soup;
  soup.add_box({-1, -1, -1}, {1, 1, 1});
  return soup;
}

/// A square across an axis, of panels that share edges.
culler::PolygonSoup wall_soup(int axis, std::uint32_t panels) {
  culler::PolygonSoup soup;
  for (std::uint32_t i = 0; i <= panels; ++i) {
    for (std::uint32_t k = 0; k <= panels; ++k) {
      dvec3 v{};
      v[(axis + 1) % 3] = 4.0 * i / panels - 2;
      v[(axis + 2) % 3] = 4.0 * k / panels - 2;
      soup.add_vertex(v);
    }
  }
  for (std::uint32_t i = 0; i < panels; ++i) {
    for (std::uint32_t k = 0; k < panels; ++k) {
      const std::uint32_t at = i * (panels + 1) + k, next = at + panels + 1;
      soup.add_polygon(std::array{at, at + 1, next + 1, next});
    }
  }
  return soup;
}

Placement some_placement(Random& random) {
  Placement at;
  at.origin = to_kernel(lattice_point(random, 6));
  if (random.chance(0.3)) at.origin.x += std::ldexp(1.0, -random.integer(4, 60));
  if (random.chance(0.3)) {
    const double angle = random.real(0, 6.3), c = std::cos(angle), s = std::sin(angle);
    at.x = {c, s, 0};
    at.y = {-s, c, 0};
  }
  if (random.chance(0.2)) std::swap(at.x, at.y);  // a mirror
  if (random.chance(0.2)) at.z = {random.real(-1, 1), 0, random.real(0.2, 3)};
  if (random.chance(0.02)) at.z = {};
  return at;
}

/// What a scene should hold.
struct World {
  struct Object {
    ObjectId id;
    culler::Box box;
    ObjectOptions options;
    bool is_enabled = true;

    [[nodiscard]] std::uint32_t mask() const { return is_enabled ? options.mask : 0; }
  };
  struct Standing {
    OccluderId id;
    const Mesh* mesh;
    Placement placement;
    OccluderOptions options;
    bool is_enabled = true;
  };
  std::map<std::uint32_t, Object> objects;  ///< by slots
  std::map<std::uint32_t, Standing> occluders;

  [[nodiscard]] const Object* find(ObjectId id) const {
    const auto found = objects.find(id.slot());
    return found == objects.end() || found->second.id != id ? nullptr : &found->second;
  }
};

/// Makes changes to a scene, and finds out what is wrong with its frames.
class WorldJudge {
 public:
  WorldJudge(Random& random, Report& report) : random_(random), report_(report), soup_(some_soup(random)) {
    memory_of(view_).worth.cheap = 0;  // so that small scenes save work
    meshes_.push_back(mesh_of(box_soup()));
    // A mesh of many panels is descended in several steps, between those of others.
    const int panels = random.chance(0.03) ? 18 : random.integer(1, 5);
    meshes_.push_back(mesh_of(wall_soup(random.integer(0, 2), static_cast<std::uint32_t>(panels))));
    meshes_.push_back(mesh_of(soup_));
    meshes_.push_back(mesh_of({}));
  }

  /// Returns what was wrong; empty if nothing was.
  std::string run(int rounds) {
    for (int i = random_.integer(2, 8); i > 0; --i) add_occluder();
    for (int i = random_.integer(5, 40); i > 0; --i) add_object();
    for (int round = 0; round < rounds; ++round) {
      for (int steps = some_steps(); steps > 0; --steps) {
        if (std::string wrong = step(); !wrong.empty()) return wrong;
      }
      if (random_.chance(0.8)) {
        scene_.update();
        seen_ = world_;
      }
      if (std::string wrong = fault_of_frame(); !wrong.empty()) return wrong;
    }
    return "";
  }

 private:
  template <class Things>
  auto& any(Things& things) {
    auto at = things.begin();
    std::advance(at, static_cast<std::ptrdiff_t>(random_.index(things.size())));
    return at->second;
  }

  /// Changes before a frame: few, or as many as when a part of a world is loaded.
  int some_steps() { return random_.chance(0.1) ? random_.integer(50, 300) : random_.integer(0, 12); }

  std::uint32_t some_mask() { return random_.chance(0.7) ? ~std::uint32_t{0} : std::uint32_t{1} << random_.index(3); }

  /// Half of all occluders are welded to others.
  std::uint32_t some_weld() { return random_.chance(0.5) ? 0 : 1 + static_cast<std::uint32_t>(random_.index(2)); }

  culler::Box some_box() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (random_.chance(0.02)) return Aabb{{-kInfinity, 0, 0}, {1, 1, 1e300}};
    const dvec3 at = lattice_point(random_, 7);
    const Aabb around = random_.chance(0.5) && !soup_.empty() ? soup_.box(random_.index(soup_.size()))
                                                              : Aabb{to_kernel(at), to_kernel(at + dvec3(0.5))};
    if (random_.chance(0.6)) return around;
    const dvec3 low = to_glm(around.min), high = to_glm(around.max), half = (high - low) / 2.0;
    kernel::Obb turned{to_kernel((low + high) / 2.0), {{{half.x, half.y, 0}, {-half.y, half.x, 0}, {0, 0, half.z}}}};
    if (random_.chance(0.1)) turned.half_edges[0].z = 3.7e-33;
    return turned;
  }

  /// The box as the oracle takes it: numbers that the kernel takes for too near to zero are zero, which moves nothing by
  /// more than 2^-98.
  static culler::Box legal(culler::Box box) {
    const auto flush = [](Vec3& v) {
      for (int axis = 0; axis < 3; ++axis) {
        if (std::fabs(v[axis]) < 0x1p-100) v[axis] = 0;
      }
    };
    if (auto* const turned = std::get_if<kernel::Obb>(&box); turned != nullptr) {
      flush(turned->center);
      for (Vec3& edge : turned->half_edges) flush(edge);
    }
    return box;
  }

  void add_object() {
    World::Object object{{}, some_box(), {random_.chance(0.4), random_.chance(0.05), some_mask()}};
    object.id = scene_.add(object.box, object.options);
    world_.objects[object.id.slot()] = object;
  }

  void add_occluder() {
    World::Standing standing{{}, &meshes_[random_.index(meshes_.size())], some_placement(random_), {}};
    standing.options = {random_.chance(0.3), random_.chance(0.4), some_mask(), {}, some_weld()};
    if (random_.chance(0.3) && !world_.objects.empty()) standing.options.object = any(world_.objects).id;
    standing.id = scene_.add(standing.mesh->prepared, standing.placement, standing.options);
    world_.occluders[standing.id.slot()] = standing;
  }

  void add_tile() {
    std::vector<culler::Box> boxes;
    for (int i = random_.integer(2, 30); i > 0; --i) boxes.push_back(some_box());
    const ObjectOptions options{random_.chance(0.2), false, some_mask()};
    std::vector<ObjectId> ids(boxes.size());
    scene_.add(boxes, options, ids);
    for (std::size_t i = 0; i < ids.size(); ++i) world_.objects[ids[i].slot()] = {ids[i], boxes[i], options};
  }

  void add_occluder_tile() {
    World::Standing standing{{}, &meshes_[random_.index(meshes_.size())], {}, {}};
    standing.options = {random_.chance(0.2), random_.chance(0.4), some_mask(), {}, some_weld()};
    std::vector<Placement> placements;
    for (int i = random_.integer(2, 6); i > 0; --i) placements.push_back(some_placement(random_));
    std::vector<OccluderId> ids(placements.size());
    scene_.add(standing.mesh->prepared, placements, standing.options, ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      standing.id = ids[i];
      standing.placement = placements[i];
      world_.occluders[ids[i].slot()] = standing;
    }
  }

  std::string step() {
    switch (random_.index(13)) {
      case 0:
        add_object();
        return "";
      case 1:
        add_occluder();
        return "";
      case 2:
        if (world_.objects.size() < 100) add_tile();
        return "";
      case 3:
        return fault_of_stale_ids();
      case 4:
      case 5:
      case 6:
        change_occluder();
        return "";
      case 7:
        if (world_.occluders.size() < 20) add_occluder_tile();
        return "";
      default:
        change_object();
        return "";
    }
  }

  void change_object() {
    if (world_.objects.empty()) return;
    World::Object& object = any(world_.objects);
    const ObjectId id = object.id;
    switch (random_.index(5)) {
      case 0:
        scene_.remove(id);
        gone_.push_back(id);
        world_.objects.erase(id.slot());
        return;
      case 1:
        return scene_.set_enabled(id, object.is_enabled = !object.is_enabled);
      case 2:
        return scene_.set_mask(id, object.options.mask = some_mask());
      default:
        return scene_.move(id, object.box = some_box());
    }
  }

  void change_occluder() {
    if (world_.occluders.empty()) return;
    World::Standing& standing = any(world_.occluders);
    const OccluderId id = standing.id;
    switch (random_.index(6)) {
      case 0:
        scene_.remove(id);
        gone_occluders_.push_back(id);
        world_.occluders.erase(id.slot());
        return;
      case 1:
        return scene_.set_enabled(id, standing.is_enabled = !standing.is_enabled);
      case 2:
        return scene_.set_mask(id, standing.options.mask = some_mask());
      case 3:
        standing.mesh = &meshes_[random_.index(meshes_.size())];
        return scene_.replace(id, standing.mesh->prepared);
      default:
        return scene_.move(id, standing.placement = some_placement(random_));
    }
  }

  template <class Change>
  static bool is_refused(const Change& change) {
    try {
      change();
    } catch (const std::invalid_argument&) {
      return true;
    }
    return false;
  }

  std::string fault_of_stale_ids() {
    if (!gone_.empty()) {
      const ObjectId id = gone_[random_.index(gone_.size())];
      const std::array<std::function<void()>, 5> uses{
          [&] { scene_.move(id, Aabb{}); }, [&] { scene_.remove(id); }, [&] { scene_.remove(std::span(&id, 1)); },
          [&] { scene_.add(meshes_[0].prepared, {}, {.object = id}); },
          [&] { static_cast<void>(scene_.why(Camera{}, {}, view_, std::span(&id, 1))); }};
      if (scene_.contains(id) || !std::ranges::all_of(uses, [](const auto& use) { return is_refused(use); })) {
        return "the id of an object that was removed is taken for another";
      }
      Scene other;
      const ObjectId first = other.add(Aabb{});
      if (first == id || scene_.contains(first) || !is_refused([&] { scene_.move(first, Aabb{}); })) {
        return "the id of an object of another scene is taken for one of this";
      }
    }
    if (!gone_occluders_.empty()) {
      const OccluderId id = gone_occluders_[random_.index(gone_occluders_.size())];
      if (scene_.contains(id) || !is_refused([&] { scene_.set_enabled(id, true); })) {
        return "the id of an occluder that was removed is taken for another";
      }
    }
    return "";
  }

  std::string fault_of_frame() {
    // A view that stays where it was saves work.
    if (random_.chance(0.5)) camera_ = some_camera(random_, soup_);
    const Camera camera = camera_;
    if (!culler::fault(camera).empty()) return "";
    SceneOptions options;
    options.cover.width = std::array{64, 128, 256}[random_.index(3)];
    options.cover.height = std::array{64, 96, 160}[random_.index(3)];
    if (random_.chance(0.2)) options.cover.work = random_.index(random_.chance(0.5) ? 64 : 1000);
    if (random_.chance(0.3)) options.margin = std::array{0x1p-80, 0x1p-20, 0x1p-6}[random_.index(3)];
    if (random_.chance(0.3)) options.mask = static_cast<std::uint32_t>(random_.integer(0, 7));
    if (random_.chance(0.2)) options.least_size = static_cast<float>(random_.real(0, 0.3));
    options.is_front_to_back = random_.chance(0.3);
    options.is_adaptive = random_.chance(0.5);
    if (random_.chance(0.6)) {
      eyes_ = {camera};
      return fault_of_culls(camera, options);
    }
    culler::MatrixCamera matrix = matrix_of(random_, camera);
    if (random_.chance(0.5)) matrix.eyes.radius = std::array{1e-9, 0x1p-10, 0x1p-5, 0.5}[random_.index(4)];
    if (!culler::fault(matrix).empty()) return "";
    set_eyes(camera, matrix);
    return fault_of_culls(matrix, options);
  }

  /// The cameras from all of which what is hidden must be hidden.
  void set_eyes(const Camera& camera, const culler::MatrixCamera& matrix) {
    eyes_.clear();
    for (int i = 0; i < (matrix.eyes.radius > 0 ? 3 : 1); ++i) {
      dvec3 aside(random_.real(-1, 1), random_.real(-1, 1), random_.real(-1, 1));
      aside *= 0.999 * matrix.eyes.radius / std::max(glm::length(aside), 0.5);
      Camera moved = camera;
      // Of parallel rays the eye only says where the near plane is, and that the matrix says to rounding.
      const bool is_perspective = camera.projection == culler::Projection::perspective;
      moved.eye = (is_perspective && matrix.eyes.radius == 0 ? matrix.eye() : camera.eye) + aside;
      moved.target += moved.eye - camera.eye;
      eyes_.push_back(moved);
    }
  }

  template <class AnyCamera>
  std::string fault_of_culls(const AnyCamera& camera, const SceneOptions& options) {
    scene_.cull(camera, options, view_);
    if (std::string wrong = fault_of_list(options); !wrong.empty()) return wrong;
    if (std::string wrong = fault_of_proofs(camera, options); !wrong.empty()) return wrong;
    if (std::string wrong = fault_of_fates(camera, options); !wrong.empty()) return wrong;
    // What a budget is spent on depends on the groups that the changes have made, and so does what is hidden from several
    // eyes: which layers a box is asked in depends on how far it reaches.
    const bool is_alike = options.cover.work == SceneOptions{}.cover.work && eyes_.size() == 1;
    return !options.is_adaptive && random_.chance(0.3) && is_alike ? fault_beside_scene_anew(camera, options) : "";
  }

  /// Whether each object in a layer of the frame is listed or counted once.
  std::string fault_of_list(const SceneOptions& options) {
    const culler::SceneResult& result = view_.result();
    drawn_.clear();
    for (std::size_t i = 0; i < result.drawn.size(); ++i) {
      const culler::DrawnObject& object = result.drawn[i];
      if (options.is_front_to_back && i > 0 && result.drawn[i - 1].distance > object.distance)
        return "not from front to back";
      const World::Object* known = seen_.find(object.id);
      if (known == nullptr) return "an object is drawn that is not in the scene";
      if ((known->mask() & options.mask) == 0) return "an object is drawn that is in no layer of the frame";
      drawn_.push_back(object.id.slot());
    }
    std::ranges::sort(drawn_);
    if (std::ranges::adjacent_find(drawn_) != drawn_.end()) return "an object is drawn twice";
    const auto in_layers =
        std::ranges::count_if(seen_.objects, [&](const auto& entry) { return (entry.second.mask() & options.mask) != 0; });
    const culler::SceneStats& stats = result.stats;
    report_.tally.cases += stats.hidden + stats.drawn + stats.out_of_view;
    report_.tally.relations[0] += stats.hidden;
    report_.tally.relations[1] += stats.drawn;
    report_.tally.relations[2] += stats.out_of_view;
    const std::size_t counted = stats.drawn + stats.hidden + stats.out_of_view + stats.too_small;
    if (stats.drawn != drawn_.size() || counted != static_cast<std::size_t>(in_layers))
      return "objects are not counted once";
    return "";
  }

  template <class AnyCamera>
  std::string fault_of_fates(const AnyCamera& camera, const SceneOptions& options) {
    std::vector<ObjectId> ids;
    for (const auto& [slot, object] : world_.objects) ids.push_back(object.id);
    const std::vector<ObjectFate> fates = scene_.why(camera, options, view_, ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const World::Object* object = seen_.find(ids[i]);
      if (std::string wrong = fault_of_fate(options, object, fates[i]); !wrong.empty()) return wrong;
    }
    return "";
  }

  std::string fault_of_fate(const SceneOptions& options, const World::Object* object, const ObjectFate& fate) {
    if ((object == nullptr) != (fate.reason == Reason::not_in_scene)) return "why: not in the scene, or is it";
    if (object == nullptr) return "";
    const bool is_in_layer = (object->mask() & options.mask) != 0;
    if (is_in_layer == (fate.reason == Reason::in_no_layer)) return "why: the layers are others";
    const bool is_drawn = std::ranges::binary_search(drawn_, object->id.slot());
    if (is_drawn != (fate.reason == Reason::drawn || fate.reason == Reason::always_drawn)) return "why: not what was drawn";
    const auto proof = proofs_.find(object->id.slot());
    const bool is_proved = proof != proofs_.end() && proof->second.reason == fate.reason &&
                           proof->second.plane == fate.plane && proof->second.by.size() == fate.by.size();
    if (is_proved != (fate.reason == Reason::hidden || fate.reason == Reason::out_of_view)) return "why: not what is proved";
    return "";
  }

  /// Proves every cull, and keeps the proofs.
  template <class AnyCamera>
  std::string fault_of_proofs(const AnyCamera& camera, const SceneOptions& options) {
    std::vector<ObjectWitness> witnesses;
    scene_.append_witnesses(camera, options, view_, witnesses);
    proofs_.clear();
    for (const ObjectWitness& witness : witnesses) {
      const World::Object* object = seen_.find(witness.object);
      if (object == nullptr) return "an object is proved to be hidden that is not in the scene";
      const culler::Box box = legal(object->box);
      if (!holds(witness, box)) return "an object reaches out of the box that is proved to be culled";
      if (std::string wrong = fault_of_proof(options, witness); !wrong.empty()) return wrong;
      proofs_[witness.object.slot()] = witness.fate;
    }
    const culler::SceneStats& stats = view_.result().stats;
    const bool is_each = proofs_.size() == witnesses.size() && proofs_.size() == stats.hidden + stats.out_of_view;
    return is_each ? "" : "not each cull is proved once";
  }

  std::string fault_of_proof(const SceneOptions& options, const ObjectWitness& witness) {
    if (witness.fate.reason == Reason::out_of_view) {
      return fault_of_plane(witness.box, view_.result().view[witness.fate.plane]);
    }
    if (witness.fate.reason != Reason::hidden) return "an object is proved to be culled and was not";
    for (const Camera& eye : eyes_) {
      if (std::string wrong = fault_of_hidden(eye, options, witness.box, witness.fate); !wrong.empty()) return wrong;
    }
    return "";
  }

  /// Whether the box of the witness holds that of the object. The planes of an oriented one are no doubles; it is held to
  /// what matters, that the object is beyond the plane of the view.
  bool holds(const ObjectWitness& witness, const culler::Box& object) const {
    const auto* const aabb = std::get_if<Aabb>(&witness.box);
    if (aabb == nullptr) {
      return witness.fate.reason == Reason::out_of_view &&
             fault_of_plane(object, view_.result().view[witness.fate.plane]).empty();
    }
    std::vector<oracle::HalfSpaceCoefficients> sides;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sides.push_back({0, 0, 0, -aabb->min[static_cast<int>(axis)]});
      sides.back()[axis] = 1;
      sides.push_back({0, 0, 0, aabb->max[static_cast<int>(axis)]});
      sides.back()[axis] = -1;
    }
    return oracle::relation_to_half_spaces(sides, to_oracle(object)).relation == oracle::Relation::inside;
  }

  static std::string fault_of_plane(const culler::Box& box, const culler::HalfSpace& h) {
    const std::array<oracle::HalfSpaceCoefficients, 1> planes{{{h.normal.x, h.normal.y, h.normal.z, h.offset}}};
    const oracle::Answer answer = oracle::relation_to_half_spaces(planes, to_oracle(box));
    return answer.relation == oracle::Relation::outside ? "" : "an object is not beyond the plane of the view that culls it";
  }

  std::string fault_of_hidden(const Camera& camera, const SceneOptions& options, const culler::Box& box,
                              const ObjectFate& fate) {
    std::vector<oracle::Loop> polygons;
    for (const auto& [id, polygon, corners] : fate.by) {
      const auto found = seen_.occluders.find(id.slot());
      if (found == seen_.occluders.end() || found->second.id != id) return "hidden by what is not in the scene";
      const World::Standing& standing = found->second;
      if (!standing.is_enabled || (standing.options.mask & options.mask) == 0) return "hidden by what is in no layer";
      if (const ObjectId its = standing.options.object; !its.is_none()) {
        const World::Object* object = seen_.find(its);
        if (object == nullptr || (object->mask() & options.mask) == 0) return "hidden by an occluder without its object";
      }
      if (!is_placed(standing, polygon, corners)) return "hidden by an occluder where it is not";
      // Of several eyes, some may see the back of a polygon. Those that they see from the front must hide.
      if (standing.options.is_one_sided && is_certainly_back(camera, standing, corners)) continue;
      polygons.emplace_back();
      for (const Vec3& corner : corners) polygons.back().push_back(to_oracle(corner));
    }
    const bool is_perspective = camera.projection == culler::Projection::perspective;
    const dvec3 from = is_perspective ? camera.eye : camera.axes().forward;
    const oracle::Answer answer = oracle::relation_to_cover({to_oracle(to_kernel(from)), !is_perspective}, polygons,
                                                            to_oracle(box), proof::drawn(camera, to_oracle(extent())));
    if (answer.relation == oracle::Relation::inside && answer.refusal.empty()) return "";
    return "an object is hidden, and the polygons named do not hide it";
  }

  /// The box around all occluders that may hide. Where what is drawn begins depends on how far the scene reaches.
  [[nodiscard]] Aabb extent() const {
    dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& [slot, standing] : seen_.occluders) {
      if (!standing.is_enabled) continue;
      const Placement& at = standing.placement;
      for (const dvec3& v : standing.mesh->soup.vertices) {
        const dvec3 p = v.x * to_glm(at.x) + v.y * to_glm(at.y) + v.z * to_glm(at.z) + to_glm(at.origin);
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    return {to_kernel(low), to_kernel(high)};
  }

  static bool is_placed(const World::Standing& standing, std::uint32_t polygon, const std::vector<Vec3>& corners) {
    const culler::PolygonSoup& soup = standing.mesh->soup;
    if (polygon >= soup.size() || soup.loop(polygon).size() != corners.size()) return false;
    const Placement& at = standing.placement;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const dvec3& v = soup.vertices[soup.loop(polygon)[i]];
      const dvec3 exact = v.x * to_glm(at.x) + v.y * to_glm(at.y) + v.z * to_glm(at.z) + to_glm(at.origin);
      if (glm::length(exact - to_glm(corners[i])) > 1e-12) return false;
    }
    return true;
  }

  static bool is_certainly_back(const Camera& camera, const World::Standing& standing, const std::vector<Vec3>& corners) {
    const dvec3 a = to_glm(corners[0]);
    // Of other polygons, which need not be flat, some triangles may be front faces.
    if (corners.size() > 3) return false;
    const dvec3 along = to_glm(corners[1]) - a, across = to_glm(corners[2]) - a, normal = glm::cross(along, across);
    if (glm::length(normal) <= 1e-9 * glm::length(along) * glm::length(across)) return false;  // a line, which rounds
    const Placement& at = standing.placement;
    const double determinant = glm::dot(to_glm(at.x), glm::cross(to_glm(at.y), to_glm(at.z)));
    if (std::fabs(determinant) < 1e-9) return false;
    const dvec3 sight = camera.projection == culler::Projection::perspective ? a - camera.eye : camera.axes().forward;
    const double facing = glm::dot(normal, sight) * (determinant < 0 ? -1 : 1);
    return facing > 1e-9 * glm::length(normal) * glm::length(sight);
  }

  /// A scene with the same content, made at once, draws the same objects.
  template <class AnyCamera>
  std::string fault_beside_scene_anew(const AnyCamera& camera, const SceneOptions& options) {
    Scene anew;
    const ObjectId gone = anew.add(Aabb{});
    std::map<std::uint32_t, ObjectId> ids;
    std::map<std::uint32_t, std::uint32_t> slots;
    for (const auto& [slot, object] : seen_.objects) {
      ids[slot] = anew.add(object.box, object.options);
      slots[ids[slot].slot()] = slot;
      if (!object.is_enabled) anew.set_enabled(ids[slot], false);
    }
    for (const auto& [slot, standing] : seen_.occluders) {
      OccluderOptions its = standing.options;
      if (!its.object.is_none()) its.object = seen_.find(its.object) == nullptr ? gone : ids[its.object.slot()];
      const OccluderId id = anew.add(standing.mesh->prepared, standing.placement, its);
      if (!standing.is_enabled) anew.set_enabled(id, false);
    }
    anew.remove(gone);
    anew.update();
    SceneView view;
    std::vector<std::uint32_t> drawn;
    for (const culler::DrawnObject& object : anew.cull(camera, options, view).drawn)
      drawn.push_back(slots[object.id.slot()]);
    std::ranges::sort(drawn);
    return drawn == drawn_ ? "" : "a scene made anew draws other objects";
  }

  Random& random_;
  Report& report_;
  culler::PolygonSoup soup_;
  std::vector<Mesh> meshes_;
  Scene scene_;
  SceneView view_;
  World world_, seen_;  ///< as it will be, and as views see it
  std::vector<ObjectId> gone_;
  std::vector<OccluderId> gone_occluders_;
  std::vector<std::uint32_t> drawn_;            ///< slots, in the last frame
  std::map<std::uint32_t, ObjectFate> proofs_;  ///< by slots, of the last frame
  Camera camera_;
  std::vector<Camera> eyes_;  ///< of the last frame
};

}  // namespace

void run_worlds(std::uint64_t seed, Report& report) {
  Random random(seed);
  const std::string wrong = WorldJudge(random, report).run(12);
  report.tally.stages[0] = report.tally.cases;
  if (!wrong.empty()) add_finding(report, "scene", wrong);
}

}  // namespace occlude::fuzz
