// SPDX-License-Identifier: MIT
// What the coordinates of a model mean: which axis is up, and how long a unit is.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace occlude::render {

struct Convention {
  double metres = 0;  ///< the length of a unit; 0 where nobody says
  glm::dvec3 up{0};   ///< the direction of an axis; 0 where nobody says

  friend bool operator==(const Convention&, const Convention&) = default;
};

/// Which of its conventions a model is to give up for metres, and for z up. The default is neither: coordinates are those of
/// the file.
struct Conversion {
  bool to_metres = false, to_z_up = false;
  Convention file = {};  ///< of the file, where the user knows better than it; 0 where the file is believed
};

/// "metres", "inches", "0.5 m"; empty for 0.
[[nodiscard]] std::string unit_in_words(double metres);
/// "+y"; empty for 0.
[[nodiscard]] std::string up_in_words(const glm::dvec3& up);

/// The metres of "m", "km", "cm", "mm", "in" or "ft", or of a number of them from 1e-12 to 1e12.
[[nodiscard]] std::optional<double> parse_unit(std::string_view text);
/// The direction of "x", "+x" or "-x", and so on.
[[nodiscard]] std::optional<glm::dvec3> parse_up(std::string_view text);

/// The vertex, turned so that the axis `up` becomes z; exact. Of y up it is (x, -z, y), of x up (-y, -z, x), as COLLADA
/// says. REQUIRES: `up` is the direction of an axis.
[[nodiscard]] glm::dvec3 turned_to_z_up(const glm::dvec3& vertex, const glm::dvec3& up);

}  // namespace occlude::render
