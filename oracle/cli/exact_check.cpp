// SPDX-License-Identifier: MIT
#include "exact_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>

#include "differential/exact_visibility.h"
#include "json_input.h"
#include "occlude/culler/parallel.h"
#include "occlude/render/progress.h"

namespace occlude::cli {

ExactCheck::ExactCheck(const culler::Hierarchy& hierarchy, const render::CameraPath& path, double aspect)
    : hierarchy_(hierarchy), path_(path), aspect_(aspect), triangles_(hierarchy.first_triangle(hierarchy.soup().size())) {}

void ExactCheck::add(std::string_view line) {
  const nlohmann::json witness = parse_object(line);
  const auto frame = member(witness, "frame").get<std::size_t>();
  const auto first = member(witness, "triangles").at(0).get<std::size_t>();
  const auto count = member(witness, "triangles").at(1).get<std::size_t>();
  if (frame >= path_.frames || first > triangles_ || count > triangles_ - first) return;
  std::vector<bool>& culled = culled_.try_emplace(frame, triangles_, false).first->second;
  std::fill_n(culled.begin() + static_cast<std::ptrdiff_t>(first), count, true);
}

ExactCheck::Result ExactCheck::result() const {
  std::vector<std::size_t> frames;
  for (const auto& [frame, culled] : culled_) frames.push_back(frame);
  std::vector<std::vector<std::size_t>> showing(frames.size());  // triangles
  render::Progress progress("exact visibility, frame", frames.size());
  std::mutex mutex;
  std::size_t done = 0;
  culler::parallel_for(frames.size(), [&](std::size_t i) {
    render::check_interrupt();
    const std::vector<bool>& culled = culled_.at(frames[i]);
    const auto shows = fuzz::visible_triangles(hierarchy_.soup(), path_.camera(frames[i], aspect_));
    for (std::size_t t = 0; t < triangles_; ++t) {
      if (culled[t] && shows[t]) showing[i].push_back(t);
    }
    const std::lock_guard lock(mutex);
    progress.update(++done);
  });
  Result result;
  result.frames = frames.size();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (showing[i].empty()) continue;
    if (result.culled_showing == 0) {
      result.first = fmt::format("frame {}: triangle {} is culled and shows", frames[i], showing[i].front());
    }
    result.culled_showing += showing[i].size();
  }
  return result;
}

}  // namespace occlude::cli
