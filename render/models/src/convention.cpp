// SPDX-License-Identifier: MIT
#include "occlude/render/convention.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "text_number.h"

namespace occlude::render {
namespace {

struct Unit {
  std::string_view symbol, name;
  double metres;
};
constexpr std::array<Unit, 6> kUnits = {{{"m", "metres", 1},
                                         {"km", "kilometres", 1000},
                                         {"cm", "centimetres", 0.01},
                                         {"mm", "millimetres", 0.001},
                                         {"in", "inches", 0.0254},
                                         {"ft", "feet", 0.3048}}};
constexpr double kShortest = 1e-12, kLongest = 1e12;  // beyond them is no model, and a typing error

constexpr std::string_view kAxes = "xyz";

}  // namespace

std::string unit_in_words(double metres) {
  if (metres == 0) return "";
  const auto* const unit = std::ranges::find(kUnits, metres, &Unit::metres);
  return unit == kUnits.end() ? fmt::format("{} m", metres) : std::string(unit->name);
}

std::string up_in_words(const glm::dvec3& up) {
  for (int axis = 0; axis < 3; ++axis) {
    if (up[axis] != 0) return {up[axis] < 0 ? '-' : '+', kAxes[static_cast<std::size_t>(axis)]};
  }
  return "";
}

std::optional<double> parse_unit(std::string_view text) {
  const auto* const unit = std::ranges::find(kUnits, text, &Unit::symbol);
  if (unit != kUnits.end()) return unit->metres;
  const auto metres = parse_number<double>(text);
  if (!metres || !(*metres >= kShortest && *metres <= kLongest)) return std::nullopt;
  return metres;
}

std::optional<glm::dvec3> parse_up(std::string_view text) {
  const double direction = text.starts_with('-') ? -1 : 1;
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t axis = kAxes.find(text);
  if (text.size() != 1 || axis == std::string_view::npos) return std::nullopt;
  glm::dvec3 up(0);
  up[static_cast<int>(axis)] = direction;
  return up;
}

glm::dvec3 turned_to_z_up(const glm::dvec3& vertex, const glm::dvec3& up) {
  const auto [x, y, z] = std::array{vertex.x, vertex.y, vertex.z};
  // 0 - c instead of -c: no coordinate is -0.
  if (up.x != 0) return up.x > 0 ? glm::dvec3(0 - y, 0 - z, x) : glm::dvec3(y, 0 - z, 0 - x);
  if (up.y != 0) return up.y > 0 ? glm::dvec3(x, 0 - z, y) : glm::dvec3(x, z, 0 - y);
  return up.z > 0 ? vertex : glm::dvec3(x, 0 - y, 0 - z);
}

}  // namespace occlude::render
