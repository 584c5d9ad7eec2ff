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
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "experiment.h"
#include "occlude/culler/simplified_occluders.h"
#include "occlude/oracle/faces.h"
#include "occlude/oracle/solid.h"
#include "rows.h"
#include "small_scenes.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using culler::OccluderOrigin;
using culler::PolygonSoup;
using culler::SimplifiedOccluders;
using culler::SoupView;
using glm::dvec3;
using oracle::Point;
using oracle::Triangle;

Point point(const dvec3& v) { return {v.x, v.y, v.z}; }

/// Two directions on a lattice, not parallel.
std::array<dvec3, 2> some_directions(Random& random) {
  for (;;) {
    const dvec3 a = lattice_point(random, 2), b = lattice_point(random, 2);
    if (a.x * b.y != a.y * b.x || a.y * b.z != a.z * b.y) return {a, b};
  }
}

/// A wall of squares, each divided in one of several ways, some left out, turned over, see-through or drawn twice. It may be
/// folded along its rows, and some corners lie a little beside their places.
void add_fine_wall(Random& random, PolygonSoup& soup, double scale) {
  const std::array<dvec3, 2> along = some_directions(random);
  const dvec3 begin = lattice_point(random, 3), fold = random.chance(0.3) ? lattice_point(random, 1) : dvec3(0);
  const int columns = random.integer(1, 5), rows = random.integer(1, 5);
  const double damage = random.chance(0.5) ? 0 : 0.1;
  std::vector<std::uint32_t> corners;
  const auto put = [&](double i, double k) {
    dvec3 v = scale * (begin + i * along[0] + k * along[1] + std::fabs(std::remainder(k, 2.0)) * fold);
    if (random.chance(0.2 * damage)) v[random.integer(0, 2)] += scale * std::ldexp(1.0, -random.integer(5, 52));
    return soup.add_vertex(v);
  };
  for (int i = 0; i <= columns; ++i) {
    for (int k = 0; k <= rows; ++k) corners.push_back(put(i, k));
  }
  const auto at = [&](int i, int k) { return corners[static_cast<std::size_t>(i * (rows + 1) + k)]; };
  const auto add = [&](std::vector<std::uint32_t> loop) {
    if (random.chance(damage)) std::ranges::reverse(loop);
    const std::size_t first = soup.size();
    soup.add_polygon(loop);
    if (random.chance(0.5 * damage)) soup.add_polygon(loop);
    if (random.chance(0.5 * damage)) soup.see_through_from(first);
  };
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      if (random.chance(damage)) continue;
      const std::uint32_t a = at(i, k), b = at(i + 1, k), c = at(i + 1, k + 1), d = at(i, k + 1);
      switch (random.index(5)) {
        case 0:
          add({a, b, c, d});
          break;
        case 1:
          add({a, b, c});
          add({a, c, d});
          break;
        case 2:
          add({b, c, d});
          add({b, d, a});
          break;
        case 3: {  // around its middle
          const std::uint32_t middle = put(i + 0.5, k + 0.5);
          for (const auto& [from, to] : {std::array{a, b}, {b, c}, {c, d}, {d, a}}) add({from, to, middle});
          break;
        }
        default: {  // with a corner on a side, which the neighbour may not have
          const std::uint32_t beside = put(i + 0.5, k);
          add({a, beside, d});
          add({beside, b, c});
          add({beside, c, d});
          if (random.chance(0.3)) add({a, b, beside});
        }
      }
    }
  }
}

/// Directions that are perpendicular, up to rounding, and have one length.
std::array<dvec3, 3> some_turned_axes(Random& random, double length) {
  const auto [a, b] = some_directions(random);
  const dvec3 x = glm::normalize(a), z = glm::normalize(glm::cross(a, b));
  return {length * x, length * glm::cross(z, x), length * z};
}

/// A solid of a few cells of a lattice that is turned, so that nothing of it need be exactly flat. Some corners lie beside
/// their places, and some squares may be missing.
void add_turned_solid(Random& random, PolygonSoup& soup, double scale) {
  const std::array<dvec3, 3> axes = some_turned_axes(random, scale);
  const dvec3 begin = scale * lattice_point(random, 3);
  const int fine = random.integer(1, 4), cells = random.integer(1, 2);
  const double noise = scale * std::array{0.0, 1e-15, 1e-12, 0.01}[random.index(4)];
  const bool is_turned_inwards = random.chance(0.2);
  std::map<std::array<int, 3>, std::uint32_t> corners;
  std::set<std::array<int, 3>> full;
  for (int i = 0; i < cells; ++i) full.insert({i, 0, random.integer(0, 1)});
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = corners.try_emplace(at, 0U);
    if (is_new) {
      dvec3 v = begin;
      for (std::size_t k = 0; k < 3; ++k) v += static_cast<double>(at[k]) / fine * axes[k];
      if (random.chance(0.5)) v[random.integer(0, 2)] += noise * random.integer(-2, 2);
      found->second = soup.add_vertex(v);
    }
    return found->second;
  };
  for (const std::array<int, 3>& cell : full) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int far : {0, 1}) {
        std::array<int, 3> beyond = cell;
        beyond[axis] += 2 * far - 1;
        if (full.contains(beyond)) continue;
        for (int i = 0; i < fine * fine; ++i) {
          std::vector<std::uint32_t> loop;
          for (const auto& [u, v] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            std::array<int, 3> at{};
            for (std::size_t k = 0; k < 3; ++k) at[k] = fine * cell[k];
            at[axis] += fine * far;
            at[(axis + 1) % 3] += i % fine + u;
            at[(axis + 2) % 3] += i / fine + v;
            loop.push_back(corner(at));
          }
          if ((far == 0) != is_turned_inwards) std::ranges::reverse(loop);
          if (!random.chance(0.001)) soup.add_polygon(loop);
        }
      }
    }
  }
}

PolygonSoup some_fine_soup(Random& random) {
  PolygonSoup soup;
  const double scale = std::array{1.0, 0.1, 0x1p-40, 3e20}[random.index(4)];
  if (random.chance(0.3)) soup = some_soup(random);
  if (random.chance(0.2)) add_turned_solid(random, soup, scale);
  for (int walls = random.integer(1, 3); walls > 0; --walls) add_fine_wall(random, soup, scale);
  return soup;
}

/// The fans of the opaque polygons.
std::vector<Triangle> drawn(SoupView soup) {
  std::vector<Triangle> triangles;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    if (!soup.is_opaque(p)) continue;
    const auto at = [&](std::size_t i) { return point(soup.vertices[soup.loop(p)[i]]); };
    for (std::size_t i = 1; i + 1 < soup.loop(p).size(); ++i) triangles.push_back({at(0), at(i), at(i + 1)});
  }
  return triangles;
}

/// The triangles that are connected with those of polygon `of`, over corners.
std::vector<Triangle> part_with(SoupView soup, std::size_t of) {
  std::vector<Triangle> left = drawn(soup), part;
  std::set<Point> corners{point(soup.vertices[soup.loop(of)[0]])};
  for (bool grows = true; grows;) {
    const auto is_connected = [&](const Triangle& triangle) {
      return std::ranges::any_of(triangle, [&](const Point& p) { return corners.contains(p); });
    };
    const auto rest = std::stable_partition(left.begin(), left.end(), std::not_fn(is_connected));
    grows = rest != left.end();
    for (auto triangle = rest; triangle != left.end(); ++triangle) corners.insert(triangle->begin(), triangle->end());
    part.insert(part.end(), rest, left.end());
    left.erase(rest, left.end());
  }
  return part;
}

/// Checks what is made of one soup.
class SimplifyJudge {
 public:
  SimplifyJudge(Random& random, Report& report) : random_(random), report_(report), soup_(some_fine_soup(random)) {}

  /// Returns what was wrong; empty if nothing was.
  std::string run() {
    culler::SimplifyOptions options{.triangles = std::numeric_limits<std::size_t>::max()};
    const bool with_boxes = random_.chance(0.2);
    if (with_boxes) options.boxes = {.boxes = 2, .cells = 6};
    if (random_.chance(0.3)) options.inset = std::array{1e-12, 1e-6, 0.05, 1e19}[random_.index(4)];
    const SimplifiedOccluders simple = simplified_occluders(soup_, options);
    for (const culler::InnerBox& inner : simple.boxes) {
      const std::string wrong = oracle::refute_inner_box(part_with(soup_, inner.polygon), to_oracle(inner.box));
      if (!wrong.empty()) return "a box: " + wrong;
    }
    const std::vector<Triangle> occluders = drawn(simple.soup);
    for (std::size_t t = 0; t < occluders.size(); ++t) {
      const std::string wrong = fault_of(occluders[t], simple, simple.origins[t]);
      if (!wrong.empty()) return "triangle " + std::to_string(t) + ": " + wrong;
    }
    return with_boxes || options.inset > 0 ? "" : fault_of_what_is_left_out(occluders);
  }

 private:
  std::string fault_of(const Triangle& triangle, const SimplifiedOccluders& simple, const OccluderOrigin& origin) {
    ++report_.tally.cases;
    if (origin.box != OccluderOrigin::kNoBox) {
      ++report_.tally.relations[1];
      return oracle::refute_half_face(to_oracle(simple.boxes.at(origin.box).box), triangle);
    }
    if (origin.is_inside) {
      ++report_.tally.relations[1];
      const std::vector<Triangle> part = part_with(soup_, origin.polygon);
      if (std::string wrong = oracle::refute_inner_triangle(part, triangle); !wrong.empty()) return wrong;
      ++report_.tally.cases;
      ++report_.tally.relations[2];
      Triangle bad = triangle;
      bad[random_.index(3)] = part[random_.index(part.size())][random_.index(3)];
      return oracle::refute_inner_triangle(part, bad).empty() ? "a forged one is accepted" : "";
    }
    ++report_.tally.relations[0];
    if (std::string wrong = oracle::refute_on_faces(faces_, triangle); !wrong.empty()) return wrong;
    const std::optional<Triangle> bad = forged(triangle);
    if (!bad) return "";
    ++report_.tally.cases;
    ++report_.tally.relations[2];
    return oracle::refute_on_faces(faces_, *bad).empty() ? "a forged one is accepted" : "";
  }

  /// The triangle with one corner out of its plane by three ulps: no corner of the soup was moved by so much.
  std::optional<Triangle> forged(Triangle triangle) {
    const auto at = [&](std::size_t i) { return dvec3(triangle[i][0], triangle[i][1], triangle[i][2]); };
    const dvec3 normal = glm::abs(glm::cross(at(1) - at(0), at(2) - at(0)));
    std::size_t axis = 0;
    for (const std::size_t other : {1U, 2U}) {
      if (normal[static_cast<int>(other)] > normal[static_cast<int>(axis)]) axis = other;
    }
    if (!(normal[static_cast<int>(axis)] > 0)) return std::nullopt;
    double& x = triangle[random_.index(3)][axis];
    const double towards = random_.chance(0.5) ? HUGE_VAL : -HUGE_VAL;
    for (int i = 0; i < 3; ++i) x = std::nextafter(x, towards);
    return triangle;
  }

  /// What is drawn must lie on the triangles, turned either way: of repeated polygons only the first counts.
  [[nodiscard]] std::string fault_of_what_is_left_out(const std::vector<Triangle>& occluders) const {
    for (Triangle face : faces_) {
      if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
      const std::string wrong = oracle::refute_on_faces(occluders, face);
      std::swap(face[0], face[1]);
      const bool has_area = wrong.find("area") == std::string::npos;
      if (has_area && !wrong.empty() && !oracle::refute_on_faces(occluders, face).empty()) return "left out: " + wrong;
    }
    return "";
  }

  static oracle::Aabb to_oracle(const kernel::Aabb& box) {
    return {{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}};
  }

  Random& random_;
  Report& report_;
  PolygonSoup soup_;
  std::vector<Triangle> faces_ = drawn(soup_);
};

}  // namespace

void run_simplified(std::uint64_t seed, Report& report) {
  Random random(seed);
  for (const std::uint64_t enough = report.tally.cases + kGroup; report.tally.cases < enough;) {
    if (const std::string wrong = SimplifyJudge(random, report).run(); !wrong.empty()) {
      return add_finding(report, "occluder", wrong);
    }
  }
}

}  // namespace occlude::fuzz
