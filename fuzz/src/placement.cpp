// SPDX-License-Identifier: MIT
#include "placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sketch.h"

namespace occlude::fuzz {
namespace {

enum class Intent { inside, poking, touching, apart };

/// How far a box reaches from its contact point, down and up along each of its axes.
struct Extents {
  std::array<double, 3> down{}, up{};
};

Intent random_intent(Random& random) {
  const double u = random.real(0, 1);
  return u < 0.4 ? Intent::inside : u < 0.5 ? Intent::poking : u < 0.65 ? Intent::touching : Intent::apart;
}

double reach_of(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A factor for the axis that makes its largest coordinate 0.1 to 1.
double random_extent(Random& random, const Vec3& axis) { return random.real(0.1, 1) / reach_of(axis); }

/// Extents for which no point of the box is on the negative side of any normal.
Extents random_extents(Random& random, const Frame& frame, const std::vector<Vec3>& normals) {
  Extents extents;
  for (std::size_t i = 0; i < 3; ++i) {
    if (frame[i] == Vec3{}) continue;
    const bool may_sink = std::ranges::all_of(normals, [&](const Vec3& n) { return dot(n, frame[i]) <= 0; });
    const bool may_rise = std::ranges::all_of(normals, [&](const Vec3& n) { return dot(n, frame[i]) >= 0; });
    if (may_sink && random.chance(0.8)) extents.down[i] = random_extent(random, frame[i]);
    if (may_rise && random.chance(0.8)) extents.up[i] = random_extent(random, frame[i]);
  }
  return extents;
}

/// The largest factor for extents about `point` that stays within the planes that the point is not on. Infinite when there
/// is no limit.
double room_for(const std::vector<SketchPlane>& planes, const Vec3& point, const Frame& frame, const Extents& extents) {
  double room = std::numeric_limits<double>::infinity();
  for (const SketchPlane& plane : planes) {
    const double height = plane.height(point);
    double drop = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double n = dot(plane.normal, frame[i]);
      drop += n > 0 ? n * extents.down[i] : -n * extents.up[i];
    }
    if (height > 0 && drop > 0) room = std::min(room, height / drop);
  }
  return room;
}

/// The planes with the normals n and m meet in an edge of the frustum. Returns the normal of the plane that contains that
/// edge and the direction `axis`, as a positive combination of n and m. Empty unless a line along `axis` through the edge
/// leaves the frustum both ways.
std::optional<Vec3> normal_across(const Vec3& n, const Vec3& m, const Vec3& axis) {
  const double along_n = dot(n, axis), along_m = dot(m, axis);
  if (along_n * along_m >= 0) return std::nullopt;
  return std::abs(along_m) * n + std::abs(along_n) * m;
}

/// The normal of a plane through the contact with the frustum on its positive side, a positive combination of the normals
/// there. If the chosen normals allow it, the plane is parallel to an axis of the box, so that an edge of the box can lie
/// across an edge of the frustum.
Vec3 supporting_normal(Random& random, const std::vector<Vec3>& normals, const Frame& frame) {
  const Vec3 &n = normals[random.index(normals.size())], &m = normals[random.index(normals.size())];
  if (const auto across = normal_across(n, m, frame[random.index(3)])) return *across;
  return random.chance(0.5) ? n : n + m;
}

int main_axis(const Vec3& v) {
  const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

void flatten(Random& random, Extents& extents, int axes) {
  const std::size_t first = random.index(3);
  for (std::size_t i = 0; i < static_cast<std::size_t>(axes); ++i) {
    extents.down[(first + i) % 3] = extents.up[(first + i) % 3] = 0;
  }
}

double size_of(const Scene& scene, const Vec3& point) {
  return std::max(reach_of(point - (scene.viewpoint.is_eye() ? scene.viewpoint.value : scene.vertices[0])), 1.0);
}

/// The box that reaches the extents, times `factor`, from the point. On a lattice its bounds are integers.
kernel::Aabb make_aabb(const Vec3& point, const Extents& extents, double factor, bool is_lattice) {
  kernel::Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double down = factor * extents.down[i], up = factor * extents.up[i];
    box.min[axis] = point[axis] - (is_lattice ? std::floor(down) : down);
    box.max[axis] = point[axis] + (is_lattice ? std::floor(up) : up);
  }
  return box;
}

/// The same along the axes of the frame. On a lattice half of each extent is an integer, so centre and half edges are too.
kernel::Obb make_obb(const Vec3& point, const Frame& frame, const Extents& extents, double factor, bool is_lattice) {
  kernel::Obb box{point, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    double down = 0.5 * factor * extents.down[i], up = 0.5 * factor * extents.up[i];
    if (is_lattice) {
      down = std::floor(down);
      up = std::floor(up);
    }
    box.center = box.center + (up - down) * frame[i];
    box.half_edges[i] = (up + down) * frame[i];
  }
  return box;
}

Box make_box(const Vec3& point, const Frame& frame, const Extents& extents, double factor, const Placement& placement) {
  if (!placement.frame) return make_aabb(point, extents, factor, placement.is_lattice);
  return make_obb(point, frame, extents, factor, placement.is_lattice);
}

void shift(Box& box, int axis, double step) {
  if (auto* const aabb = std::get_if<kernel::Aabb>(&box)) {
    aabb->min[axis] += step;
    aabb->max[axis] += step;
  } else {
    std::get<kernel::Obb>(box).center[axis] += step;
  }
}

/// Moves the box away from the positive side of `normal`. The step is one unit on a lattice. Otherwise it is at most `size`,
/// or at most 1e-5 of `size`.
void push_out(Random& random, Box& box, const Vec3& normal, double size, bool is_lattice) {
  const int axis = main_axis(normal);
  const double part = random.chance(0.5) ? random.real(0, 1) : 1e-5 * random.real(0, 1);
  shift(box, axis, (normal[axis] > 0 ? -1 : 1) * (is_lattice ? 1.0 : size * part));
}

Frame frame_of(Random& random, const Placement& placement, const Scene& scene, const Outline& outline) {
  return placement.frame ? make_frame(random, *placement.frame, scene, outline) : kUnitFrame;
}

/// A contact. On a lattice the scene is scaled up to make room for boxes of many integer sizes. Oriented boxes come in
/// coarser steps and need more room.
Contact make_roomy_contact(Random& random, Scene& scene, const Outline& outline, Feature feature,
                           const Placement& placement) {
  Contact contact = make_contact(random, scene, outline, feature, placement.is_lattice);
  if (!placement.is_lattice) return contact;
  const double factor = (random.chance(0.5) ? 8 : 64) * (placement.frame ? 8 : 1);
  for (Vec3& vertex : scene.vertices) vertex = factor * vertex;
  if (scene.viewpoint.is_eye()) scene.viewpoint.value = factor * scene.viewpoint.value;
  contact.point = factor * contact.point;
  return contact;
}

/// A supporting plane in which an edge of the box, along `axis`, crosses an edge of the frustum.
struct Crossing {
  Vec3 normal;
  std::size_t axis;
};

std::optional<Crossing> find_crossing(Random& random, const std::vector<Vec3>& normals, const Frame& frame) {
  constexpr int kTries = 8;
  for (int i = 0; i < kTries && !normals.empty(); ++i) {
    const Vec3 &n = normals[random.index(normals.size())], &m = normals[random.index(normals.size())];
    const std::size_t axis = random.index(3);
    if (const auto normal = normal_across(n, m, frame[axis])) return Crossing{*normal, axis};
  }
  return std::nullopt;
}

/// Extents on the negative side of the crossing's plane, and both ways along its axis.
Extents extents_across(Random& random, const Frame& frame, const Crossing& crossing) {
  Extents extents;
  for (std::size_t i = 0; i < 3; ++i) {
    if (frame[i] == Vec3{}) continue;
    const double down = random_extent(random, frame[i]), up = random_extent(random, frame[i]);
    const double rise = i == crossing.axis ? 0 : dot(crossing.normal, frame[i]);
    if (rise >= 0) extents.down[i] = down;
    if (rise <= 0) extents.up[i] = up;
  }
  return extents;
}

void snap_to_vertex(Random& random, kernel::Aabb& box, const Vec3& vertex) {
  const int axis = random.integer(0, 2);
  (vertex[axis] < box.min[axis] || random.chance(0.3) ? box.min : box.max)[axis] = vertex[axis];
  if (box.min[axis] > box.max[axis]) std::swap(box.min[axis], box.max[axis]);
}

}  // namespace

Box place_box(Random& random, Scene& scene, const Placement& placement) {
  const Outline outline = outline_of(scene);
  const Frame frame = frame_of(random, placement, scene, outline);
  const Intent intent = random_intent(random);
  Feature feature = resolve(random, placement.feature);
  const bool is_outer = intent == Intent::touching || intent == Intent::apart;
  if (is_outer && feature == Feature::interior) feature = Feature::face;
  const Contact contact = make_roomy_contact(random, scene, outline, feature, placement);
  const double size = size_of(scene, contact.point);

  const Vec3 support = contact.normals.empty() ? Vec3{} : supporting_normal(random, contact.normals, frame);
  Extents extents = random_extents(random, frame, is_outer ? std::vector<Vec3>{-1.0 * support} : contact.normals);
  flatten(random, extents, placement.flat_axes);
  double factor = size * random.real(0.01, 1);
  if (!is_outer) {
    factor = std::min(size, room_for(sketch(scene, outline), contact.point, frame, extents)) * random.real(0.3, 1);
    if (intent == Intent::poking && contact.normals.empty()) factor *= 4;
  }
  Box box = make_box(contact.point, frame, extents, factor, placement);
  if (intent == Intent::apart || intent == Intent::poking) {
    push_out(random, box, support, is_outer ? size : 0.2 * factor, placement.is_lattice);
  }
  return box;
}

Box place_box_for_other_near(Random& random, Scene& scene, const Placement& placement) {
  const Near asked = scene.near;
  if (random.chance(0.4)) scene.near = asked == Near::farthest ? Near::surface : Near::farthest;
  Box box = place_box(random, scene, placement);
  scene.near = asked;
  return box;
}

Box place_box_across(Random& random, Scene& scene, const Placement& placement) {
  const Outline outline = outline_of(scene);
  const Scene unscaled = scene;
  constexpr int kTries = 8;  // other edges are tried when no axis of the box crosses this one
  for (int i = 0; i < kTries; ++i) {
    scene = unscaled;
    const Frame frame = frame_of(random, placement, scene, outline);
    const Contact contact = make_roomy_contact(random, scene, outline, resolve(random, placement.feature), placement);
    const auto crossing = find_crossing(random, contact.normals, frame);
    if (!crossing) continue;
    const double size = size_of(scene, contact.point);
    const Extents extents = extents_across(random, frame, *crossing);
    Box box = make_box(contact.point, frame, extents, size * random.real(0.1, 1), placement);
    const int axis = main_axis(crossing->normal), steps = random.integer(-1, 1);
    const double step = placement.is_lattice ? 1.0 : 1e-5 * random.real(0, 1) * size;
    shift(box, axis, steps * (crossing->normal[axis] > 0 ? step : -step));
    return box;
  }
  scene = unscaled;
  return place_box(random, scene, placement);
}

Box place_box_at_vertices(Random& random, Scene& scene, const Placement& placement) {
  auto box = std::get<kernel::Aabb>(place_box(random, scene, placement));
  if (random.chance(0.5)) snap_to_vertex(random, box, scene.vertices[random.index(scene.vertices.size())]);
  return box;
}

Box place_box_about_eye(Random& random, Scene& scene, const Placement& placement) {
  const Outline outline = outline_of(scene);
  const Frame frame = frame_of(random, placement, scene, outline);
  const auto part = [&] { return random.real(0, 1); };
  Extents extents;
  for (double& down : extents.down) down = part();
  for (double& up : extents.up) up = part();
  const double room = placement.frame ? 64 : 8;
  for (Vec3& vertex : scene.vertices) vertex = room * vertex;
  scene.viewpoint.value = room * scene.viewpoint.value;
  const SketchPlane near = sketch(scene, outline).back();
  double reach = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double n = dot(near.normal, frame[i]);
    reach += std::max(n * extents.up[i], -n * extents.down[i]);
  }
  const double factor = -near.height(scene.viewpoint.value) / reach * random.real(0.3, 3);
  return make_box(scene.viewpoint.value, frame, extents, factor, placement);
}

}  // namespace occlude::fuzz
