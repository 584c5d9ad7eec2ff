// SPDX-License-Identifier: MIT
#include "occluder_choice.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "bounds.h"
#include "occlude/kernel/overlap.h"

namespace occlude::culler {
namespace {

struct Candidate {
  double score;
  std::uint32_t region;

  /// Best first; equals by their number, so that the choice never depends on the sorting algorithm.
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return a.score != b.score ? a.score > b.score : a.region < b.region;
  }
};

/// Whether the box is beyond one of the half-spaces. A heuristic question: rounding may answer it either way.
bool out_of_view(const kernel::Aabb& box, std::span<const HalfSpace> view) {
  return std::any_of(view.begin(), view.end(), [&](const HalfSpace& h) {
    const glm::dvec3 farthest{h.normal.x >= 0 ? box.max.x : box.min.x, h.normal.y >= 0 ? box.max.y : box.min.y,
                              h.normal.z >= 0 ? box.max.z : box.min.z};
    return glm::dot(h.normal, farthest) + h.offset < 0;
  });
}

/// The camera's view of a region in steradians, or for parallel rays its area as projected over the picture's.
double score(const PotentialOccluder& occluder, const Camera& camera, const glm::dvec3& forward) {
  if (camera.projection == Projection::perspective) return occluder.area_angle(camera.eye);
  return std::fabs(glm::dot(occluder.area_normal, forward)) / (camera.height * camera.height * camera.aspect);
}

std::vector<Candidate> candidates(const OccluderGrid& grid, const Camera& camera, std::span<const HalfSpace> view,
                                  CullStats& stats) {
  const auto list = grid.list(camera.eye);
  const glm::dvec3 forward = camera.axes().forward;
  std::vector<Candidate> result;
  for (const std::uint32_t region : list) {
    const PotentialOccluder& occluder = grid.occluder(region);
    if (!out_of_view(occluder.box, view)) result.push_back({score(occluder, camera, forward), region});
  }
  stats.potential_occluders = list.size();
  stats.occluders_in_view = result.size();
  return result;
}

/// The least depth of a vertex at which the renderer is sure not to clip it: the near plane and a margin far above the
/// rounding of its single precision, 2^-23 of the distances involved.
constexpr double kNearMargin = 1 + 0x1p-10;

bool clipped_by_near_plane(std::span<const kernel::Vec3> loop, const Camera& camera, const glm::dvec3& forward) {
  return std::any_of(loop.begin(), loop.end(), [&](const kernel::Vec3& v) {
    return glm::dot(glm::dvec3{v.x, v.y, v.z} - camera.eye, forward) < camera.near * kNearMargin;
  });
}

/// A polygon whose whole is an occluder already adds nothing. Mostly it looks smaller than its whole and comes later; where
/// that was refused or clipped, the polygon may still do.
bool is_part_of_chosen(const std::vector<Occluder>& chosen, const ConvexRegions& regions, std::uint32_t region) {
  const std::uint32_t whole = regions.whole(regions.parts(region)[0]);
  return whole != region && std::ranges::find(chosen, whole, &Occluder::region) != chosen.end();
}

bool in_shadow_of(const std::vector<Occluder>& chosen, const kernel::Aabb& box) {
  return std::any_of(chosen.begin(), chosen.end(), [&](const Occluder& o) {
    return kernel::conservative_certified(o.frustum, box, kernel::NearBoundary::open).relation == kernel::Relation::inside;
  });
}

/// Takes candidates as long as there is room.
class Choice {
 public:
  Choice(const PolygonSoup& soup, const ConvexRegions& regions, const OccluderGrid& grid, const Camera& camera,
         const CullOptions& options)
      : soup_(soup), regions_(regions), grid_(grid), camera_(camera), options_(options), forward_(camera.axes().forward) {}

  /// The best `most` of them that can be occluders, and no more than there is room for.
  void take(std::vector<Candidate>& candidates, std::size_t most) {
    const auto worse = [](const Candidate& a, const Candidate& b) { return b < a; };
    std::make_heap(candidates.begin(), candidates.end(), worse);
    while (!candidates.empty() && most > 0 && chosen_.size() < options_.occluders) {
      std::pop_heap(candidates.begin(), candidates.end(), worse);
      if (take(candidates.back().region)) --most;
      candidates.pop_back();
    }
  }

  [[nodiscard]] std::vector<Occluder> chosen() && { return std::move(chosen_); }

 private:
  bool take(std::uint32_t region) {
    loop_.clear();
    for (const std::uint32_t i : regions_.loop(region)) loop_.push_back(to_kernel(soup_.vertices[i]));
    if (is_part_of_chosen(chosen_, regions_, region) || clipped_by_near_plane(loop_, camera_, forward_) ||
        in_shadow_of(chosen_, grid_.occluder(region).box)) {
      return false;
    }
    const bool perspective = camera_.projection == Projection::perspective;
    const auto viewpoint =
        perspective ? kernel::Viewpoint::eye(to_kernel(camera_.eye)) : kernel::Viewpoint::direction(to_kernel(forward_));
    auto [frustum, refusal] = kernel::ShadowFrustum::make(viewpoint, loop_, options_.near);
    if (frustum) chosen_.push_back({region, std::move(*frustum)});
    return frustum.has_value();
  }

  const PolygonSoup& soup_;
  const ConvexRegions& regions_;
  const OccluderGrid& grid_;
  const Camera& camera_;
  const CullOptions& options_;
  glm::dvec3 forward_;
  std::vector<kernel::Vec3> loop_;
  std::vector<Occluder> chosen_;
};

/// Of eight occluders three are tried, whatever the others hid: with fewer the good ones are found too late, with more they
/// have no room.
std::size_t proven_share(std::size_t occluders) { return occluders - occluders * 3 / 8; }

}  // namespace

std::vector<Occluder> choose_occluders(const PolygonSoup& soup, const ConvexRegions& regions, const OccluderGrid& grid,
                                       const OccluderHistory& history, const Camera& camera, std::span<const HalfSpace> view,
                                       const CullOptions& options, CullStats& stats) {
  if (options.occluders == 0) return {};
  std::vector<Candidate> proven, untried, idle;
  for (const Candidate& candidate : candidates(grid, camera, view, stats)) {
    const auto hidden = history.hidden(candidate.region);
    if (!hidden) {
      untried.push_back(candidate);
    } else if (*hidden != 0) {
      proven.push_back({static_cast<double>(*hidden), candidate.region});
    } else {
      idle.push_back(candidate);
    }
  }
  Choice choice(soup, regions, grid, camera, options);
  choice.take(proven, proven_share(options.occluders));
  choice.take(untried, options.occluders);
  choice.take(proven, options.occluders);
  choice.take(idle, options.occluders);
  return std::move(choice).chosen();
}

}  // namespace occlude::culler
