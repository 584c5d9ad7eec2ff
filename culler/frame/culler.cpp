// SPDX-License-Identifier: MIT
#include "occlude/culler/culler.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/lazy.h"
#include "camera/clearance.h"
#include "frame/begin_frame.h"
#include "frame/next_by_cover.h"
#include "frusta/cull_by_frusta.h"
#include "model/hierarchy_blocks.h"
#include "model/legal_soup.h"
#include "occlude/kernel/clearance.h"

namespace occlude::culler {
namespace {

const BuildConfig& checked(const BuildConfig& config) {
  if (const std::string reason = OccluderLists::fault(config.lists); !reason.empty()) throw std::invalid_argument(reason);
  return config;
}

PolygonSoup checked(PolygonSoup soup) {
  require_legal(soup);
  if (soup.empty()) throw std::invalid_argument("the soup has no polygon");
  return soup;
}

}  // namespace

Culler::Culler(PolygonSoup soup, const BuildConfig& config, const Checkpoint& checkpoint)
    : config_(checked(config)),
      hierarchy_(Hierarchy::build(checked(std::move(soup)), config.hierarchy, checkpoint)),
      occluders_(std::make_shared<Lazy<OccluderSet>>()),
      blocks_(std::make_shared<Lazy<HierarchyBlocks>>()),
      triangles_(std::make_shared<Lazy<CoverTriangles>>()) {}

Culler::Culler(const Culler& other, OccluderSet occluders)
    : config_(other.config_),
      hierarchy_(other.hierarchy_),
      occluders_(std::make_shared<Lazy<OccluderSet>>()),
      blocks_(other.blocks_),
      triangles_(other.triangles_) {
  static_cast<void>(occluders_->get([&] { return std::move(occluders); }));
}

const OccluderSet& Culler::occluders(const Checkpoint& checkpoint) const {
  return occluders_->get([&] {
    require_rounding();
    return OccluderSet::build(hierarchy_.shared_soup(), Space::of(hierarchy_), config_.occluders, config_.lists, checkpoint);
  });
}

const CoverTriangles& Culler::triangles(const Checkpoint& checkpoint) const {
  return triangles_->get([&] {
    require_rounding();
    return CoverTriangles::find(hierarchy_.soup(), checkpoint);
  });
}

const HierarchyBlocks& Culler::blocks(const Checkpoint& checkpoint) const {
  return blocks_->get([&] {
    require_rounding();
    return HierarchyBlocks(hierarchy_, checkpoint);
  });
}

BlockTree Culler::tree() const { return blocks().tree(); }

void Culler::prepare(Method method, const Checkpoint& checkpoint) const {
  if (is_by_cover(method)) {
    static_cast<void>(triangles(checkpoint));
  } else {
    static_cast<void>(occluders(checkpoint));
  }
  static_cast<void>(blocks(checkpoint));  // last: to make the others takes most memory, and blocks would add to that
}

template <class AnyCamera>
CullResult Culler::cull_alone(const AnyCamera& camera, const CullOptions& options) const {
  View view;
  CullOptions alone = options;
  alone.probes = 0;  // there is no next frame
  cull(camera, alone, view);
  return std::move(memory_of(view).frame.result);
}

template <class AnyCamera>
const CullResult& Culler::cull_next(const AnyCamera& camera, const CullOptions& options, View& view) const {
  require_sound(camera);
  View::Memory& memory = memory_for(view, occluders_);
  // In the order of prepare().
  const bool is_cover = is_by_cover(options.method);
  const CoverTriangles* const triangles = is_cover ? &this->triangles() : nullptr;
  const OccluderSet* const occluders = !is_cover && options.occluders > 0 ? &this->occluders() : nullptr;
  const BlockTree tree = this->tree();
  begin_frame(hierarchy_, camera, options, memory);
  if (is_cover) {
    next_by_cover(hierarchy_, tree, *triangles, options, memory);
  } else {
    cull_by_frusta(hierarchy_, tree, occluders, options, memory.frame, memory.frusta);
  }
  return memory.frame.result;
}

CullResult Culler::cull(const Camera& camera, const CullOptions& options) const { return cull_alone(camera, options); }
CullResult Culler::cull(const MatrixCamera& camera, const CullOptions& options) const { return cull_alone(camera, options); }

const CullResult& Culler::cull(const Camera& camera, const CullOptions& options, View& view) const {
  return cull_next(camera, options, view);
}
const CullResult& Culler::cull(const MatrixCamera& camera, const CullOptions& options, View& view) const {
  return cull_next(camera, options, view);
}

void Culler::append_witnesses(const CullResult& frame, std::vector<Witness>& witnesses) const {
  for (const Culled& cull : frame.culled) {
    double margin = 0;
    if (cull.by == Culled::By::view) {
      margin = hierarchy_.ask(cull.node, [&](const auto& box) { return distance_beyond(frame.view[cull.index], box); });
    } else if (cull.by == Culled::By::shadow && cull.second == Culled::kNone) {
      const kernel::ShadowFrustum& shadow = frame.occluders[cull.index].frustum;
      margin = hierarchy_.ask(cull.node, [&](const auto& box) { return certain_distance(shadow, box); });
    }
    witnesses.push_back({cull, std::max(margin, 0.0)});
  }
}

const Culled* Culler::cull_of(const CullResult& frame, std::uint32_t p) const {
  const auto nodes = hierarchy_.nodes();
  // Subtrees are culled in the order of the tree.
  const auto after = std::upper_bound(frame.culled.begin(), frame.culled.end(), p,
                                      [&](std::uint32_t q, const Culled& c) { return q < nodes[c.node].first; });
  if (after == frame.culled.begin()) return nullptr;
  const Culled& last = *std::prev(after);
  return p - nodes[last.node].first < nodes[last.node].count ? &last : nullptr;
}

}  // namespace occlude::culler
