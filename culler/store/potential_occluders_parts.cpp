// SPDX-License-Identifier: MIT
// The parts of potential occluders, and the checks of parts that are said to be those.
#include <cmath>
#include <string_view>
#include <utility>

#include "base/part_checks.h"
#include "frusta/potential_occluders.h"
#include "model/part_list.h"

namespace occlude::culler {
namespace {

constexpr std::string_view kOccluderKnown = "known";

/// Whether the choice of occluders can compute with it: of coordinates of up to 2^100, areas are below 2^210, and their
/// products with distances far from infinity.
bool is_finite(const PotentialOccluder& known) {
  bool is = true;
  for (const double x : {known.centre.x, known.centre.y, known.centre.z, known.area_normal.x, known.area_normal.y,
                         known.area_normal.z, known.round_area, known.radius}) {
    is &= std::fabs(x) <= 0x1p210;
  }
  return is;
}

}  // namespace

void PotentialOccluders::append_parts(PartWriter& parts) const {
  regions_.append_parts(parts);
  shells_.append_parts(parts);
  parts.put(kOccluderKnown, known_);
}

PotentialOccluders PotentialOccluders::from_parts(const PartReader& parts, SharedSoup shared, const Checkpoint& checkpoint) {
  PotentialOccluders result;
  result.regions_ = ConvexRegions::from_parts(parts, shared.view, checkpoint);
  result.shells_ = ConvexShells::from_parts(parts, shared, checkpoint);
  result.soup_ = std::move(shared);
  result.known_ = parts.get<PotentialOccluder>(kOccluderKnown);
  if (result.known_.size() != result.regions_.size() + result.shells_.size() ||
      !are_all(
          result.known_.size(), [&](std::size_t i) { return is_finite(result.known_[i]); }, checkpoint)) {
    refuse_part(kOccluderKnown, "it is not about these occluders");
  }
  return result;
}

}  // namespace occlude::culler
