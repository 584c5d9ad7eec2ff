// SPDX-License-Identifier: MIT
#include "small_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <variant>
#include <vector>

#include "any_case.h"

namespace occlude::fuzz {
namespace {

using culler::Camera;
using culler::PolygonSoup;
using culler::SoupView;
using glm::dvec3;

void add_loop(PolygonSoup& soup, const std::vector<dvec3>& loop) {
  std::vector<std::uint32_t> indices;
  for (const dvec3& v : loop) indices.push_back(soup.add_vertex(v));
  soup.add_polygon(indices);
}

/// A loop of four vertices as one polygon, or as the two triangles of its fan.
void add_quadrilateral(PolygonSoup& soup, const std::array<dvec3, 4>& loop, bool is_whole) {
  if (is_whole) return add_loop(soup, {loop.begin(), loop.end()});
  add_loop(soup, {loop[0], loop[1], loop[2]});
  add_loop(soup, {loop[0], loop[2], loop[3]});
}

/// A rectangle along two axes with sides up to `size`. It may be two triangles, flat or bent so little that they pass for
/// flat.
void add_wall(Random& random, PolygonSoup& soup, int reach, int size) {
  const int axis = random.integer(0, 2);
  dvec3 along{}, across{};
  along[(axis + 1) % 3] = random.integer(1, size);
  across[(axis + 2) % 3] = random.integer(1, size);
  const dvec3 corner = lattice_point(random, reach), opposite = corner + along + across;
  const bool is_whole = random.chance(0.5);
  dvec3 last = corner + across;
  if (!is_whole && random.chance(0.5)) last[axis] += random.integer(-2, 2) * 0x1p-13;
  add_quadrilateral(soup, {corner, corner + along, opposite, last}, is_whole);
}

/// A closed box, upright or skew, with edges up to `size` and 6 or 12 faces, or only some of its faces, which meet in edges.
/// A wall may continue from one of its edges.
void add_block(Random& random, PolygonSoup& soup, int reach, int size) {
  const auto side = [&] { return static_cast<double>(random.integer(1, size)); };
  const dvec3 x{side(), 0, 0}, y{0, side(), 0};
  dvec3 z{0, 0, side()};
  if (random.chance(0.3)) z += dvec3{random.integer(-2, 2), random.integer(-2, 2), 0};
  const dvec3 low = lattice_point(random, reach), high = low + x + y + z;
  const bool is_whole = random.chance(0.5);
  const double kept = random.chance(0.6) ? 1 : 0.6;
  for (const auto& [a, b] : std::array{std::pair{x, y}, std::pair{y, z}, std::pair{z, x}}) {
    if (random.chance(kept)) add_quadrilateral(soup, {low, low + b, low + a + b, low + a}, is_whole);
    if (random.chance(kept)) add_quadrilateral(soup, {high, high - a, high - a - b, high - b}, is_whole);
  }
  if (random.chance(0.5)) return;
  // The wall has an extra vertex on the edge, because an edge that three polygons share does not belong to a closed box.
  const dvec3 away = lattice_point(random, size);
  add_loop(soup, {high, high - 0.5 * z, high - z, high - z + away, high + away});
}

void add_triangle(Random& random, PolygonSoup& soup, int reach) {
  add_loop(soup, {lattice_point(random, reach), lattice_point(random, reach), lattice_point(random, reach)});
}

/// A quadrilateral parallel to a polygon and half as large, on its middle. It is moved by at most 2^-17 along an axis, so it
/// lies in front of the polygon, behind it or in its plane.
void add_poster(Random& random, PolygonSoup& soup) {
  const auto loop = soup.loop(random.index(soup.size()));
  const dvec3 a = soup.vertices[loop[0]], b = soup.vertices[loop[1]], c = soup.vertices[loop[2]];
  const dvec3 along = 0.5 * (b - a), across = 0.5 * (c - b);
  dvec3 corner = a + 0.5 * along + 0.5 * across;
  corner[random.integer(0, 2)] += random.integer(-2, 2) * 0x1p-18;
  add_quadrilateral(soup, {corner, corner + along, corner + along + across, corner + across}, random.chance(0.5));
}

/// A loop with random corners in a plane along two axes. Its fan may fold over.
void add_folded(Random& random, PolygonSoup& soup, int reach, int size) {
  const int axis = random.integer(0, 2);
  const dvec3 middle = lattice_point(random, reach);
  std::vector<dvec3> loop;
  for (int corners = random.integer(4, 9); corners > 0; --corners) {
    dvec3 offset = lattice_point(random, size);
    offset[axis] = 0;
    loop.push_back(middle + offset);
  }
  add_loop(soup, loop);
}

/// The largest power of two that is at most x.
double power_below(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, exponent - 1);
}

/// The occluder of any case, scaled to the scene. It may have any number of sides, be a sliver or be folded.
void add_occluder_of_case(Random& random, PolygonSoup& soup, int reach) {
  const Case c = any_case(random);
  const auto* const polygon = std::get_if<Polygon>(&c.occluder);
  if (!polygon) return add_triangle(random, soup, reach);
  double largest = 0;
  for (const kernel::Vec3& v : *polygon) largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  const double scale = largest == 0 ? 1 : power_below(reach / largest);
  std::vector<dvec3> loop;
  for (const kernel::Vec3& v : *polygon) {
    if (kernel::check(kernel::Vec3{scale * v.x, scale * v.y, scale * v.z}) != kernel::Refusal::none) return;
    loop.push_back(scale * dvec3{v.x, v.y, v.z});
  }
  add_loop(soup, loop);
}

}  // namespace

dvec3 lattice_point(Random& random, int reach) {
  const auto coordinate = [&] { return static_cast<double>(random.integer(-reach, reach)); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

PolygonSoup some_soup(Random& random) {
  PolygonSoup soup;
  for (int walls = random.integer(1, 4); walls > 0; --walls) {
    const auto add_large = random.chance(0.6) ? add_wall : random.chance(0.7) ? add_block : add_folded;
    add_large(random, soup, kReach / 2, kReach);
  }
  for (int things = random.integer(15, 30); things > 0; --things) {
    (random.chance(0.95) ? add_wall : add_block)(random, soup, 2 * kReach, 2);
  }
  for (int posters = random.integer(0, 4); posters > 0; --posters) add_poster(random, soup);
  for (int others = random.integer(0, 4); others > 0; --others) {
    (random.chance(0.5) ? add_triangle : add_occluder_of_case)(random, soup, kReach);
  }
  if (random.chance(0.2)) {  // far from the origin, where coordinates round
    const dvec3 away = 1e6 * lattice_point(random, 9) + dvec3{0.1, 0.2, 0.3};
    for (dvec3& v : soup.vertices) v += away;
  }
  return soup;
}

Camera some_camera(Random& random, SoupView soup) {
  const auto some_vertex = [&] { return soup.vertices[random.index(soup.vertices.size())]; };
  Camera camera;
  const dvec3 corner_of_first_wall = soup.vertices[0];
  const dvec3 away = lattice_point(random, kReach / 2);
  camera.eye = (random.chance(0.7) ? corner_of_first_wall : some_vertex()) + away;
  camera.target = random.chance(0.7) ? 0.5 * (corner_of_first_wall + soup.vertices[2]) : some_vertex();
  camera.up = random.chance(0.5) ? dvec3{0, 0, 1} : dvec3{0.3, 1, 0.2};
  camera.fov_y_deg = std::array{60.0, 90.0, 20.0, 150.0}[random.index(4)];
  camera.height = random.integer(1, 4 * kReach);
  camera.aspect = random.chance(0.5) ? 1 : 16.0 / 9;
  camera.near_plane = std::array{0.1, 1.0, 3.0}[random.index(3)];
  if (random.chance(0.3)) camera.projection = culler::Projection::orthographic;
  if (random.chance(0.3)) camera.far_plane = camera.near_plane + random.integer(1, 2 * kReach);
  return camera;
}

culler::MatrixCamera matrix_of(Random& random, const Camera& camera) {
  const auto [right, up, forward] = camera.axes();
  const bool is_perspective = camera.projection == culler::Projection::perspective;
  const double half = is_perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2;
  const auto row = [&](const dvec3& axis, double scale) {
    return glm::dvec4(axis * scale, -glm::dot(axis, camera.eye) * scale);
  };
  const glm::dvec4 along = row(forward, 1), one(0, 0, 0, 1);
  const bool is_reversed = random.chance(0.5), is_zero_to_w = random.chance(0.5), has_far = std::isfinite(camera.far_plane);
  // The depth is 0 at the near plane and w at the far plane, or the other way round.
  const double near = camera.near_plane, far = camera.far_plane;
  glm::dvec4 depth = along - near * one;
  if (is_perspective && has_far) depth = far / (far - near) * depth;
  if (!is_perspective) depth = (has_far ? 1 / (far - near) : 0x1p-20) * depth;
  const glm::dvec4 w = is_perspective ? along : one;
  if (is_reversed) depth = w - depth;
  if (!is_zero_to_w) depth = 2.0 * depth - w;
  const std::array rows{row(right, 1 / (half * camera.aspect)), row(up, 1 / half), depth, w};
  std::array<double, 16> numbers{};
  const double scale = std::ldexp(1.0, random.integer(-8, 8));
  for (std::size_t i = 0; i < 16; ++i) numbers[i] = scale * rows[i / 4][static_cast<int>(i % 4)];
  return culler::MatrixCamera::from_rows(numbers.data(),
                                         is_zero_to_w ? culler::ClipDepth::zero_to_w : culler::ClipDepth::minus_w_to_w,
                                         is_reversed ? culler::Nearer::greater : culler::Nearer::less);
}

}  // namespace occlude::fuzz
