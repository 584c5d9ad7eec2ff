// SPDX-License-Identifier: MIT
#include "sorting.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <unordered_set>

#include "frame/culler_access.h"
#include "occlude/culler/culler.h"
#include "occlude/render/progress.h"
#include "pass.h"
#include "trends.h"

namespace occlude::experiments {
namespace {

/// Steps of about half a decade, steradians: lists of a few candidates to thousands.
constexpr std::array<double, 5> kListThresholds{0.3, 0.1, 0.03, 0.01, 0.003};

struct Candidate {
  double score;
  std::uint32_t occluder;
};

/// The candidates that the culler sorts by area-angle in a frame, in the order of the region's list.
std::vector<Candidate> candidates_of(const culler::Culler& culler, const culler::Camera& camera,
                                     const culler::CullResult& culled) {
  std::vector<Candidate> candidates;
  for (const std::uint32_t i : occluders_of(culler).lists().list(camera.eye).occluders) {
    const culler::PotentialOccluder& occluder = occluders_of(culler)[i];
    const auto is_beyond = [&](const culler::HalfSpace& h) {
      return glm::dot(h.normal, occluder.centre) + h.offset < -occluder.radius;
    };
    if (std::ranges::none_of(culled.view, is_beyond)) candidates.push_back({occluder.area_angle(camera.eye), i});
  }
  return candidates;
}

std::size_t comparisons_of_sort(std::vector<Candidate> candidates) {
  std::size_t comparisons = 0;
  std::ranges::sort(candidates, [&](const Candidate& a, const Candidate& b) {
    ++comparisons;
    return a.score != b.score ? a.score > b.score : a.occluder < b.occluder;
  });
  return comparisons;
}

/// Sums over the frames of a path.
class Counter {
 public:
  void count(const culler::Culler& culler, const culler::Camera& camera, const culler::CullResult& culled) {
    const std::vector<Candidate> candidates = candidates_of(culler, camera, culled);
    if (frames_++ != 0) add(candidates, culled.stats);
    last_.clear();
    for (const Candidate& c : candidates) last_.insert(c.occluder);
  }

  [[nodiscard]] SortPoint mean(double threshold) const {
    const auto each = [&](std::size_t sum) {
      return static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(1, frames_ - 1));
    };
    return {threshold, each(candidates_), each(arrivals_), each(moves_), each(comparisons_), each(anew_)};
  }

 private:
  void add(const std::vector<Candidate>& candidates, const culler::CullStats& stats) {
    candidates_ += candidates.size();
    arrivals_ += static_cast<std::size_t>(
        std::ranges::count_if(candidates, [&](const Candidate& c) { return !last_.contains(c.occluder); }));
    moves_ += stats.sort_moves;
    comparisons_ += stats.sort_comparisons;
    anew_ += comparisons_of_sort(candidates);
  }

  std::size_t frames_ = 0, candidates_ = 0, arrivals_ = 0, moves_ = 0, comparisons_ = 0, anew_ = 0;
  std::unordered_set<std::uint32_t> last_;  ///< the candidates of the frame before
};

std::optional<double> exponent(const std::vector<SortPoint>& points, double SortPoint::*total) {
  std::vector<double> x, y;
  for (const SortPoint& point : points) {
    if (point.candidates == 0 || point.*total == 0) continue;
    x.push_back(point.candidates);
    y.push_back(point.*total);
  }
  return fitted_exponent(x, y);
}

}  // namespace

Sorting measure_sorting(const Subject& subject, const Options& options) {
  Sorting sorting;
  culler::CullOptions cull = options.walk.cull;
  cull.objective.angle = culler::Objective::Angle::area;
  render::Progress progress("sort: lists", kListThresholds.size());
  for (const double threshold : kListThresholds) {
    culler::BuildConfig config = options.walk.build;
    config.lists.threshold = threshold;
    const culler::Culler culler(subject.soup, config, render::check_interrupt);
    culler.prepare(cull.method, render::check_interrupt);
    Counter counter;
    static_cast<void>(pass_along(culler, subject.path, options.walk, cull,
                                 [&](const auto& camera, const auto& culled) { counter.count(culler, camera, culled); }));
    sorting.points.push_back(counter.mean(threshold));
    progress.update(sorting.points.size());
  }
  sorting.moves_exponent = exponent(sorting.points, &SortPoint::moves);
  sorting.comparisons_exponent = exponent(sorting.points, &SortPoint::comparisons);
  sorting.anew_exponent = exponent(sorting.points, &SortPoint::comparisons_anew);
  return sorting;
}

}  // namespace occlude::experiments
