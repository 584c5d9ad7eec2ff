// SPDX-License-Identifier: MIT
#include "culling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "any_case.h"
#include "cull_judge.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_union.h"
#include "picture_margin.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using culler::Camera;
using culler::Culler;
using culler::CullOptions;
using culler::CullResult;
using culler::PolygonSoup;
using glm::dvec3;

dvec3 lattice_point(Random& random, int reach) {
  const auto coordinate = [&] { return static_cast<double>(random.integer(-reach, reach)); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

void add_loop(PolygonSoup& soup, const std::vector<dvec3>& loop) {
  std::vector<std::uint32_t> indices;
  for (const dvec3& v : loop) indices.push_back(soup.add_vertex(v));
  soup.add_polygon(indices);
}

/// A loop of four in one piece, or the two triangles that it is drawn as.
void add_quadrilateral(PolygonSoup& soup, const std::array<dvec3, 4>& loop, bool is_whole) {
  if (is_whole) return add_loop(soup, {loop.begin(), loop.end()});
  add_loop(soup, {loop[0], loop[1], loop[2]});
  add_loop(soup, {loop[0], loop[2], loop[3]});
}

/// A rectangle along two axes, its sides up to `size`; or its two halves, flat or bent so little that they pass for it.
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

/// A closed box, upright or skew, its sides up to `size`, of 6 faces or 12, on its own or with a wall that goes on from an
/// edge; or some of its faces, which meet in edges.
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
  // With a vertex more in the edge: what three polygons share is of no closed box.
  const dvec3 away = lattice_point(random, size);
  add_loop(soup, {high, high - 0.5 * z, high - z, high - z + away, high + away});
}

void add_triangle(Random& random, PolygonSoup& soup, int reach) {
  add_loop(soup, {lattice_point(random, reach), lattice_point(random, reach), lattice_point(random, reach)});
}

/// Parallel to a polygon, half as large and before its middle, or behind it, or in its plane: a hair away along an axis.
void add_poster(Random& random, PolygonSoup& soup) {
  const auto loop = soup.loop(random.index(soup.size()));
  const dvec3 a = soup.vertices[loop[0]], b = soup.vertices[loop[1]], c = soup.vertices[loop[2]];
  const dvec3 along = 0.5 * (b - a), across = 0.5 * (c - b);
  dvec3 corner = a + 0.5 * along + 0.5 * across;
  corner[random.integer(0, 2)] += random.integer(-2, 2) * 0x1p-18;
  add_quadrilateral(soup, {corner, corner + along, corner + along + across, corner + across}, random.chance(0.5));
}

/// A loop in a plane along two axes that turns as it likes: its fan folds over.
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

/// The largest power of two that is not above x.
double power_below(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, exponent - 1);
}

/// The occluder of some case, moved near: any number of sides, slivers, folded ones.
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

constexpr int kReach = 8;

/// Some walls and boxes that hide, small things that can be hidden, and a few polygons of any kind.
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
  if (random.chance(0.2)) {  // far from the origin, rounded
    const dvec3 away = 1e6 * lattice_point(random, 9) + dvec3{0.1, 0.2, 0.3};
    for (dvec3& v : soup.vertices) v += away;
  }
  return soup;
}

Camera some_camera(Random& random, const PolygonSoup& soup) {
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
  camera.near = std::array{0.1, 1.0, 3.0}[random.index(3)];
  if (random.chance(0.3)) camera.projection = culler::Projection::orthographic;
  if (random.chance(0.3)) camera.far = camera.near + random.integer(1, 2 * kReach);
  return camera;
}

/// The camera some steps later, or another one.
Camera moved(Random& random, const PolygonSoup& soup, const Camera& before) {
  if (random.chance(0.2)) return some_camera(random, soup);
  Camera camera = before;
  camera.eye += 0.25 * lattice_point(random, kReach / 2);
  if (random.chance(0.3)) camera.target += 0.25 * lattice_point(random, kReach / 2);
  return camera;
}

culler::Objective some_objective(Random& random) {
  constexpr std::array kWeights{1.0, 0.5, 0.0};
  culler::Objective objective;
  if (random.chance(0.5)) objective.angle = culler::Objective::Angle::exact;
  objective.solid_angle = kWeights[random.index(kWeights.size())];
  objective.depth_complexity = kWeights[random.index(kWeights.size())];
  objective.coherence = kWeights[random.index(kWeights.size())];
  return objective;
}

CullOptions some_options(Random& random) {
  CullOptions options;
  options.occluders = static_cast<std::size_t>(random.integer(0, 12));
  options.probes = std::array<std::size_t, 3>{0, 1, 8}[random.index(3)];
  options.objective = some_objective(random);
  options.unions = random.chance(0.5);
  if (random.chance(0.3)) options.near = kernel::Near::farthest;
  if (random.chance(0.3)) options.test = kernel::Test::overlap;
  if (random.chance(0.2)) options.margin = std::array{0x1p-80, 0x1p-20, 0x1p-6, 1.0}[random.index(4)];
  return options;
}

culler::BuildConfig some_config(Random& random) {
  culler::BuildConfig config;
  config.hierarchy.leaf_size = static_cast<std::uint32_t>(random.integer(1, 4));
  if (random.chance(0.5)) config.hierarchy.bounds = culler::Bounds::obb;
  config.occluders.shells = random.chance(0.8);
  config.grid.regions = std::array{1.0, 8.0, 64.0}[random.index(3)];
  return config;
}

/// Every half-space, every shadow and every pair of shadows of a frame, asked about one box.
class BruteForce {
 public:
  BruteForce(const CullOptions& options, const CullResult& frame, const PictureMargin& margin)
      : options_(options), frame_(frame), margin_(margin) {}

  template <class AnyBox>
  [[nodiscard]] bool is_out_of_view(const AnyBox& box) const {
    return std::ranges::any_of(frame_.view, [&](const culler::HalfSpace& h) {
      const kernel::HalfSpace plane{{h.normal.x, h.normal.y, h.normal.z}, h.offset};
      return kernel::relation(plane, box, options_.arithmetic) == kernel::Relation::outside;
    });
  }

  /// Occluders that must not hide the box are left out.
  template <class AnyBox, class MayHide>
  [[nodiscard]] bool is_hidden(const AnyBox& box, const MayHide& may_hide) const {
    const auto hides = [&](const culler::Occluder& occluder) {
      const kernel::Decision decision =
          kernel::decide(occluder.frustum, box, options_.arithmetic, options_.test, kernel::NearBoundary::open);
      return decision.relation == kernel::Relation::inside && margin_.keeps(occluder.frustum, box) && may_hide(occluder);
    };
    const auto hide_together = [&](const culler::ShadowPair& pair) {
      const culler::Occluder &first = frame_.occluders[pair.first], &second = frame_.occluders[pair.second];
      const kernel::ShadowUnion both{first.frustum, second.frustum};
      return may_hide(first) && may_hide(second) &&
             kernel::overlap_certified(both, box, kernel::NearBoundary::open).relation == kernel::Relation::inside &&
             margin_.keeps(both, box);
    };
    return std::ranges::any_of(frame_.occluders, hides) || std::ranges::any_of(frame_.pairs, hide_together);
  }

 private:
  const CullOptions& options_;
  const CullResult& frame_;
  const PictureMargin& margin_;
};

/// What a traversal draws that asks all of that at every node.
class Twin {
 public:
  Twin(const Culler& culler, const BruteForce& ask)
      : hierarchy_(culler.hierarchy()), occluders_(culler.occluders()), ask_(ask), drawn_(hierarchy_.soup().size()) {
    visit(0);
  }

  [[nodiscard]] const std::vector<bool>& drawn() const { return drawn_; }

 private:
  /// No node is culled by what is drawn as a polygon of it.
  bool holds_part(const culler::HierarchyNode& node, const culler::Occluder& occluder) const {
    return std::ranges::any_of(occluders_.parts(occluder.index),
                               [&](std::uint32_t part) { return part >= node.first && part - node.first < node.count; });
  }

  void visit(std::uint32_t index) {
    const auto& node = hierarchy_.nodes()[index];
    const auto may_hide = [&](const culler::Occluder& occluder) { return !holds_part(node, occluder); };
    const auto is_culled = [&](const auto& box) { return ask_.is_out_of_view(box) || ask_.is_hidden(box, may_hide); };
    if (hierarchy_.ask(index, is_culled)) return;
    if (node.is_leaf()) {
      for (std::size_t p = node.first; p < std::size_t{node.first} + node.count; ++p) drawn_[p] = true;
      return;
    }
    visit(index + 1);
    visit(node.right);
  }

  const culler::Hierarchy& hierarchy_;
  const culler::PotentialOccluders& occluders_;
  const BruteForce& ask_;
  std::vector<bool> drawn_;
};

std::vector<bool> drawn_of(const Culler& culler, const CullResult& result) {
  return culler::polygons_of(result.drawn, culler.hierarchy().soup().size());
}

/// Whether the shadow is the one that the occluder casts from here, whatever was seen of it in the frames before.
bool is_of_this_frame(const Culler& culler, const Camera& camera, const CullOptions& options,
                      const culler::Occluder& occluder) {
  const dvec3 at = camera.projection == culler::Projection::perspective ? camera.eye : camera.axes().forward;
  const kernel::Vec3 value{at.x, at.y, at.z};  // apart from the culler's own
  const auto viewpoint = camera.projection == culler::Projection::perspective ? kernel::Viewpoint::eye(value)
                                                                              : kernel::Viewpoint::direction(value);
  const kernel::ShadowFrustumResult fresh =
      culler.occluders().shadow(culler.hierarchy().soup(), occluder.index, viewpoint, options.near);
  return fresh.frustum && std::ranges::equal(fresh.frustum->silhouette(), occluder.frustum.silhouette()) &&
         fresh.frustum->near_count() == occluder.frustum.near_count() &&
         std::ranges::equal(fresh.frustum->cap_vertices(), occluder.frustum.cap_vertices());
}

/// How far from the eye the model reaches.
double farthest_vertex(const PolygonSoup& soup, const dvec3& eye) {
  double result = 0;
  for (const dvec3& v : soup.vertices) result = std::max(result, glm::distance(v, eye));
  return result;
}

/// Whether what the frame's view says of the boxes of the tree is no more than `most` says, and no less than `least`.
std::string fault_of_queries(const Culler& culler, const culler::View& view, const BruteForce& most,
                             const BruteForce& least) {
  const auto all_hide = [](const culler::Occluder&) { return true; };
  for (std::uint32_t node = 0; node < culler.hierarchy().nodes().size(); ++node) {
    const culler::Visibility answer = view.visibility(culler.hierarchy().volume(node));
    const bool is_right = culler.hierarchy().ask(node, [&](const auto& box) {
      if (most.is_out_of_view(box)) return answer == culler::Visibility::out_of_view;
      return answer == culler::Visibility::occluded  ? most.is_hidden(box, all_hide)
             : answer == culler::Visibility::visible ? !least.is_hidden(box, all_hide)
                                                     : false;
    });
    if (!is_right) return "a query about the box of a node is answered wrongly";
  }
  return "";
}

std::string fault_of_frame(const Culler& culler, const Camera& camera, const CullOptions& options,
                           const culler::View& view) {
  const CullResult& result = view.result();
  if (std::string fault = fault_of(culler, camera, options, result); !fault.empty()) return fault;
  for (const culler::Occluder& occluder : result.occluders) {
    if (!is_of_this_frame(culler, camera, options, occluder)) return "a shadow is not the one that its occluder casts";
  }
  const double farthest = farthest_vertex(culler.hierarchy().soup(), camera.eye);
  const PictureMargin culls(camera, options.margin, farthest, Doubt::culls);
  const PictureMargin draws(camera, options.margin, farthest, Doubt::draws);
  const BruteForce most(options, result, culls), least(options, result, draws);
  const std::vector<bool> drawn = drawn_of(culler, result);
  const std::vector<bool> must = Twin(culler, most).drawn();
  const std::vector<bool> may = options.margin == 0 ? must : Twin(culler, least).drawn();
  // An oriented box sticks out of the one above it, into shadows that were dropped there and that may hide a corner of it.
  const bool may_draw_more = options.unions && culler.hierarchy().oriented() != 0;
  for (std::size_t p = 0; p < drawn.size(); ++p) {
    if (must[p] && !drawn[p]) return "a traversal without active sets culls less";
    if (drawn[p] && !may[p] && !may_draw_more) return "a traversal without active sets culls more";
  }
  return fault_of_queries(culler, view, most, least);
}

}  // namespace

void run_culling(std::uint64_t seed, Report& report) {
  Random random(seed);
  const PolygonSoup soup = some_soup(random);
  const Culler culler(soup, some_config(random));
  const auto legal = [](const auto& draw) {
    return first_legal([&]() -> std::optional<Camera> {
      Camera drawn = draw();
      return fault(drawn).empty() ? std::optional(drawn) : std::nullopt;
    });
  };
  Camera camera = legal([&] { return some_camera(random, soup); });
  const CullOptions options = some_options(random);
  culler::View view;
  for (int frames = random.integer(0, 3); frames > 0; --frames) {
    culler.cull(camera, options, view);
    if (random.chance(0.7)) camera = legal([&] { return moved(random, soup, camera); });
  }
  const CullResult& result = culler.cull(camera, options, view);
  const culler::CullStats& stats = result.stats;
  report.tally.cases += soup.size();
  report.tally.relations[0] += stats.shadow_culled_polygons;
  report.tally.relations[1] += stats.drawn_polygons;
  report.tally.relations[2] += stats.view_culled_polygons;
  report.tally.stages[stats.exact_shadow_tests != 0 ? 1 : 0] += soup.size();
  const std::string wrong = fault_of_frame(culler, camera, options, view);
  if (wrong.empty()) return;
  add_finding(report, "culler", seed, "frame", wrong);
}

}  // namespace occlude::fuzz
