// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "any_case.h"
#include "cull_judge.h"
#include "frame/culler_access.h"
#include "model/block_tree.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_union.h"
#include "picture_margin.h"
#include "rows.h"
#include "small_scenes.h"
#include "stored_frustum.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using culler::Camera;
using culler::Culler;
using culler::CullOptions;
using culler::CullResult;
using culler::PolygonSoup;
using culler::SoupView;
using glm::dvec3;

/// The camera a few steps later, or another camera.
Camera moved(Random& random, SoupView soup, const Camera& before) {
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
  CullOptions options{.method = culler::Method::frusta};
  options.occluders = static_cast<std::size_t>(random.integer(0, 12));
  options.probes = std::array<std::size_t, 3>{0, 1, 8}[random.index(3)];
  options.objective = some_objective(random);
  options.unions = random.chance(0.5);
  if (random.chance(0.3)) options.shadow_near = kernel::Near::farthest;
  if (random.chance(0.3)) options.test = kernel::Test::overlap;
  if (random.chance(0.2)) options.margin = std::array{0x1p-80, 0x1p-20, 0x1p-6, 1.0}[random.index(4)];
  return options;
}

culler::BuildConfig some_config(Random& random) {
  culler::BuildConfig config;
  config.hierarchy.leaf_size = static_cast<std::uint32_t>(random.integer(1, 4));
  if (random.chance(0.5)) config.hierarchy.bounds = culler::Bounds::obb;
  config.occluders.shells = random.chance(0.8);
  const std::size_t regions = random.index(6);
  config.lists.kind = regions < 3 ? culler::RegionKind::grid : culler::RegionKind::tree;
  config.lists.regions = std::array{1.0, 8.0, 64.0}[regions % 3];
  return config;
}

/// Asks every half-space, every shadow and every pair of shadows of a frame about one box.
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

  /// Leaves out the occluders that must not hide the box.
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

/// A traversal that asks all of that at every node of the blocks, and the polygons that it draws.
class Twin {
 public:
  Twin(const Culler& culler, const BruteForce& ask)
      : hierarchy_(culler.hierarchy()),
        tree_(culler::CullerAccess::tree(culler)),
        occluders_(occluders_of(culler)),
        ask_(ask),
        drawn_(hierarchy_.soup().size()) {
    visit_block(0);
  }

  [[nodiscard]] const std::vector<bool>& drawn() const { return drawn_; }

 private:
  /// Whether the node has a part of the occluder. Such an occluder does not cull the node.
  bool holds_part(const culler::HierarchyNode& node, const culler::Occluder& occluder) const {
    return std::ranges::any_of(occluders_.parts(occluder.index),
                               [&](std::uint32_t part) { return part >= node.first && part - node.first < node.count; });
  }

  void visit_block(std::uint32_t block) {
    for (std::size_t i = 0; i < tree_[block].size(); ++i) visit(tree_[block].node[i], tree_[block].below[i]);
  }
  void visit(std::uint32_t index, std::uint32_t below) {
    const auto& node = hierarchy_.nodes()[index];
    const auto may_hide = [&](const culler::Occluder& occluder) { return !holds_part(node, occluder); };
    const auto is_culled = [&](const auto& box) { return ask_.is_out_of_view(box) || ask_.is_hidden(box, may_hide); };
    if (hierarchy_.ask(index, is_culled)) return;
    if (node.is_leaf()) {
      for (std::size_t p = node.first; p < std::size_t{node.first} + node.count; ++p) drawn_[p] = true;
      return;
    }
    visit_block(below);
  }

  const culler::Hierarchy& hierarchy_;
  const culler::BlockTree tree_;
  const culler::PotentialOccluders& occluders_;
  const BruteForce& ask_;
  std::vector<bool> drawn_;
};

std::vector<bool> drawn_of(const Culler& culler, const CullResult& result) {
  return culler::polygons_of(result.drawn, culler.hierarchy().soup().size());
}

/// Whether the shadow is what the occluder casts from this viewpoint, whatever was seen of it in the frames before.
bool is_of_this_frame(const Culler& culler, const Camera& camera, const CullOptions& options,
                      const culler::Occluder& occluder) {
  const dvec3 at = camera.projection == culler::Projection::perspective ? camera.eye : camera.axes().forward;
  const kernel::Vec3 value{at.x, at.y, at.z};  // derived without the culler's own viewpoint
  const auto viewpoint = camera.projection == culler::Projection::perspective ? kernel::Viewpoint::eye(value)
                                                                              : kernel::Viewpoint::direction(value);
  const kernel::ShadowFrustumResult fresh = occluders_of(culler).shadow(occluder.index, viewpoint, options.shadow_near);
  return fresh.frustum && std::ranges::equal(fresh.frustum->silhouette(), occluder.frustum.silhouette()) &&
         fresh.frustum->near_count() == occluder.frustum.near_count() &&
         kernel::stored(*fresh.frustum)->cap_vertices == kernel::stored(occluder.frustum)->cap_vertices;
}

/// The distance from the eye to the farthest vertex.
double farthest_vertex(SoupView soup, const dvec3& eye) {
  double result = 0;
  for (const dvec3& v : soup.vertices) result = std::max(result, glm::distance(v, eye));
  return result;
}

/// Checks the answers of the frame's view about the boxes of the tree. What it hides `most` must hide. What it shows `least`
/// must not hide.
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
  // An oriented box may stick out of the box of its parent, into shadows that were dropped at the parent. These may hide it.
  const bool may_draw_more = options.unions && culler.hierarchy().oriented() != 0;
  for (std::size_t p = 0; p < drawn.size(); ++p) {
    if (must[p] && !drawn[p]) return "a traversal without active sets culls less";
    if (drawn[p] && !may[p] && !may_draw_more) return "a traversal without active sets culls more";
  }
  return fault_of_queries(culler, view, most, least);
}

/// Whether a test of a shadow in this frame takes the exact stage, when boxes are asked one by one. What CullStats counts
/// depends on the instruction set.
bool takes_exact_stage(const Culler& culler, const CullResult& frame, const Camera& camera, const CullOptions& options) {
  bool takes_it = false;
  visit_shadow_tests(culler, frame, camera, options, [&](const culler::Occluder& occluder, const culler::Box& any_box) {
    const auto decide = [&](const auto& box) {
      return kernel::decide(occluder.frustum, box, options.arithmetic, options.test, kernel::NearBoundary::open);
    };
    takes_it = takes_it || std::visit(decide, any_box).stage == kernel::Stage::exact;
  });
  return takes_it;
}

/// What is wrong with the frame of a matrix of the camera.
std::string fault_by_matrix(Random& random, const Culler& culler, const Camera& camera, const CullOptions& options) {
  const culler::MatrixCamera matrix = matrix_of(random, camera);
  return fault(matrix).empty() ? fuzz::fault_of(culler, matrix, options, culler.cull(matrix, options)) : "";
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
  report.tally.stages[takes_exact_stage(culler, result, camera, options) ? 1 : 0] += soup.size();
  std::string wrong = fault_of_frame(culler, camera, options, view);
  if (wrong.empty() && random.chance(0.3)) wrong = fault_by_matrix(random, culler, camera, options);
  if (wrong.empty()) return;
  add_finding(report, "frame", wrong);
}

}  // namespace occlude::fuzz
