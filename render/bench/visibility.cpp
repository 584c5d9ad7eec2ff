// SPDX-License-Identifier: MIT
#include "visibility.h"

#include <algorithm>
#include <memory>

#include "bench.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/processor_time.h"
#include "occlude/render/progress.h"
#include "occlude/render/scene_renderer.h"
#include "own_ways.h"

namespace occlude::experiments {
namespace {

using culler::PolygonRange;

/// A prepared way and what it has shown so far.
struct VisibilityTrial {
  std::unique_ptr<VisibilityWay> way;
  WayResult result;
  std::vector<std::vector<double>> cull_ms;  ///< of each frame, a number for each round
  std::size_t drawn = 0, hidden_culled = 0;  ///< polygons, over all frames
};

/// Counts what the ways have culled, in item buffers of the whole model.
class Judge {
 public:
  Judge(culler::SoupView soup, const render::WalkOptions& walk) : soup_(soup), renderer_(soup, walk.width, walk.height) {}

  /// The ways have culled for this camera; the first is the view frustum alone.
  void judge(const culler::Camera& camera, std::vector<VisibilityTrial>& trials) {
    const PolygonRange all = soup_.all();
    const render::ItemBuffer shown = renderer_.item_buffer(camera, std::span(&all, 1));
    std::vector<bool> is_shown;
    for (const std::uint32_t pixels : shown.pixels_of(soup_.size())) is_shown.push_back(pixels != 0);
    const std::vector<bool> is_in_view = culler::polygons_of(trials.front().way->drawn(), soup_.size());
    for (VisibilityTrial& trial : trials) {
      render::check_interrupt();
      const std::vector<PolygonRange> ranges = trial.way->drawn();
      const std::vector<bool> is_drawn = culler::polygons_of(ranges, soup_.size());
      for (std::size_t p = 0; p < soup_.size(); ++p) {
        if (is_drawn[p]) ++trial.drawn;
        if (is_in_view[p] && !is_shown[p] && !is_drawn[p]) ++trial.hidden_culled;
        if (is_shown[p] && !is_drawn[p]) ++trial.result.false_culls;
      }
      trial.result.wrong_pixels += different(shown, renderer_.item_buffer(camera, ranges));
    }
    for (std::size_t p = 0; p < soup_.size(); ++p) {
      if (is_in_view[p] && !is_shown[p]) ++hidden_;
    }
  }

  /// Polygons over all frames.
  [[nodiscard]] std::size_t hidden() const { return hidden_; }

 private:
  static std::size_t different(const render::ItemBuffer& a, const render::ItemBuffer& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] != b.pixels[i] ? 1U : 0U;
    return count;
  }

  culler::SoupView soup_;
  render::SceneRenderer renderer_;
  std::size_t hidden_ = 0;
};

std::vector<VisibilityTrial> prepare(const std::vector<UnpreparedWay>& ways, std::size_t frames) {
  std::vector<VisibilityTrial> trials;
  render::Progress progress("prepared", ways.size());
  for (const UnpreparedWay& way : ways) {
    render::check_interrupt();
    VisibilityTrial trial;
    const render::ProcessorTime time(render::ProcessorTime::Of::process);
    trial.way = way.prepare();
    trial.result.prepare_ms = time.milliseconds();
    trial.result.project = way.project;
    trial.result.name = way.name;
    trial.cull_ms.resize(frames);
    trials.push_back(std::move(trial));
    progress.update(trials.size());
  }
  return trials;
}

/// Each way culls the frame, beginning with another one from frame to frame and from round to round: whoever comes later
/// finds caches warm or cold.
void cull_frame(std::vector<VisibilityTrial>& trials, std::size_t i, std::size_t frame, const culler::Camera& camera,
                std::size_t round) {
  for (std::size_t k = 0; k < trials.size(); ++k) {
    render::check_interrupt();
    VisibilityTrial& trial = trials[(k + i + round) % trials.size()];
    trial.way->move_to(frame);
    const render::ProcessorTime time(render::ProcessorTime::Of::thread);
    trial.way->cull(camera);
    trial.cull_ms[i].push_back(time.milliseconds());
  }
}

/// Every way culls all frames in every round. After the first round, which is judged and warms up, times count.
void cull_in_rounds(const Subject& subject, const VisibilityOptions& options, const std::vector<std::size_t>& frames,
                    std::vector<VisibilityTrial>& trials, Judge& judge) {
  render::Progress progress("frame", frames.size() * (options.repetitions + 1));
  std::size_t done = 0;
  for (std::size_t round = 0; round <= options.repetitions; ++round) {
    for (VisibilityTrial& trial : trials) trial.way->restart();
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const culler::Camera camera = subject.path.camera(frames[i], aspect(options.walk));
      cull_frame(trials, i, frames[i], camera, round);
      if (round == 0) judge.judge(camera, trials);
      progress.update(++done);
    }
    if (round > 0) continue;
    for (VisibilityTrial& trial : trials) std::ranges::for_each(trial.cull_ms, [](auto& times) { times.clear(); });
  }
}

WayResult summarise(VisibilityTrial& trial, std::size_t hidden) {
  WayResult& result = trial.result;
  const auto frames = static_cast<double>(trial.cull_ms.size());
  for (const std::vector<double>& times : trial.cull_ms) {
    const double median = bench::median(times);
    result.cull_ms += median / frames;
    result.worst_cull_ms = std::max(result.worst_cull_ms, median);
  }
  result.drawn = static_cast<double>(trial.drawn) / frames;
  if (hidden > 0) result.hidden_culled = static_cast<double>(trial.hidden_culled) / static_cast<double>(hidden);
  return result;
}

}  // namespace

VisibilityResult measure_visibility(const Subject& subject, const VisibilityOptions& options) {
  const std::vector<std::size_t> frames = frames_of(subject.path, options.walk);
  const auto context = render::make_offscreen_context();
  VisibilityResult result;
  result.model = subject.name;
  result.polygons = subject.soup.size();
  result.frames = frames.size();
  const render::ProcessorTime time(render::ProcessorTime::Of::process);
  const auto tree = culler::Hierarchy::build(subject.soup, options.walk.build.hierarchy, render::check_interrupt);
  result.tree_ms = time.milliseconds();
  result.leaves = static_cast<std::size_t>(std::ranges::count_if(tree.nodes(), &culler::HierarchyNode::is_leaf));
  std::vector<UnpreparedWay> ways = own_ways(subject, options.walk);
  for (const Rival& rival : rivals(tree, options.pictures)) {
    result.rivals.push_back(rival.project);
    ways.insert(ways.end(), rival.ways.begin(), rival.ways.end());
  }
  std::vector<VisibilityTrial> trials = prepare(ways, frames.size());
  Judge judge(tree.soup(), options.walk);
  cull_in_rounds(subject, options, frames, trials, judge);
  for (VisibilityTrial& trial : trials) result.ways.push_back(summarise(trial, judge.hidden()));
  result.in_view = result.ways.front().drawn;
  result.hidden = static_cast<double>(judge.hidden()) / static_cast<double>(frames.size());
  return result;
}

const WayResult& way_of(const VisibilityResult& result, const std::string& name) {
  return *std::ranges::find(result.ways, name, &WayResult::name);
}

}  // namespace occlude::experiments
