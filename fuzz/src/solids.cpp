// SPDX-License-Identifier: MIT
#include "solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "lattice.h"

namespace occlude::fuzz {
namespace {

Vec3 mean(const std::vector<Vec3>& points) {
  Vec3 sum;
  for (const Vec3& p : points) sum = sum + p;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

/// Turns every face counter-clockwise seen from outside. The first three corners of a face may be collinear, so the normal
/// is summed over the fan.
Solid turned_outwards(Solid solid) {
  const Vec3 within = mean(solid.vertices);
  for (Loop& face : solid.faces) {
    Vec3 normal;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Vec3& first = solid.vertices[face[0]];
      normal = normal + cross(solid.vertices[face[i]] - first, solid.vertices[face[i + 1]] - first);
    }
    if (dot(normal, solid.vertices[face[0]] - within) < 0) std::ranges::reverse(face);
  }
  return solid;
}

Loop counting_from(std::uint32_t first, std::uint32_t count) {
  Loop loop;
  for (std::uint32_t i = 0; i < count; ++i) loop.push_back(first + i);
  return loop;
}

std::uint32_t size32(const std::vector<Vec3>& points) { return static_cast<std::uint32_t>(points.size()); }

/// The solid between two polygons, vertex to vertex.
Solid between(const std::vector<Vec3>& bottom, const std::vector<Vec3>& top) {
  const std::uint32_t n = size32(bottom);
  Solid solid{bottom, {counting_from(0, n), counting_from(n, n)}};
  solid.vertices.insert(solid.vertices.end(), top.begin(), top.end());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    solid.faces.push_back({i, next, n + next, n + i});
  }
  return turned_outwards(std::move(solid));
}

void add_apex(Solid& solid, std::uint32_t base_size, const Vec3& apex) {
  const std::uint32_t index = size32(solid.vertices);
  solid.vertices.push_back(apex);
  for (std::uint32_t i = 0; i < base_size; ++i) solid.faces.push_back({i, (i + 1) % base_size, index});
}

std::vector<Vec3> scaled(double factor, std::vector<Vec3> points) {
  for (Vec3& p : points) p = factor * p;
  return points;
}

/// Four times a point in the interior of the polygon.
Vec3 interior_point(const std::vector<Vec3>& base) {
  // The point is in the interior of a triangle that has an area.
  for (std::size_t i = 2; i < base.size(); ++i) {
    if (cross(base[1] - base[0], base[i] - base[0]) != Vec3{}) return base[0] + 2.0 * base[1] + base[i];
  }
  return 4.0 * base[0];
}

/// A prism, a pyramid, a truncated pyramid or a bipyramid.
Solid solid_over(Random& random, const std::vector<Vec3>& base) {
  const Vec3 way = way_off(random, base, 5);
  switch (random.integer(0, 3)) {
    case 0:
      return prism(base, way);
    case 1:
      return pyramid(base, base[random.index(base.size())] + way);
    case 2:
      return truncated_pyramid(base, base[random.index(base.size())] + 2.0 * way);
    default: {
      const Vec3 middle = interior_point(base);
      const double up = random.integer(1, 6), down = random.integer(1, 6);
      return bipyramid(scaled(4, base), middle + up * way, middle - down * way);
    }
  }
}

std::vector<Vec3> lattice_points(Random& random, int count) {
  const Vec3 centre = lattice_vector(random, 4);
  const int reach = random.integer(1, 4);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(centre + lattice_vector(random, reach));
  return points;
}

/// A plane through three of the points with all points on one side.
struct Support {
  Vec3 normal;                 ///< outwards
  std::uint32_t on_plane = 0;  ///< bit r is set when point r lies on the plane
};

/// The plane through points i, j and k, if it is a supporting plane.
std::optional<Support> support_through(const std::vector<Vec3>& points, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  Support support{cross(points[j] - points[i], points[k] - points[i])};
  if (support.normal == Vec3{}) return std::nullopt;
  bool has_above = false, has_below = false;
  for (std::uint32_t r = 0; r < points.size(); ++r) {
    const double height = r == i || r == j || r == k ? 0 : dot(support.normal, points[r] - points[i]);
    if (height == 0) support.on_plane |= 1U << r;
    has_above |= height > 0;
    has_below |= height < 0;
    if (has_above && has_below) return std::nullopt;
  }
  if (!has_above && !has_below) return std::nullopt;
  if (has_above) support.normal = -1.0 * support.normal;
  return support;
}

/// The corners of the hull of the points on a supporting plane. Gift wrapping finds them counter-clockwise seen from
/// outside.
Loop wrap(const std::vector<Vec3>& points, const Support& support) {
  Loop on_plane;
  for (std::uint32_t r = 0; r < points.size(); ++r) {
    if ((support.on_plane >> r & 1U) != 0) on_plane.push_back(r);
  }
  const auto precedes = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = points[a], &q = points[b];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  };
  const std::uint32_t start = *std::ranges::min_element(on_plane, precedes);
  Loop loop;
  std::uint32_t at = start;
  do {
    loop.push_back(at);
    std::uint32_t next = at;
    for (const std::uint32_t r : on_plane) {
      if (r == at) continue;
      const Vec3 so_far = points[next] - points[at], candidate = points[r] - points[at];
      const double turn = dot(support.normal, cross(so_far, candidate));
      if (next == at || turn < 0 || (turn == 0 && dot(candidate, candidate) > dot(so_far, so_far))) next = r;
    }
    at = next;
  } while (at != start && loop.size() <= on_plane.size());
  return loop;
}

/// Drops the vertices that no face uses.
Solid without_unused(const Solid& solid) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> index(solid.vertices.size(), kUnused);
  Solid used;
  for (const Loop& face : solid.faces) {
    Loop& loop = used.faces.emplace_back();
    for (const std::uint32_t i : face) {
      if (index[i] == kUnused) {
        index[i] = size32(used.vertices);
        used.vertices.push_back(solid.vertices[i]);
      }
      loop.push_back(index[i]);
    }
  }
  return used;
}

std::vector<Vec3> distinct(const std::vector<Vec3>& points) {
  std::vector<Vec3> kept;
  for (const Vec3& p : points) {
    if (std::ranges::find(kept, p) == kept.end()) kept.push_back(p);
  }
  return kept;
}

Vec3 unit_vector(Random& random) {
  while (true) {
    const Vec3 v = random_vector(random, 1);
    const double square = dot(v, v);
    if (square > 0.01 && square < 1) return (1 / std::sqrt(square)) * v;
  }
}

}  // namespace

Solid hull(const std::vector<Vec3>& points) {
  Solid solid{distinct(points), {}};
  const std::uint32_t count = size32(solid.vertices);
  std::vector<std::uint32_t> seen;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t j = i + 1; j < count; ++j) {
      for (std::uint32_t k = j + 1; k < count; ++k) {
        const auto support = support_through(solid.vertices, i, j, k);
        if (!support || std::ranges::find(seen, support->on_plane) != seen.end()) continue;
        seen.push_back(support->on_plane);
        solid.faces.push_back(wrap(solid.vertices, *support));
      }
    }
  }
  return without_unused(solid);
}

Solid parallelepiped(const Vec3& corner, const Frame& edges) {
  const auto& [e, f, g] = edges;
  return prism({corner, corner + e, corner + e + f, corner + f}, g);
}

Solid prism(const std::vector<Vec3>& base, const Vec3& way) {
  std::vector<Vec3> top = base;
  for (Vec3& p : top) p = p + way;
  return between(base, top);
}

Solid truncated_pyramid(const std::vector<Vec3>& base, const Vec3& apex) {
  std::vector<Vec3> top = base;
  for (Vec3& p : top) p = p + apex;
  return between(scaled(2, base), top);
}

Solid pyramid(const std::vector<Vec3>& base, const Vec3& apex) {
  const std::uint32_t n = size32(base);
  Solid solid{base, {counting_from(0, n)}};
  add_apex(solid, n, apex);
  return turned_outwards(std::move(solid));
}

Solid bipyramid(const std::vector<Vec3>& base, const Vec3& apex, const Vec3& other_apex) {
  Solid solid{base, {}};
  add_apex(solid, size32(base), apex);
  add_apex(solid, size32(base), other_apex);
  return turned_outwards(std::move(solid));
}

Solid lattice_hull(Random& random, int most) {
  while (true) {
    Solid solid = hull(lattice_points(random, random.integer(4, most)));
    if (!solid.faces.empty()) return solid;
  }
}

Solid lattice_box(Random& random) {
  Frame edges = random.chance(0.5) ? kUnitFrame : lattice_frame(random);
  for (Vec3& edge : edges) edge = static_cast<double>(random.integer(1, 4)) * edge;
  return parallelepiped(lattice_vector(random, 4), edges);
}

Solid lattice_solid(Random& random) {
  const double u = random.real(0, 1);
  if (u < 0.25) return lattice_box(random);
  if (u < 0.5) return lattice_hull(random, 7);
  return solid_over(random, embed(random, few_edges(random)));
}

Solid many_sided_solid(Random& random) {
  const int sides = random.chance(0.5) ? random.integer(3, 12) : random.integer(13, 64);
  return solid_over(random, embed(random, lattice_edges(random, sides, sides < 13 ? 4 : 9)));
}

Solid simplicial_lattice_solid(Random& random) {
  while (true) {
    Solid solid = lattice_hull(random, 6);
    if (std::ranges::all_of(solid.faces, [](const Loop& face) { return face.size() == 3; })) return solid;
  }
}

Solid simplicial_solid(Random& random) {
  const Vec3 centre = random_vector(random, 5), e = random_vector(random, 5), f = random_vector(random, 5),
             g = random_vector(random, 5);
  while (true) {
    std::vector<Vec3> points;
    for (int count = random.integer(4, 8); count > 0; --count) {
      const Vec3 u = unit_vector(random);
      points.push_back(centre + u.x * e + u.y * f + u.z * g);
    }
    Solid solid = hull(points);
    if (!solid.faces.empty()) return solid;
  }
}

Vec3 way_off(Random& random, const std::vector<Vec3>& base, int reach) {
  const Vec3 normal = plane_normal(base);
  while (true) {
    const Vec3 way = lattice_vector(random, reach);
    if (dot(normal, way) != 0) return way;
  }
}

}  // namespace occlude::fuzz
