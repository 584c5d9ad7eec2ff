// SPDX-License-Identifier: MIT
// Proves one line of a file about what is hidden from everywhere in boxes of eyes, or from outside of the model.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model_polygons.h"
#include "occlude/kernel/types.h"

namespace occlude::proof {

/// Faces of the model that are said to be hidden from everywhere in all of these boxes.
struct HiddenClaim {
  std::vector<kernel::Aabb> from;
  std::vector<std::array<std::size_t, 2>> faces;  ///< runs, [first, count]
  bool is_outside = false;  ///< from everywhere outside of the model's hull; `from` has the sides of a box around the model
  bool may_touch = false;   ///< but for the borders of triangles that are inside of a shell
};

/// What a line says, as far as it is proved.
struct HiddenLine {
  std::string failure;    ///< empty, or what is wrong with it
  bool is_claim = false;  ///< nothing is proved by it
  HiddenClaim claim;
  kernel::Aabb from{};                           ///< polygons are hidden from everywhere in this box
  std::vector<std::uint32_t> polygons;           ///< in the tree
  std::vector<culler::FanTriangle> inside;       ///< triangles inside of a closed shell, without their borders
  std::vector<culler::FanTriangle> well_inside;  ///< and with them
};

/// Whether the line begins a file of such lines. Throws LineError when it is no object.
[[nodiscard]] bool is_claim(std::string_view line);

/// Several threads may call prove() at once.
class HiddenProver {
 public:
  /// REQUIRES: `hierarchy` outlives the prover. Neither its order nor its boxes matter.
  explicit HiddenProver(const culler::Hierarchy& hierarchy) : polygons_(hierarchy) {}

  /// Reads a claim, or proves a line. Throws LineError when it is neither. These things must hold:
  /// - A claim from outside gives a box that holds the whole model. Faces exist.
  /// - The polygons exist and lie in the box of the line. The box `from` lies in the region of eyes, or is the eye.
  /// - From each of the eyes, each segment to the box meets a triangle of the cover strictly between (region.h, cover.h).
  /// - A shell is closed, and has the triangles inside (closed_shell.h). All its polygons are opaque.
  [[nodiscard]] HiddenLine prove(std::string_view line) const;

  [[nodiscard]] const ModelPolygons& polygons() const { return polygons_; }

 private:
  [[nodiscard]] HiddenLine claim(const nlohmann::json& object) const;
  [[nodiscard]] HiddenLine by_cover(const nlohmann::json& object) const;
  [[nodiscard]] HiddenLine by_shell(const nlohmann::json& object) const;

  ModelPolygons polygons_;
};

/// Whether the boxes together hold all of the box. Exact: only numbers are compared.
[[nodiscard]] bool is_covered(const kernel::Aabb& box, const std::vector<kernel::Aabb>& by);

}  // namespace occlude::proof
