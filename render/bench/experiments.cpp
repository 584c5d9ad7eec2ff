// SPDX-License-Identifier: MIT
#include "experiments.h"

#include <algorithm>
#include <utility>

#include "occlude/culler/culler.h"
#include "occlude/render/progress.h"
#include "occlude/render/stopwatch.h"

namespace occlude::experiments {
namespace {

/// A walk that writes no files.
render::WalkResult walk_without_files(const Subject& subject, const render::WalkOptions& options) {
  const render::Stopwatch stopwatch;
  const culler::Culler culler = make_culler(subject.soup, options);
  const double preprocess_s = stopwatch.seconds();
  render::WalkResult result = walk_beside(culler, subject.path, options);
  result.preprocess_s = preprocess_s;
  return result;
}

}  // namespace

Result run(const Subject& subject, const Options& options, const std::vector<std::string>& chosen) {
  const auto is_chosen = [&](const char* name) { return std::ranges::find(chosen, name) != chosen.end(); };
  const std::vector<std::size_t> frames = frames_of(subject.path, options.walk);
  Result result;
  result.model = subject.name;
  result.polygons = subject.soup.size();
  result.first_frame = frames.front();
  result.last_frame = frames.back();
  result.frames = frames.size();
  if (is_chosen("table2")) {
    render::WalkResult walk = walk_without_files(subject, options.walk);
    const std::vector<render::WalkOptions> beside = render::options_beside(options.walk);
    std::vector<render::WalkResult> results;
    std::vector<render::MethodWalk> walks{{&options.walk, &walk}};
    results.reserve(beside.size());  // walks refer to them
    for (const render::WalkOptions& other : beside) {
      results.push_back(walk_without_files(subject, other));
      walks.push_back({&other, &results.back()});
    }
    result.table2 = summarise(walk, options.walk, subject.name);
    result.table2->methods = render::methods_of(walks, options.walk.render);
    result.walked = std::move(walk.frames);
  }
  if (is_chosen("figure4")) result.figure4 = measure_figure4(subject, options);
  if (is_chosen("sweeps")) result.sweeps = measure_sweeps(subject, options);
  if (is_chosen("sort")) result.sort = measure_sorting(subject, options);
  if (is_chosen("joined")) result.joined = measure_joined(subject, options);
  if (is_chosen("occluders")) result.occluders = measure_occluders(subject, options);
  if (is_chosen("threads")) result.threads = measure_threads(subject, options);
  if (is_chosen("growth")) result.growth = measure_growth(options);
  return result;
}

}  // namespace occlude::experiments
