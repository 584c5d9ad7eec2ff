// SPDX-License-Identifier: MIT
// Whether the lines of a file prove all that its claims say.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "hidden_proof.h"
#include "occlude/culler/executor.h"

namespace occlude::proof {

/// Claims, and what is proved of them.
class HiddenClaims {
 public:
  /// REQUIRES: `polygons` outlives the object.
  explicit HiddenClaims(const ModelPolygons& polygons) : polygons_(polygons) {}

  /// Takes a line without a failure. What is proved counts for all claims that were added.
  void add(HiddenLine line);
  /// Whether something was proved.
  [[nodiscard]] bool has_proofs() const { return !regions_.empty() || !inside_.empty() || !well_inside_.empty(); }

  /// A face that is not proved to be hidden from all of a box of a claim.
  struct Open {
    std::size_t claim, box, face;
  };
  /// Pairs of a box and a face. From outside there is one box.
  struct Settled {
    std::size_t claimed = 0, proved = 0;
    std::optional<Open> first;  ///< that is not proved
  };
  /// What of the claims is proved. Then they are forgotten, and so is what was proved. A face is hidden from a box if, of
  /// each of its pieces, the boxes from which that is hidden cover the box together; from outside also if a closed shell has
  /// all its triangles inside.
  [[nodiscard]] Settled settle(const culler::Checkpoint& checkpoint);

 private:
  [[nodiscard]] Settled settle_one(std::size_t claim, const culler::Checkpoint& checkpoint) const;
  [[nodiscard]] bool is_inside(std::uint32_t p, bool may_touch) const;

  const ModelPolygons& polygons_;
  std::vector<HiddenClaim> claims_;
  std::vector<kernel::Aabb> regions_;                            ///< of the lines
  std::vector<std::pair<std::uint32_t, std::uint32_t>> hidden_;  ///< a polygon, and from which region
  std::vector<culler::FanTriangle> inside_, well_inside_;
};

}  // namespace occlude::proof
