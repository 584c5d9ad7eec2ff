// SPDX-License-Identifier: MIT
#include "hidden_claims.h"

#include <algorithm>
#include <span>

#include "base/parallel.h"

namespace occlude::proof {
namespace {

/// Of one box of a claim: the numbers of the regions that come near it, ascending.
std::vector<std::uint32_t> near(const kernel::Aabb& box, const std::vector<kernel::Aabb>& regions) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < regions.size(); ++i) {
    bool is_near = true;
    for (int axis = 0; axis < 3; ++axis) {
      is_near = is_near && regions[i].min[axis] <= box.max[axis] && box.min[axis] <= regions[i].max[axis];
    }
    if (is_near) result.push_back(i);
  }
  return result;
}

}  // namespace

void HiddenClaims::add(HiddenLine line) {
  if (line.is_claim) {
    claims_.push_back(std::move(line.claim));
    return;
  }
  inside_.insert(inside_.end(), line.inside.begin(), line.inside.end());
  well_inside_.insert(well_inside_.end(), line.well_inside.begin(), line.well_inside.end());
  if (line.polygons.empty()) return;
  for (const std::uint32_t p : line.polygons) hidden_.emplace_back(p, static_cast<std::uint32_t>(regions_.size()));
  regions_.push_back(line.from);
}

HiddenClaims::Settled HiddenClaims::settle(const culler::Checkpoint& checkpoint) {
  std::ranges::sort(hidden_);
  std::ranges::sort(inside_);
  std::ranges::sort(well_inside_);
  Settled all;
  for (std::size_t i = 0; i < claims_.size(); ++i) {
    const Settled of_one = settle_one(i, checkpoint);
    all.claimed += of_one.claimed;
    all.proved += of_one.proved;
    if (!all.first) all.first = of_one.first;
  }
  claims_.clear();
  regions_.clear();
  hidden_.clear();
  inside_.clear();
  well_inside_.clear();
  return all;
}

bool HiddenClaims::is_inside(std::uint32_t p, bool may_touch) const {
  for (std::uint32_t k = 1; k + 1 < polygons_.hierarchy().soup().loop(p).size(); ++k) {
    const culler::FanTriangle triangle{p, k};
    if (!std::ranges::binary_search(well_inside_, triangle) && !(may_touch && std::ranges::binary_search(inside_, triangle)))
      return false;
  }
  return true;
}

HiddenClaims::Settled HiddenClaims::settle_one(std::size_t number, const culler::Checkpoint& checkpoint) const {
  const HiddenClaim& claim = claims_[number];
  std::vector<std::vector<std::uint32_t>> near_box;
  for (const kernel::Aabb& box : claim.from) near_box.push_back(near(box, regions_));
  std::vector<std::size_t> faces;
  for (const auto& [first, count] : claim.faces) {
    for (std::size_t face = first; face < first + count; ++face) faces.push_back(face);
  }

  const auto is_hidden = [&](std::uint32_t p, std::size_t box) {
    const auto of_polygon = std::ranges::equal_range(hidden_, p, {}, &std::pair<std::uint32_t, std::uint32_t>::first);
    std::vector<kernel::Aabb> from;
    for (const std::uint32_t region : near_box[box]) {
      if (std::ranges::binary_search(of_polygon, std::pair{p, region})) from.push_back(regions_[region]);
    }
    return is_covered(claim.from[box], from);
  };
  const auto is_hidden_outside = [&](std::uint32_t p) {
    for (std::size_t side = 0; side < claim.from.size(); ++side) {
      if (!is_hidden(p, side)) return false;
    }
    return true;
  };
  const std::size_t boxes = claim.is_outside ? 1 : claim.from.size();
  std::vector<std::vector<std::size_t>> open(faces.size());  // boxes, of each face
  const auto prove = [&](std::size_t i) {
    for (std::size_t box = 0; box < boxes; ++box) {
      const auto is_proved = [&](std::uint32_t p) {
        return claim.is_outside ? is_inside(p, claim.may_touch) || is_hidden_outside(p) : is_hidden(p, box);
      };
      if (!std::ranges::all_of(polygons_.pieces(faces[i]), is_proved)) open[i].push_back(box);
    }
  };
  culler::parallel_for(faces.size(), prove, checkpoint);

  Settled settled{faces.size() * boxes, faces.size() * boxes, std::nullopt};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    settled.proved -= open[i].size();
    if (!settled.first && !open[i].empty()) settled.first = Open{number, open[i].front(), faces[i]};
  }
  return settled;
}

}  // namespace occlude::proof
