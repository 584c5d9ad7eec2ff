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
#include "occlude/culler/hierarchy.h"
#include "occlude/oracle/ray.h"
#include "occlude/render/model_io.h"

namespace {

using glm::dvec3;
using occlude::culler::Hierarchy;
using occlude::oracle::Ray;
using occlude::oracle::Triangle;

constexpr std::uint32_t kNone = visible_sets::kNone;
/// More than coordinates of points of rays are off by, as a share of the model.
constexpr double kRounding = 0x1p-40;

class Tracer {
 public:
  explicit Tracer(const Hierarchy& tree) : tree_(tree), room_(kRounding * extent(tree.nodes()[0].box)) {}

  [[nodiscard]] Triangle triangle(std::uint32_t p, std::size_t i) const {
    const auto loop = tree_.soup().loop(p);
    const auto corner = [&](std::size_t k) {
      const dvec3& v = tree_.soup().vertices[loop[k]];
      return occlude::oracle::Point{v.x, v.y, v.z};
    };
    return {corner(0), corner(i), corner(i + 1)};
  }
  [[nodiscard]] std::size_t triangles(std::uint32_t p) const { return tree_.soup().loop(p).size() - 2; }

  struct Meeting {
    std::uint32_t polygon = kNone;
    double share = std::numeric_limits<double>::infinity();  ///< of the ray
  };
  /// The opaque polygon that a ray seems to meet first, if any.
  [[nodiscard]] Meeting first(const dvec3& eye, const dvec3& along) const {
    Meeting nearest;
    visit(eye, along, nearest.share, [&](std::uint32_t p) {
      for (std::size_t i = 1; i <= triangles(p); ++i) {
        const double share = meeting(eye, along, p, i);
        if (share > 0 && share < nearest.share) nearest = {p, share};
      }
    });
    return nearest;
  }

  /// Whether the ray through a point meets no opaque polygon before the triangle: exactly. It does not if it misses that.
  [[nodiscard]] bool is_clear(const dvec3& eye, const dvec3& point, const Triangle& aim) const {
    const Ray ray({{eye.x, eye.y, eye.z}, false}, {point.x, point.y, point.z});
    if (!ray.enters(aim, {})) return false;
    bool is_clear = true;
    double end = 1.01;
    visit(eye, point - eye, end, [&](std::uint32_t other) {
      for (std::size_t k = 1; is_clear && k <= triangles(other); ++k) {
        is_clear = ray.order(aim, triangle(other, k), {0, 0, 0, 1}) != Ray::Order::nearer;
      }
      if (!is_clear) end = 0;
    });
    return is_clear;
  }

 private:
  static double extent(const occlude::kernel::Aabb& box) {
    double most = 0;
    for (int i = 0; i < 3; ++i) most = std::max({most, std::fabs(box.min[i]), std::fabs(box.max[i])});
    return most;
  }
  [[nodiscard]] double meeting(const dvec3& eye, const dvec3& along, std::uint32_t p, std::size_t i) const {
    const auto loop = tree_.soup().loop(p);
    const auto& v = tree_.soup().vertices;
    const dvec3 a = v[loop[0]], e = v[loop[i]] - a, f = v[loop[i + 1]] - a, across = glm::cross(along, f), to = eye - a,
                turned = glm::cross(to, e);
    const double determinant = glm::dot(e, across), u = glm::dot(to, across) / determinant,
                 w = glm::dot(along, turned) / determinant;
    return u >= 0 && w >= 0 && u + w <= 1 ? glm::dot(f, turned) / determinant : -1;
  }
  /// Calls f(p) for opaque polygons whose leaf a ray meets before `end`, which f may make nearer.
  template <class F>
  void visit(const dvec3& eye, const dvec3& along, const double& end, const F& f) const {
    std::vector<std::uint32_t> waiting{0};
    while (!waiting.empty()) {
      const std::uint32_t n = waiting.back();
      const auto& node = tree_.nodes()[n];
      waiting.pop_back();
      if (entry(node, eye, along) > end) continue;
      if (node.is_leaf()) {
        for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
          if (tree_.soup().is_opaque(p)) f(p);
        }
      } else {
        const bool is_left_first = entry(tree_.nodes()[n + 1], eye, along) <= entry(tree_.nodes()[node.right], eye, along);
        waiting.push_back(is_left_first ? node.right : n + 1);
        waiting.push_back(is_left_first ? n + 1 : node.right);
      }
    }
  }
  /// The share of the ray at which it may enter the node's box; infinite if it does not.
  [[nodiscard]] double entry(const Hierarchy::Node& node, const dvec3& eye, const dvec3& along) const {
    double first = 0, last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      const double low = node.box.min[i] - room_ - eye[i], high = node.box.max[i] + room_ - eye[i];
      if (along[i] == 0) {
        if (low > 0 || high < 0) return std::numeric_limits<double>::infinity();
        continue;
      }
      first = std::max(first, std::min(low / along[i], high / along[i]));
      last = std::min(last, std::max(low / along[i], high / along[i]));
    }
    return first <= last ? first : std::numeric_limits<double>::infinity();
  }

  const Hierarchy& tree_;
  double room_;
};

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
  const auto rays = std::strtoull(argv[3], nullptr, 10);
  const auto most = std::strtoull(argv[4], nullptr, 10);
  const auto seed = argc > 5 ? std::strtoull(argv[5], nullptr, 10) : std::random_device{}();
  const Tracer tracer(tree);
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
      if (!tracer.is_clear(eye, point, aim)) return;
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
    for (std::size_t ray = 0; ray < rays; ++ray) {
      const dvec3 eye = point_in(box, ray % 4 == 0);
      if (!hidden_cells.empty()) {
        const visible_sets::Number other = hidden_cells[random() % hidden_cells.size()];
        const dvec3 point = point_in(sets.box(other), ray % 8 < 2);
        if (point != eye && !(tracer.first(eye, point - eye).share < 1)) {
          claim(eye, point, target_at(point, point - eye), "cell", other);
        }
      }
      if (ray % 2 == 0 && !hidden.empty()) {
        const std::uint32_t p = hidden[random() % hidden.size()];
        const Triangle t = tracer.triangle(p, 1 + random() % tracer.triangles(p));
        double u = share(), v = share();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        dvec3 point;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          point[static_cast<int>(axis)] = t[0][axis] + u * (t[1][axis] - t[0][axis]) + v * (t[2][axis] - t[0][axis]);
        }
        ++aimed;
        // In most cases what hides it is itself seen. What is behind it does not hide it.
        const Tracer::Meeting first = tracer.first(eye, point - eye);
        if (first.share < 1 && seen[tree.face(first.polygon)]) continue;
        claim(eye, point, t, "polygon", tree.face(p));
      } else {
        dvec3 along;
        do along = {share() - 0.5, share() - 0.5, share() - 0.5};
        while (glm::length(along) > 0.5);
        const std::uint32_t p = tracer.first(eye, along).polygon;
        if (p == kNone) continue;
        met[tree.face(p)] = true;
        if (seen[tree.face(p)]) continue;
        for (std::size_t k = 1; k <= tracer.triangles(p); ++k) {
          claim(eye, eye + along, tracer.triangle(p, k), "polygon", tree.face(p));
        }
      }
    }
    for (const bool is_met : met) found += is_met;
  }
  const auto mean = [&](std::size_t sum) {
    return static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(asked, 1));
  };
  std::cout << "seed " << seed << ": " << asked << " cells, " << asked * rays << " rays, " << aimed << " of them aimed; "
            << wrong << " reach what is in no set; of " << mean(in_sets) << " in a set random rays find " << mean(found)
            << '\n';
  return wrong == 0 ? 0 : 1;
} catch (const std::exception& error) {
  return std::cerr << error.what() << '\n', 2;
}
