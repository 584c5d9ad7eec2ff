// SPDX-License-Identifier: MIT
// Looks for what visible sets wrongly leave out: rays from eyes in each cell to points of what is not in its set, to points
// of cells that are not in its set, and in random directions, that nothing stops. Whether one is clear is decided exactly.
// Also counts what random rays find. Usage: bake_rays MODEL FILE RAYS_OF_A_CELL CELLS [SEED]. Polygon by polygon: the sets
// are of no objects.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../culler/example/visible_sets.h"
#include "exact_rays.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/render/model_io.h"

namespace {

using glm::dvec3;
using occlude::culler::Hierarchy;
using occlude::oracle::Triangle;
using occlude::render::TreeRays;

constexpr std::uint32_t kNone = visible_sets::kNone;

struct Meeting {
  std::uint32_t polygon = kNone;
  double share = std::numeric_limits<double>::infinity();  ///< of the ray
};

/// The opaque polygon that a ray seems to meet first, if any.
Meeting first_met(const TreeRays& rays, const dvec3& eye, const dvec3& along) {
  Meeting nearest;
  rays.visit(eye, along, nearest.share, [&](std::uint32_t p) {
    const double share = rays.meeting(eye, along, std::numeric_limits<double>::min(), p);
    if (share < nearest.share) nearest = {p, share};
  });
  return nearest;
}

std::vector<Triangle> triangles_of(const Hierarchy& tree, std::uint32_t p) {
  std::vector<Triangle> triangles;
  occlude::proof::for_each_triangle(tree.soup(), p, [&](const Triangle& triangle) { triangles.push_back(triangle); });
  return triangles;
}

/// A triangle across the segment that meets it at its end alone.
Triangle target_at(const dvec3& end, const dvec3& along) {
  const dvec3 size = glm::abs(along);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto corner = [&](double u, double v) {
    dvec3 at = end;
    at[(axis + 1) % 3] += u;
    at[(axis + 2) % 3] += v;
    return occlude::oracle::Point{at.x, at.y, at.z};
  };
  return {corner(-1, -1), corner(2, -1), corner(-1, 2)};
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 5) return std::cerr << "usage: bake_rays MODEL FILE RAYS CELLS [SEED]\n", 2;
  const auto tree = Hierarchy::build(occlude::render::read_model(argv[1]).soup, {.leaf_size = 2});
  std::ifstream file(argv[2], std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  const visible_sets::Reader sets(bytes.data(), bytes.size());
  const auto count = std::strtoull(argv[3], nullptr, 10);
  const auto most = std::strtoull(argv[4], nullptr, 10);
  const auto seed = argc > 5 ? std::strtoull(argv[5], nullptr, 10) : std::random_device{}();
  const TreeRays rays(tree);
  std::mt19937_64 random(seed);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::map<std::string, int> told;
  std::size_t wrong = 0, aimed = 0, found = 0, in_sets = 0, asked = 0;
  for (visible_sets::Number i = 0; i < std::min<std::size_t>(sets.cells(), most); ++i, ++asked) {
    const auto cell = static_cast<visible_sets::Number>(most < sets.cells() ? i * std::size_t{sets.cells()} / most : i);
    const auto box = sets.box(cell);
    const std::vector<bool> seen = sets.visible(cell);
    std::vector<bool> met(seen.size());
    std::vector<std::uint32_t> hidden;
    for (std::uint32_t p = 0; p < tree.soup().size(); ++p) {
      if (!seen[tree.face(p)]) hidden.push_back(p);
    }
    for (const bool is_seen : seen) in_sets += is_seen;
    std::vector<visible_sets::Number> hidden_cells;
    const std::vector<bool> seen_cells = sets.visible_cells(cell);
    for (visible_sets::Number other = 0; other < sets.cells(); ++other) {
      if (!seen_cells[other]) hidden_cells.push_back(other);
      if (sets.visible(cell, other) != seen_cells[other]) throw std::logic_error("one cell is not as in the set");
    }
    const auto claim = [&](const dvec3& eye, const dvec3& point, const Triangle& aim, const char* what,
                           std::uint32_t number) {
      if (!is_clear(tree, rays, eye, point, aim)) return;
      if (++wrong; ++told[what] > 20) return;
      std::cout << "cell " << cell << " sees " << what << ' ' << number << " from " << eye.x << ' ' << eye.y << ' ' << eye.z
                << " at " << point.x << ' ' << point.y << ' ' << point.z << '\n';
    };
    const auto point_in = [&](const std::array<double, 6>& in, bool is_corner) {
      dvec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        const double at = is_corner ? static_cast<double>(random() & 1U) : share();
        point[axis] = at == 1 ? in[axis + 3U] : std::min(in[axis] + at * (in[axis + 3U] - in[axis]), in[axis + 3U]);
      }
      return point;
    };
    for (std::size_t ray = 0; ray < count; ++ray) {
      const dvec3 eye = point_in(box, ray % 4 == 0);
      if (!hidden_cells.empty()) {
        const visible_sets::Number other = hidden_cells[random() % hidden_cells.size()];
        const dvec3 point = point_in(sets.box(other), ray % 8 < 2);
        if (point != eye && !(first_met(rays, eye, point - eye).share < 1)) {
          claim(eye, point, target_at(point, point - eye), "cell", other);
        }
      }
      if (ray % 2 == 0 && !hidden.empty()) {
        const std::uint32_t p = hidden[random() % hidden.size()];
        const std::vector<Triangle> triangles = triangles_of(tree, p);
        const Triangle& t = triangles[random() % triangles.size()];
        double u = share(), v = share();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        dvec3 point;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          point[static_cast<int>(axis)] = t[0][axis] + u * (t[1][axis] - t[0][axis]) + v * (t[2][axis] - t[0][axis]);
        }
        ++aimed;
        // In most cases what hides it is itself seen. What is behind it does not hide it.
        const Meeting first = first_met(rays, eye, point - eye);
        if (first.share < 1 && seen[tree.face(first.polygon)]) continue;
        claim(eye, point, t, "polygon", tree.face(p));
      } else {
        dvec3 along;
        do along = {share() - 0.5, share() - 0.5, share() - 0.5};
        while (glm::length(along) > 0.5);
        const std::uint32_t p = first_met(rays, eye, along).polygon;
        if (p == kNone) continue;
        met[tree.face(p)] = true;
        if (seen[tree.face(p)]) continue;
        for (const Triangle& triangle : triangles_of(tree, p)) claim(eye, eye + along, triangle, "polygon", tree.face(p));
      }
    }
    for (const bool is_met : met) found += is_met;
  }
  const auto mean = [&](std::size_t sum) {
    return static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(asked, 1));
  };
  std::cout << "seed " << seed << ": " << asked << " cells, " << asked * count << " rays, " << aimed << " of them aimed; "
            << wrong << " reach what is in no set; of " << mean(in_sets) << " in a set random rays find " << mean(found)
            << '\n';
  return wrong == 0 ? 0 : 1;
} catch (const std::exception& error) {
  return std::cerr << error.what() << '\n', 2;
}
