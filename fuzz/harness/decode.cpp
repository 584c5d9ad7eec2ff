// SPDX-License-Identifier: MIT
#include "decode.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "solids.h"
#include "vector_math.h"

namespace occlude::harness {

using fuzz::operator+;
using fuzz::operator-;
using fuzz::operator*;
using fuzz::Polygon;
using kernel::Polytope;
using kernel::Vec3;
using kernel::Viewpoint;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A point of the plane with integer coordinates.
struct Place {
  int a, b;
  friend auto operator<=>(const Place&, const Place&) = default;
};

int turn(const Place& o, const Place& p, const Place& q) { return (p.a - o.a) * (q.b - o.b) - (p.b - o.b) * (q.a - o.a); }

/// The corners of the hull, by Andrew's monotone chain. All the points when they are collinear.
std::vector<Place> corners_of_hull(std::vector<Place> places) {
  std::ranges::sort(places);
  std::vector<Place> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const Place& p : places) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(places);
  }
  return hull.size() < 3 ? places : hull;
}

}  // namespace

Decoder::Decoder(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
  const int scale = static_cast<std::int8_t>(byte());
  // From 2^-90 to 2^90. The grids below then stay in the legal range or barely leave it.
  unit_ = std::abs(scale) <= 30 ? 1 : std::ldexp(1, std::clamp(scale, -90, 90));
}

std::uint8_t Decoder::byte() {
  if (bytes_.empty()) return 0;
  const std::uint8_t first = bytes_.front();
  bytes_ = bytes_.subspan(1);
  return first;
}

double Decoder::used_number() { return numbers_.empty() ? 0 : numbers_[below(numbers_.size())]; }

double Decoder::any_double() {
  std::uint64_t bits = 0;
  for (int i = 0; i < 8; ++i) bits = bits << 8U | byte();
  return std::bit_cast<double>(bits);
}

double Decoder::fresh_number() {
  const std::uint8_t how = byte();
  if (how == 0xff) return any_double();
  if (how == 0xfe) return unit_ * std::ldexp(1, static_cast<std::int8_t>(byte()));
  if (how >= 0xf0) return -used_number();
  if (how >= 0xe0) {
    const double from = used_number();
    return from + unit_ * static_cast<double>(below(9));
  }
  if (how >= 0xd0) return std::nextafter(used_number(), how % 2 == 0 ? kInfinity : -kInfinity);
  if (how >= 0xb0) return used_number();
  const double whole = static_cast<std::int8_t>(byte());
  if (how >= 0xa0) return unit_ * whole / 3;
  if (how >= 0x90) return unit_ * whole * 0.1;
  if (how >= 0x80) return unit_ * whole;
  return unit_ * (std::fmod(whole, 9));
}

double Decoder::number() {
  const double result = fresh_number();
  if (numbers_.size() < 256) numbers_.push_back(result);
  return result;
}

const Vec3& Decoder::used_point() { return points_[below(points_.size())]; }

/// A vector of small integers, in units of the scene.
Vec3 Decoder::step() {
  const auto small = [&] { return unit_ * std::fmod(static_cast<std::int8_t>(byte()), 5); };
  const double x = small(), y = small();
  return {x, y, small()};
}

Vec3 Decoder::made_point() {
  const std::size_t how = below(8);
  if (points_.empty() || how < 3) {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  if (how == 3) return used_point();
  if (how == 4) {
    const Vec3 from = used_point();
    return from + step();
  }
  if (how == 5) {
    constexpr std::array<double, 8> kAlong = {2, 0.5, 3, -1, 4, 1.5, 1.0 / 3, -2};
    const Vec3 from = used_point(), to = used_point();
    return from + kAlong[below(kAlong.size())] * (to - from);
  }
  if (how == 6) {
    Vec3 v = used_point();
    const std::size_t way = below(6);
    double& coordinate = v[static_cast<int>(way / 2)];
    coordinate = std::nextafter(coordinate, way % 2 == 0 ? kInfinity : -kInfinity);
    return v;
  }
  const double x = used_point().x, y = used_point().y;
  return {x, y, used_point().z};
}

Vec3 Decoder::point() {
  const Vec3 result = made_point();
  use({result});
  return result;
}

/// Keeps some of the points. There are at most 256, so one byte reaches all that are kept.
void Decoder::use(const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < std::min<std::size_t>(points.size(), 16) && points_.size() < 256; ++i) {
    points_.push_back(points[i]);
  }
}

Viewpoint Decoder::viewpoint() {
  const bool is_eye = below(3) != 2;
  const Vec3 value = point();
  return is_eye ? Viewpoint::eye(value) : Viewpoint::direction(value);
}

Polygon Decoder::plane_polygon() {
  const Vec3 origin = point(), across = step(), up = step();
  std::vector<Place> places;
  if (const std::uint8_t how = byte(); how >= 0xf8) {
    const int count = 13 + byte() % 58;
    for (int i = 0; i < count; ++i) places.push_back({i - count / 2, (i - count / 2) * (i - count / 2)});
  } else {
    for (std::size_t i = 0; i < 3U + how % 10; ++i) {
      const std::uint8_t place = byte();
      places.push_back({place % 16 - 8, place / 16 - 8});
    }
    places = corners_of_hull(std::move(places));
  }
  Polygon polygon;
  for (const Place& p : places) polygon.push_back(origin + double(p.a) * across + double(p.b) * up);
  return polygon;
}

Polygon Decoder::free_polygon() {
  const std::size_t count = below(14);
  Polygon polygon;
  for (std::size_t i = 0; i < count; ++i) polygon.push_back(point());
  return polygon;
}

/// Writes the same loop in another way. Most ways are as legal as before.
void Decoder::rewrite(Polygon& polygon) {
  const std::uint8_t how = byte();
  if (polygon.empty() || how < 0x80) return;
  const std::size_t at = below(polygon.size());
  const auto place = polygon.begin() + static_cast<std::ptrdiff_t>(at);
  const Vec3 &corner = polygon[at], &next = polygon[(at + 1) % polygon.size()];
  if (how >= 0xe0) {
    std::rotate(polygon.begin(), place, polygon.end());
  } else if (how >= 0xc0) {
    std::ranges::reverse(polygon);
  } else if (how >= 0xa0) {
    polygon.insert(place, Vec3(corner));
  } else if (how >= 0x90) {
    polygon.insert(place + 1, 0.5 * (corner + next));
  } else {
    *place = point();
  }
}

Polygon Decoder::polygon(const Viewpoint& viewpoint) {
  const std::size_t kind = below(4);
  Polygon result = kind == 3 ? free_polygon() : plane_polygon();
  if (kind == 2) {
    for (Vec3& v : result) v = v + double(below(3)) * (viewpoint.is_eye() ? v - viewpoint.value : viewpoint.value);
  }
  rewrite(result);
  use(result);
  return result;
}

Polytope Decoder::solid(const Viewpoint& viewpoint) {
  switch (below(4)) {
    case 0: {
      const Vec3 corner = point(), a = step(), b = step();
      auto [vertices, faces] = fuzz::parallelepiped(corner, {a, b, step()});
      return {std::move(vertices), std::move(faces)};
    }
    case 1: {
      const Polygon base = plane_polygon();
      auto [vertices, faces] = fuzz::prism(base, step());
      return {std::move(vertices), std::move(faces)};
    }
    case 2: {
      Polygon base = polygon(viewpoint);
      if (base.size() < 3) base = plane_polygon();
      auto [vertices, faces] = fuzz::pyramid(base, point());
      return {std::move(vertices), std::move(faces)};
    }
    default: {
      const Vec3 origin = point();
      std::vector<Vec3> points;
      for (std::size_t i = 0, count = 4 + below(5); i < count; ++i) points.push_back(step());
      auto [vertices, faces] = fuzz::hull(points);
      for (Vec3& v : vertices) v = origin + v;
      return {std::move(vertices), std::move(faces)};
    }
  }
}

Polytope Decoder::free_faces() {
  Polytope result;
  for (std::size_t i = 0, count = below(9); i < count; ++i) result.vertices.push_back(point());
  for (std::size_t f = 0, count = below(9); f < count; ++f) {
    auto& face = result.faces.emplace_back();
    for (std::size_t i = 0, corners = below(7); i < corners; ++i) {
      face.push_back(static_cast<std::uint32_t>(below(result.vertices.size() + 1)));
    }
  }
  return result;
}

void Decoder::rewrite(Polytope& polytope) {
  for (std::size_t changes = below(4); changes-- > 0 && !polytope.faces.empty();) {
    const std::size_t at = below(polytope.faces.size());
    auto& face = polytope.faces[at];
    const std::size_t how = below(8);
    if (how < 3) {
      std::ranges::reverse(face);
    } else if (how < 5 && !face.empty()) {
      std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(below(face.size())), face.end());
    } else if (how == 5 && !face.empty()) {
      face.insert(face.begin(), face.front());
    } else if (how == 6 && !polytope.vertices.empty()) {
      polytope.vertices[below(polytope.vertices.size())] = point();
    } else if (flag()) {
      polytope.faces.erase(polytope.faces.begin() + static_cast<std::ptrdiff_t>(at));
    } else {
      polytope.faces.emplace_back(face);
    }
  }
}

Polytope Decoder::polytope(const Viewpoint& viewpoint) {
  Polytope result = below(8) == 7 ? free_faces() : solid(viewpoint);
  rewrite(result);
  use(result.vertices);
  return result;
}

kernel::Aabb Decoder::aabb() {
  const std::size_t how = below(16);
  const Vec3 a = point();
  const Vec3 b = how < 8 ? point() : a + step();
  kernel::Aabb box{a, b};
  if (how == 15) return box;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] > box.max[axis]) std::swap(box.min[axis], box.max[axis]);
  }
  return box;
}

kernel::Obb Decoder::obb() {
  kernel::Obb box{point(), {}};
  for (Vec3& half_edge : box.half_edges) {
    const std::size_t how = below(4);
    if (how < 2 || points_.empty()) {
      half_edge = step();
    } else if (how == 2) {
      const Vec3 from = used_point();
      half_edge = 0.5 * (used_point() - from);
    }
  }
  return box;
}

fuzz::Box Decoder::box() {
  if (below(3) == 2) return obb();
  return aabb();
}

fuzz::Case Decoder::question() {
  fuzz::Case result{viewpoint(), Polygon{}, flag() ? fuzz::Near::surface : fuzz::Near::farthest, kernel::Aabb{}};
  if (below(3) == 2) {
    result.occluder = polytope(result.viewpoint);
  } else {
    result.occluder = polygon(result.viewpoint);
  }
  return result;
}

}  // namespace occlude::harness
