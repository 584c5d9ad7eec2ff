// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "any_case.h"
#include "cases/case_json.h"
#include "exact_visibility.h"
#include "experiment.h"
#include "frame/culler_access.h"
#include "model/bounds.h"
#include "occlude/culler/culler.h"
#include "proof.h"
#include "rows.h"
#include "small_scenes.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using culler::Camera;
using culler::Culler;
using culler::PolygonSoup;
using culler::SoupView;
using culler::to_glm;
using glm::dvec3;
using Json = nlohmann::json;
using Plane = std::array<double, 4>;

/// The number of lines about one scene. What the scene shows is expensive to find out.
constexpr std::size_t kLines = 4 * kGroup;

constexpr std::size_t kFrames = 2;

Json json(double x) { return cases::json_of(x); }
Json json(const dvec3& v) { return {json(v.x), json(v.y), json(v.z)}; }

/// A camera of any size that is legal.
Camera forged_camera(Random& random, SoupView soup) {
  return first_legal([&]() -> std::optional<Camera> {
    Camera camera = some_camera(random, soup);
    if (random.chance(0.5)) camera.fov_y_deg = std::array{0.001, 1.0, 60.0, 120.0, 170.0, 179.0}[random.index(6)];
    if (random.chance(0.5))
      camera.aspect = std::array{16.0 / 9, 4.0, 0.25, 100.0, 0.01, 65536.0, 1 / 65536.0}[random.index(7)];
    if (random.chance(0.3)) camera.near_plane = std::array{1e-6, 0.01, 2.0, 8.0}[random.index(4)];
    if (random.chance(0.3)) camera.far_plane = camera.near_plane * (1 + std::ldexp(1.0, random.integer(-20, 12)));
    return fault(camera).empty() ? std::optional(camera) : std::nullopt;
  });
}

/// What a forger makes of the number `x`.
double bent(Random& random, double x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  switch (random.integer(0, 7)) {
    case 0:
      return std::nextafter(x, random.chance(0.5) ? kInfinity : -kInfinity);
    case 1:
      return x * (1 + std::ldexp(random.chance(0.5) ? 1.0 : -1.0, -random.integer(1, 52)));
    case 2:
      return x + random.integer(-2, 2);
    case 3:
      return -x;
    case 4:
      return std::array{1.7e308, -1.7e308, 1e300, -1e300, 0x1p100, -0x1p100}[random.index(6)];
    case 5:
      return std::array{5e-324, -5e-324, 1e-300, 0x1p-100, -0x1p-100, 0.0}[random.index(6)];
    case 6:
      return std::array{kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}[random.index(3)];
    default:
      return x * std::ldexp(1.0, random.integer(-60, 60));
  }
}

/// A scene, its cameras, what they show, and what the culler culls.
class Forger {
 public:
  explicit Forger(Random& random)
      : random_(random),
        input_(some_soup(random)),
        culler_(input_, {.hierarchy = {.leaf_size = static_cast<std::uint32_t>(random.integer(1, 4))}, .lists = {}}),
        prover_(culler_.hierarchy(), {kFrames, [this](std::size_t frame) { return cameras_[frame]; }}) {
    for (Camera& camera : cameras_) {
      camera = forged_camera(random, soup());
      shows_.push_back(proof::visible_triangles(soup(), camera));
      culled_.push_back(culler_.cull(camera, {.method = culler::Method::frusta}));
    }
  }

  struct Outcome {
    std::string line;
    bool is_taken = false, is_honest = false;
    std::optional<std::size_t> shows;  ///< of an accepted line, a visible triangle that it culls
  };

  Outcome forge() {
    Outcome outcome;
    is_lying_ = random_.chance(0.8);
    frame_ = random_.index(kFrames);
    const auto& culled = culled_[frame_].culled;
    const bool is_of_the_culler = !culled.empty() && random_.chance(0.5);
    outcome.is_honest = is_of_the_culler && !is_lying_;
    outcome.line = (is_of_the_culler ? line_of(culled[random_.index(culled.size())]) : any_line()).dump();
    proof::Proof proof;
    try {
      proof = prover_.prove(outcome.line);
    } catch (const cases::LineError&) {
      return outcome;
    }
    outcome.is_taken = proof.failure.empty();
    if (!outcome.is_taken) return outcome;
    for (std::size_t t = proof.first; t < proof.first + proof.count; ++t) {
      if (shows_[proof.frame][t]) outcome.shows = t;
    }
    return outcome;
  }

 private:
  const culler::SoupView& soup() const { return culler_.hierarchy().soup(); }
  std::size_t triangles() const { return culler_.hierarchy().first_triangle(soup().size()); }

  bool lies(double probability) { return is_lying_ && random_.chance(probability); }

  Json line_of(const culler::Culled& culled) {
    const auto& node = culler_.hierarchy().nodes()[culled.node];
    Json line = line_about({node.first, node.count});
    const culler::CullResult& frame = culled_[frame_];
    if (culled.by == culler::Culled::By::view) {
      const auto& [normal, offset] = frame.view[culled.index];
      add_plane(line, {normal.x, normal.y, normal.z, offset});
    } else {
      const culler::Occluder& occluder = frame.occluders[culled.index];
      const auto& support = occluder.frustum.support_plane();
      Json near = "surface";
      if (support) near = {{"normal", json(to_glm(support->normal))}, {"point", json(to_glm(support->point))}};
      add_shadow(line, occluder_of(occluder.index), lies(0.2) ? some_near() : near);
    }
    return line;
  }

  Json any_line() {
    Json line = line_about(some_run());
    if (random_.chance(0.5)) {
      add_plane(line, random_.chance(0.3)   ? plane_of_the_view()
                      : random_.chance(0.3) ? plane_before_the_box()
                                            : plane_through_the_view());
    } else if (random_.chance(0.5)) {
      add_shadow(line, some_occluder(), some_near());
    } else {
      add_cover(line);
    }
    return line;
  }

  /// Lists some polygons of the model, or nearly all.
  void add_cover(Json& line) {
    line["by"] = "cover";
    line["margin"] = 0.0;
    line["polygons"] = Json::array();
    const double share = std::array{0.1, 0.5, 0.95}[random_.index(3)];
    for (std::size_t i = 0; i < input_.size(); ++i) {
      if (random_.chance(share)) line["polygons"].push_back(i);
    }
    if (lies(0.05)) line["polygons"].push_back(random_.index(2 * input_.size()));
  }

  /// A line about these polygons, without what culls them.
  Json line_about(const culler::PolygonRange& run) {
    Json line{{"frame", lies(0.05) ? random_.index(kFrames + 1) : frame_}, {"margin", 0.0}};
    const std::size_t first = culler_.hierarchy().first_triangle(run.first);
    line["triangles"] = {first, culler_.hierarchy().first_triangle(run.first + run.count) - first};
    box_ = box_of(run);
    line["box"] = forged_box();
    add_viewpoint(line);
    if (lies(0.1)) line["margin"] = std::array{1e-9, 1.0, -1.0, 1e300}[random_.index(4)];
    if (lies(0.1)) line["triangles"] = {random_.index(triangles() + 1), random_.index(triangles() + 1)};
    return line;
  }

  /// A polygon, a subtree, or any run of polygons.
  culler::PolygonRange some_run() {
    const auto p = static_cast<std::uint32_t>(random_.index(soup().size()));
    if (random_.chance(0.5)) return {p, 1};
    if (random_.chance(0.2)) return {p, static_cast<std::uint32_t>(1 + random_.index(soup().size() - p))};
    const auto nodes = culler_.hierarchy().nodes();
    const auto& node = nodes[random_.index(nodes.size())];
    return {node.first, node.count};
  }

  kernel::Aabb box_of(const culler::PolygonRange& run) const {
    kernel::Aabb box = soup().box(run.first);
    for (std::uint32_t p = run.first; p < run.first + run.count; ++p) culler::grow(box, soup().box(p));
    return box;
  }

  /// Mostly the true box.
  Json forged_box() {
    std::array<dvec3, 2> ends{dvec3{box_.min.x, box_.min.y, box_.min.z}, dvec3{box_.max.x, box_.max.y, box_.max.z}};
    if (lies(0.2)) {
      double& number = ends[random_.index(2)][random_.integer(0, 2)];
      number = bent(random_, number);
    }
    if (!lies(0.2)) return {{"min", json(ends[0])}, {"max", json(ends[1])}};
    const dvec3 half = 0.5 * (ends[1] - ends[0]);
    return {{"center", json(ends[0] + half)},
            {"half_edges", {json({half.x, 0, 0}), json({0, half.y, 0}), json({0, 0, half.z})}}};
  }

  void add_viewpoint(Json& line) {
    const Camera& camera = cameras_[lies(0.05) ? random_.index(kFrames) : frame_];
    dvec3 at = camera.projection == culler::Projection::perspective ? camera.eye : camera.axes().forward;
    if (lies(0.05)) at[random_.integer(0, 2)] += 1e-9;
    line[camera.projection == culler::Projection::perspective ? "eye" : "direction"] = json(at);
  }

  void add_plane(Json& line, Plane plane) {
    if (lies(0.3)) {
      const double factor = bent(random_, 1);
      for (double& number : plane) number *= factor;
    }
    if (lies(0.4)) {
      double& number = plane[random_.index(4)];
      number = bent(random_, number);
    }
    line["by"] = "view";
    line["plane"] = {json(plane[0]), json(plane[1]), json(plane[2]), json(plane[3])};
  }

  /// A plane of the view as the culler computes it.
  Plane plane_of_the_view() {
    std::vector<culler::HalfSpace> planes;
    culler::append_view_frustum(cameras_[frame_], 4 * kReach, planes);
    const auto& [normal, offset] = planes[random_.index(planes.size())];
    return {normal.x, normal.y, normal.z, offset};
  }

  static Plane plane_at(const dvec3& normal, const dvec3& point) {
    return {normal.x, normal.y, normal.z, -glm::dot(normal, point)};
  }

  dvec3 some_normal() {
    const dvec3 normal{random_.real(-1, 1), random_.real(-1, 1), random_.real(-1, 1)};
    return random_.chance(0.5) ? normal : lattice_point(random_, 3);
  }

  /// A plane with the box just beyond it.
  Plane plane_before_the_box() {
    const dvec3 normal = some_normal();
    dvec3 nearest;
    for (int axis = 0; axis < 3; ++axis) nearest[axis] = (normal[axis] > 0 ? box_.max : box_.min)[axis];
    Plane plane = plane_at(normal, nearest);
    plane[3] -= std::ldexp(1.0, -random_.integer(0, 50));
    return plane;
  }

  /// A plane through a side of the picture at two depths. The deeper point is cut short, as by a hull of points that misses
  /// a part.
  Plane plane_through_the_view() {
    const Camera& camera = cameras_[frame_];
    const auto [right, up, forward] = camera.axes();
    const bool perspective = camera.projection == culler::Projection::perspective;
    const double half_height = perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2;
    const bool is_wide = random_.chance(0.5);
    const dvec3 across = (random_.chance(0.5) ? 1.0 : -1.0) * (is_wide ? right : up), along = is_wide ? up : right;
    const double half = half_height * (is_wide ? camera.aspect : 1);
    const double reach = random_.real(1, 4 * kReach), cut = random_.chance(0.5) ? reach : half * reach;
    const double narrower = 1 - (random_.chance(0.5) ? 0 : std::ldexp(1.0, -random_.integer(1, 50)));
    const auto corner = [&](double depth) { return std::min(perspective ? half * depth : half, cut) * narrower; };
    const dvec3 near = camera.eye + camera.near_plane * forward + corner(camera.near_plane) * across;
    const dvec3 far = camera.eye + reach * forward + corner(reach) * across;
    const dvec3 normal = glm::cross(far - near, along);
    return plane_at(glm::dot(normal, across) < 0 ? normal : -normal, far);
  }

  void add_shadow(Json& line, const Json& occluder, const Json& near) {
    line["by"] = "shadow";
    line["occluders"] = Json::array({occluder});
    if (lies(0.1)) line["occluders"].push_back(some_occluder());
    line["near"] = near;
  }

  Json some_near() {
    if (random_.chance(0.8)) return random_.chance(0.5) ? "surface" : "farthest";
    const dvec3 point{box_.min.x, box_.min.y, box_.min.z};
    return {{"normal", json(some_normal())}, {"point", json(random_.chance(0.5) ? point : last_corner_)}};
  }

  /// An occluder of the culler, a polygon of the model, or something like it.
  Json some_occluder() {
    const auto& occluders = occluders_of(culler_);
    if (occluders.size() != 0 && random_.chance(0.6)) {
      return occluder_of(static_cast<std::uint32_t>(random_.index(occluders.size())));
    }
    return {{"polygon", forged_loop(loop(soup().loop(random_.index(soup().size()))))}};
  }

  Json occluder_of(std::uint32_t i) {
    const auto geometry = occluders_of(culler_).geometry(i);
    if (const auto* solid = std::get_if<kernel::Polytope>(&geometry)) {
      std::vector<dvec3> vertices;
      for (const kernel::Vec3& v : solid->vertices) vertices.push_back(to_glm(v));
      Json faces = solid->faces;
      if (lies(0.1)) faces.erase(random_.index(faces.size()));
      return {{"vertices", forged_loop(std::move(vertices))}, {"faces", faces}};
    }
    const auto piece = occluders_of(culler_).regions().piece(i);
    Json parts = Json::array();
    for (const std::uint32_t part : occluders_of(culler_).parts(i)) {
      const std::size_t first = culler_.hierarchy().first_triangle(part);
      const std::size_t count = culler_.hierarchy().first_triangle(part + 1) - first;
      parts.push_back(piece ? Json{first + piece->first, piece->count} : Json{first, count});
    }
    if (lies(0.1)) parts.erase(random_.index(parts.size()));
    if (lies(0.1)) parts.push_back({random_.index(triangles()), 1});
    return {{"polygon", forged_loop(loop(occluders_of(culler_).loop(i)))}, {"parts", parts}};
  }

  std::vector<dvec3> loop(std::span<const std::uint32_t> indices) {
    std::vector<dvec3> result;
    for (const std::uint32_t index : indices) result.push_back(soup().vertices[index]);
    return result;
  }

  Json forged_loop(std::vector<dvec3> vertices) {
    if (lies(0.1)) {
      double& number = vertices[random_.index(vertices.size())][random_.integer(0, 2)];
      number = bent(random_, number);
    }
    if (lies(0.05)) std::ranges::reverse(vertices);
    if (lies(0.05)) vertices.pop_back();
    Json result = Json::array();
    for (const dvec3& v : vertices) result.push_back(json(v));
    if (!vertices.empty()) last_corner_ = vertices.back();
    return result;
  }

  Random& random_;
  PolygonSoup input_;
  Culler culler_;
  std::array<Camera, kFrames> cameras_;
  std::vector<std::vector<bool>> shows_;
  std::vector<culler::CullResult> culled_;
  proof::Prover prover_;

  // State of the current line.
  bool is_lying_ = false;
  std::size_t frame_ = 0;
  kernel::Aabb box_;
  dvec3 last_corner_{};
};

}  // namespace

void run_forgeries(std::uint64_t seed, Report& report) {
  Random random(seed);
  Forger forger(random);
  for (std::size_t i = 0; i < kLines; ++i) {
    const Forger::Outcome outcome = forger.forge();
    ++report.tally.cases;
    ++report.tally
          .relations[static_cast<std::size_t>(outcome.is_taken ? kernel::Relation::inside : kernel::Relation::outside)];
    if (outcome.is_honest && !outcome.is_taken) {
      add_finding(report, "honest", "what the culler culls is not proved: " + outcome.line);
    }
    if (outcome.shows) {
      add_finding(report, "proof",
                  "triangle " + std::to_string(*outcome.shows) + " shows and is proved to be culled: " + outcome.line);
    }
  }
}

}  // namespace occlude::fuzz
