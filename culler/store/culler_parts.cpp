// SPDX-License-Identifier: MIT
// A culler to parts, and from them.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/lazy.h"
#include "cover/cover_triangles.h"
#include "frusta/occluder_set.h"
#include "model/hierarchy_blocks.h"
#include "model/legal_soup.h"
#include "model/part_list.h"
#include "occlude/culler/culler.h"

namespace occlude::culler {
namespace {

constexpr std::string_view kCullerConfig = "config";

/// BuildConfig in numbers of fixed width, without gaps.
struct StoredConfig {
  std::uint32_t leaf_size, bounds, shells, kind;
  double threshold, regions;
  std::uint64_t entries;
};

StoredConfig stored(const BuildConfig& config) {
  return {config.hierarchy.leaf_size,
          static_cast<std::uint32_t>(config.hierarchy.bounds),
          std::uint32_t{config.occluders.shells},
          static_cast<std::uint32_t>(config.lists.kind),
          config.lists.threshold,
          config.lists.regions,
          config.lists.entries};
}

BuildConfig config_of(const PartReader& parts) {
  const auto read = parts.get<StoredConfig>(kCullerConfig);
  if (read.size() != 1 || read[0].bounds > 1 || read[0].shells > 1 || read[0].kind > 1)
    refuse_part(kCullerConfig, "out of range");
  const StoredConfig& config = read[0];
  const ListConfig lists{static_cast<RegionKind>(config.kind), config.threshold, config.regions,
                         static_cast<std::size_t>(config.entries)};
  if (const std::string reason = OccluderLists::fault(lists); !reason.empty()) refuse_part(kCullerConfig, reason);
  return {{config.leaf_size, static_cast<Bounds>(config.bounds)}, {config.shells != 0}, lists};
}

const PartReader& checked(const PartReader& parts) {
  require_rounding();
  return parts;
}

bool is_of_occluders(std::string_view part) { return Culler::method_of(part) == Method::frusta; }

/// Throws std::invalid_argument where lists that are to be made would take more bytes than the model has, so that a few
/// bytes cannot ask for any amount of work. As many regions and entries as by default may always be: they take 130 MiB at
/// most.
void require_lists_within(std::uint64_t bytes, const ListConfig& config, const Space& space) {
  const ListConfig few;
  constexpr std::size_t kBytesOfRegion = 2 * sizeof(Partition::Cell), kBytesOfEntry = sizeof(std::uint32_t);
  const auto made = [&](double regions) { return Partition::most_regions(config.kind, space, regions); };
  if (made(config.regions) > std::max(made(few.regions), static_cast<double>(bytes / kBytesOfRegion)))
    refuse_part(kCullerConfig, "it asks for more regions than its bytes could hold");
  if (config.entries > std::max<std::uint64_t>(few.entries, bytes / kBytesOfEntry))
    refuse_part(kCullerConfig, "it asks for longer lists than its bytes could hold");
}

/// What keeps the parts of a culler: a copy of it, and its settings as they are stored.
struct Kept {
  Culler culler;
  StoredConfig config;
};

}  // namespace

std::optional<Method> Culler::method_of(std::string_view part) {
  if (part == kCullerConfig || part == HierarchyBlocks::kPart || Hierarchy::is_part(part)) return std::nullopt;
  return part.starts_with(CoverTriangles::kPrefix) ? Method::cover : Method::frusta;
}

Parts Culler::parts(const Checkpoint& checkpoint) const {
  const auto kept = std::make_shared<const Kept>(Kept{*this, stored(config_)});
  Parts result{{}, kept};
  PartWriter writer(result);
  writer.put(kCullerConfig, std::span(&kept->config, 1));
  hierarchy_.append_parts(writer);
  blocks(checkpoint).append_parts(writer);
  occluders(checkpoint).append_parts(writer);
  triangles(checkpoint).append_parts(writer);
  return result;
}

Culler::Culler(const Parts& parts, const Checkpoint& checkpoint) : Culler(PartReader(parts), checkpoint) {}

Culler::Culler(const PartReader& parts, const Checkpoint& checkpoint)
    : config_(config_of(checked(parts))),
      hierarchy_(Hierarchy::from_parts(parts, config_.hierarchy, checkpoint)),
      occluders_(std::make_shared<Lazy<OccluderSet>>()),
      blocks_(std::make_shared<Lazy<HierarchyBlocks>>()),
      triangles_(std::make_shared<Lazy<CoverTriangles>>()) {
  static_cast<void>(blocks_->get([&] { return HierarchyBlocks::from_parts(parts, hierarchy_, checkpoint); }));
  if (parts.has_any(is_of_occluders)) {
    static_cast<void>(occluders_->get([&] { return OccluderSet::from_parts(parts, hierarchy_.shared_soup(), checkpoint); }));
  } else {
    require_lists_within(parts.bytes(), config_.lists, Space::of(hierarchy_));
  }
  if (parts.has_any([](std::string_view part) { return method_of(part) == Method::cover; })) {
    static_cast<void>(triangles_->get([&] { return CoverTriangles::from_parts(parts, hierarchy_.soup(), checkpoint); }));
  }
}

}  // namespace occlude::culler
