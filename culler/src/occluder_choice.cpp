// SPDX-License-Identifier: MIT
#include "occluder_choice.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "bounds.h"
#include "occlude/kernel/overlap.h"
#include "plane_work.h"
#include "single_precision.h"
#include "solid_angle.h"

namespace occlude::culler {
namespace {

/// Whether the ball about an occluder is beyond one of the half-spaces. A heuristic question: rounding may answer it either
/// way.
bool out_of_view(const PotentialOccluder& occluder, std::span<const HalfSpace> view) {
  return std::ranges::any_of(
      view, [&](const HalfSpace& h) { return glm::dot(h.normal, occluder.centre) + h.offset < -occluder.radius; });
}

double weighted(double criterion, double weight) {
  return weight == 0 ? 1 : weight == 1 ? criterion : std::pow(criterion, weight);
}

/// Frusta go from one occluder to another, and would grow again and again until each of them has been the largest. Nearly
/// all have no more planes, those of the profile included.
constexpr std::size_t kPlanes = 64;

/// Probes are chosen of so many that were not tried lately.
constexpr std::size_t kPool = 64;
/// Cosine of the angle within which occluders are near each other, and how much the best of all occluders raises the score
/// of what is near it. Of 0, 3 and 10, and of the cosines 0.95 and 0.8, these two cull most on the paths through the city,
/// Utrecht, the castle and Sponza together.
constexpr double kNear = 0.8, kNeighbour = 10;

class Choice {
 public:
  Choice(const OccluderSource& source, const Camera& camera, double depth, const CullOptions& options, View::Memory& memory)
      : source_(source),
        camera_(camera),
        depth_(depth),
        options_(options),
        memory_(memory),
        forward_(camera.axes().forward),
        viewpoint_(camera.viewpoint()),
        work_(kChoiceWorkOfEach * options.occluders) {}

  void run() {
    sort_candidates();
    forget_trials();
    const bool is_coherent = options_.objective.coherence != 0;
    if (is_coherent) take_proven();
    take_best([&](std::uint32_t i) { return !is_coherent || !memory_.history.hidden(i); });
    take_best([](std::uint32_t) { return true; });
    if (is_coherent) take_probes();
    memory_.result.stats.choice_work = kChoiceWorkOfEach * options_.occluders - work_.left();
  }

 private:
  /// The region's list, narrowed to the view frustum, by the criteria that do not depend on earlier frames.
  void sort_candidates() {
    const auto [listed, hidden] = source_.grid.list(camera_.eye);
    const Objective& objective = options_.objective;
    std::vector<Candidate>& candidates = memory_.candidates;
    candidates.clear();
    for (std::size_t i = 0; i < listed.size(); ++i) {
      if (out_of_view(source_.occluders[listed[i]], memory_.result.view)) continue;
      double score = weighted(size_of(listed[i]), objective.solid_angle);
      if (!hidden.empty()) score *= weighted(1 + double{hidden[i]}, objective.depth_complexity);
      candidates.push_back({score, listed[i]});
    }
    memory_.order.update(candidates, source_.occluders.size());
    CullStats& stats = memory_.result.stats;
    stats.potential_occluders = listed.size();
    stats.occluders_in_view = candidates.size();
    stats.sort_kept = memory_.order.kept();
    stats.sort_moves = memory_.order.moves();
  }

  double size_of(std::uint32_t i) const {
    return seen_size(source_.soup, source_.occluders, i, camera_, forward_, options_.objective.angle);
  }

  /// What hid something lately and is in view, whatever the region lists.
  void take_proven() {
    const Objective& objective = options_.objective;
    std::vector<Candidate>& proven = memory_.candidates;
    proven.clear();
    for (const auto& [occluder, frame, hidden] : memory_.history.recent()) {
      if (hidden == 0 || out_of_view(source_.occluders[occluder], memory_.result.view)) continue;
      proven.push_back(
          {weighted(size_of(occluder), objective.solid_angle) * weighted(hidden, objective.coherence), occluder});
    }
    std::sort(proven.begin(), proven.end());
    for (const Candidate& c : proven) {
      if (is_full()) return;
      static_cast<void>(take(c.occluder));
    }
  }

  /// Candidates that pass, best first, while there is room.
  template <class Passes>
  void take_best(Passes&& passes) {
    for (const Candidate& c : memory_.order.best_first()) {
      if (is_full()) return;
      if (passes(c.occluder)) static_cast<void>(take(c.occluder));
    }
  }

  /// The best of what was not tried lately; those near a good occluder in the picture come first.
  void take_probes() {
    std::vector<Candidate>& pool = memory_.candidates;
    pool.clear();
    for (const Candidate& c : memory_.order.best_first()) {
      if (pool.size() == kPool) break;
      if (memory_.history.hidden(c.occluder)) continue;
      const double good = 1 + kNeighbour * goodness_near(c.occluder);
      pool.push_back({c.score * weighted(good, options_.objective.coherence), c.occluder});
    }
    std::sort(pool.begin(), pool.end());
    are_probes_ = true;
    for (const Candidate& c : pool) {
      if (memory_.probes.size() >= options_.probes || !work_.is_left()) return;
      static_cast<void>(take(c.occluder));
    }
  }

  /// The most that an occluder of this frame near this one in the picture hid lately, as a share of what any of them did.
  double goodness_near(std::uint32_t i) const {
    const glm::dvec3 direction = direction_of(i);
    double near = 0, most = 1;
    for (const Occluder& o : memory_.result.occluders) {
      const double hidden = memory_.history.hidden(o.index).value_or(0);
      most = std::max(most, hidden);
      if (glm::dot(direction, direction_of(o.index)) > kNear) near = std::max(near, hidden);
    }
    return near / most;
  }

  /// From the eye to the middle of an occluder.
  glm::dvec3 direction_of(std::uint32_t i) const {
    const glm::dvec3 v = source_.occluders[i].centre - camera_.eye;
    const double length = glm::length(v);
    return length > 0 ? v / length : forward_;
  }

  std::vector<Occluder>& chosen() { return memory_.result.occluders; }
  bool is_full() { return chosen().size() >= options_.occluders || !work_.is_left(); }

  void forget_trials() {
    memory_.trials.resize(source_.occluders.size(), Trial::none);
    for (const std::uint32_t i : memory_.tried) memory_.trials[i] = Trial::none;
    memory_.tried.clear();
  }

  /// Whether the occluder, or a larger one that it is a part of, is chosen from now on, or a probe. Parts are for where
  /// their whole cannot be used.
  bool take(std::uint32_t i) {
    const std::uint32_t container = source_.occluders.container(i);
    if (container != i && take(container)) return true;
    if (memory_.trials[i] == Trial::none) {
      memory_.tried.push_back(i);
      memory_.trials[i] = is_usable(i) && add(i) ? Trial::taken : Trial::refused;
    }
    return memory_.trials[i] == Trial::taken;
  }

  bool is_usable(std::uint32_t i) {
    if (!work_.is_left()) return false;
    source_.occluders.vertices(source_.soup, i, memory_.loop);
    work_.take(memory_.loop.size());
    return !may_be_clipped(camera_, depth_, memory_.loop) && !is_in_shadow();
  }

  bool is_in_shadow() {
    kernel::Aabb box = empty_box();
    for (const kernel::Vec3& v : memory_.loop) grow(box, v);
    return std::ranges::any_of(chosen(), [&](const Occluder& o) {
      const kernel::Decision found = kernel::conservative_certified(o.frustum, box, kernel::NearBoundary::open);
      work_.take(o.frustum, found.stage);
      return found.relation == kernel::Relation::inside;
    });
  }

  bool add(std::uint32_t i) {
    std::vector<kernel::ShadowFrustum>& spare = memory_.spare;
    if (spare.empty()) spare.emplace_back().reserve(kPlanes);
    const bool is_shell = source_.occluders.is_shell(i);
    const kernel::Refusal refusal =
        is_shell ? add_shell(i, spare.back()) : spare.back().assign(viewpoint_, memory_.loop, options_.near);
    if (refusal != kernel::Refusal::none) {
      work_.take(PlaneWork::kExact);  // such a viewpoint is where signs are zero
      return false;
    }
    (are_probes_ ? memory_.probes : chosen()).push_back({i, std::move(spare.back()), 0});
    spare.pop_back();
    return true;
  }

  kernel::Refusal add_shell(std::uint32_t i, kernel::ShadowFrustum& frustum) {
    const kernel::ConvexPolytope& polytope = source_.occluders.polytope(i);
    kernel::PolytopeSilhouette& seen = memory_.silhouettes[i];
    const kernel::Refusal refusal = frustum.assign(viewpoint_, polytope, options_.near, seen);
    memory_.result.stats.silhouette_faces += polytope.faces().size();
    memory_.result.stats.silhouette_faces_asked += seen.faces_asked();
    return refusal;
  }

  const OccluderSource& source_;
  const Camera& camera_;
  const double depth_;  ///< of the model
  const CullOptions& options_;
  View::Memory& memory_;
  glm::dvec3 forward_;
  kernel::Viewpoint viewpoint_;
  PlaneWork work_;
  bool are_probes_ = false;  ///< whether what is taken only probes
};

/// Whether the silhouettes meet in two corners: between occluders that share an edge nothing shows.
bool share_an_edge(const kernel::ShadowFrustum& a, const kernel::ShadowFrustum& b) {
  return std::ranges::count_if(a.silhouette(), [&](const kernel::Vec3& v) {
           return std::ranges::find(b.silhouette(), v) != b.silhouette().end();
         }) >= 2;
}

/// Pairs among the best occluders come before pairs with the next.
void pair_neighbours(std::span<const Occluder> occluders, std::vector<ShadowPair>& pairs) {
  const std::size_t most = ShadowPair::kMostOfEach * occluders.size();
  for (std::uint32_t second = 1; second < occluders.size(); ++second) {
    for (std::uint32_t first = 0; first < second; ++first) {
      if (!share_an_edge(occluders[first].frustum, occluders[second].frustum)) continue;
      pairs.push_back({first, second});
      if (pairs.size() == most) return;
    }
  }
}

}  // namespace

bool may_be_clipped(const Camera& camera, double depth, std::span<const kernel::Vec3> vertices) {
  const glm::dvec3 forward = camera.axes().forward;
  const double least = camera.near + kDepthMargin * depth;
  return std::ranges::any_of(vertices,
                             [&](const kernel::Vec3& v) { return glm::dot(to_glm(v) - camera.eye, forward) < least; });
}

void choose_occluders(const OccluderSource& source, const Camera& camera, double depth, const CullOptions& options,
                      View::Memory& memory) {
  if (options.occluders == 0) return;
  Choice(source, camera, depth, options, memory).run();
  if (options.unions) pair_neighbours(memory.result.occluders, memory.result.pairs);
}

}  // namespace occlude::culler
