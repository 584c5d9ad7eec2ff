// SPDX-License-Identifier: MIT
#include "occlude/render/why.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <variant>

#include "camera/clearance.h"
#include "occlude/render/errors.h"
#include "occlude/render/progress.h"
#include "occlude/render/witness.h"

namespace occlude::render {

ReplayedFrame::ReplayedFrame(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options,
                             std::size_t frame)
    : culler_(culler), options_(options), number_(frame), along_(culler, path, options) {
  const std::size_t begin = frames_of(path, options).front(), end = std::min(options.end, path.frames);
  if (frame < begin || frame >= end) {
    throw InputError(fmt::format("the walk has no frame {}: it has frames {} to {}", frame, begin, end - 1));
  }
  camera_ = path.camera(frame, aspect(options));
  const std::size_t first = along_.has_past() ? begin : frame;
  Progress progress("frame", frame + 1 - first);
  for (std::size_t f = first; f <= frame; ++f) {
    along_.go_to(f);
    along_.cull();
    progress.update(f + 1 - first);
  }
  result_ = &along_.result();
}

namespace {

/// The polygons that hide the culled subtree, or the part of it that contains the polygon.
std::vector<std::uint32_t> cover_of(const ReplayedFrame& frame, std::uint32_t polygon) {
  const auto& [camera, options, result] = frame.source();
  for (const culler::CoverWitness& cover : covers_of(frame.culler(), camera, result, options)) {
    if (polygon >= cover.range.first && polygon - cover.range.first < cover.range.count) return cover.polygons;
  }
  return {};
}

AgainstShadow against(const culler::CullResult& frame, std::uint32_t occluder, const culler::Box& box) {
  const kernel::ShadowFrustum& shadow = frame.occluders[occluder].frustum;
  return {occluder, std::visit([&](const auto& b) { return kernel::clearance(shadow, b); }, box)};
}

}  // namespace

double beyond_view(const culler::Culler& culler, const culler::CullResult& frame, const culler::Culled& culled) {
  return culler.hierarchy().ask(culled.node,
                                [&](const auto& box) { return culler::distance_beyond(frame.view[culled.index], box); });
}

std::vector<AgainstShadow> against_shadows(const culler::Culler& culler, const culler::CullResult& frame,
                                           const culler::Culled& culled) {
  const culler::Box box = culler.hierarchy().volume(culled.node);
  std::vector<AgainstShadow> result{against(frame, culled.index, box)};
  if (culled.second != culler::Culled::kNone) result.push_back(against(frame, culled.second, box));
  return result;
}

Account account_for(const ReplayedFrame& frame, std::uint32_t polygon, const ItemBuffer& items) {
  const culler::Culler& culler = frame.culler();
  const culler::CullResult& result = frame.result();
  Account account;
  account.polygon = polygon;
  account.pixels = items.pixels_of(frame.culler().hierarchy().soup().size())[polygon];
  if (const culler::Culled* cull = culler.cull_of(result, polygon)) {
    account.cull = *cull;
    account.node = cull->node;
    if (cull->by == culler::Culled::By::view) {
      account.beyond_view = beyond_view(culler, result, *cull);
    } else if (cull->by == culler::Culled::By::cover) {
      account.cover = cover_of(frame, polygon);
    } else {
      account.shadows = against_shadows(culler, result, *cull);
    }
    return account;
  }
  account.node = culler.hierarchy().leaf_of(polygon);
  const culler::Box own = culler.hierarchy().soup().box(polygon);
  for (std::uint32_t i = 0; i < result.occluders.size(); ++i) account.shadows.push_back(against(result, i, own));
  std::ranges::stable_sort(account.shadows, std::greater{}, [](const AgainstShadow& a) { return a.clearance.distance; });
  if (account.pixels == 0) {
    const auto& [camera, options, source] = frame.source();
    account.missed = culler::MissedReasons(culler, camera, options, source).answer(polygon);
  }
  return account;
}

}  // namespace occlude::render
