// SPDX-License-Identifier: MIT
#include "exact_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "differential/exact_visibility.h"
#include "occlude/culler/parallel.h"
#include "occlude/render/progress.h"

namespace occlude::cli {

ExactCheck::ExactCheck(const culler::Hierarchy& hierarchy, const render::CameraPath& path, double aspect)
    : hierarchy_(hierarchy), path_(path), aspect_(aspect), triangles_(hierarchy.first_triangle(hierarchy.soup().size())) {}

void ExactCheck::add(const Proof& proof) {
  if (proof.count == 0) return;
  std::vector<bool>& culled = culled_.try_emplace(proof.frame, triangles_, false).first->second;
  std::fill_n(culled.begin() + static_cast<std::ptrdiff_t>(proof.first), proof.count, true);
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
