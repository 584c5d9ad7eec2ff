// SPDX-License-Identifier: MIT
// Reading of checked values from JSON lines: numbers that are numbers, triples that have three.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "cases/case.h"

namespace occlude::cases {

/// A line that is not what it should be; the message names the member at fault.
struct LineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[nodiscard]] const nlohmann::json& member(const nlohmann::json& object, const char* name);

/// A number; the strings "nan", "inf" and "-inf" stand for those that JSON has no numbers for.
[[nodiscard]] double number(const nlohmann::json& value, const char* name);

[[nodiscard]] kernel::Vec3 vec3(const nlohmann::json& value, const char* name);

[[nodiscard]] std::vector<kernel::Vec3> vec3s(const nlohmann::json& value, const char* name);

/// The member "eye" or "direction".
[[nodiscard]] kernel::Viewpoint viewpoint(const nlohmann::json& object);

/// The member "box": "min" and "max", or "center" and "half_edges".
[[nodiscard]] Box box(const nlohmann::json& object);

/// Vertices of a polytope and of all its faces together. The oracle holds the plane through each two vertices against each
/// vertex: so many take it seconds. (A polygon takes it time in proportion.)
inline constexpr std::size_t kMostCorners = 4096;

/// An occluder: "polygon", or "vertices" and "faces". An index too large for any vertex stays too large. LineError for a
/// polytope with more than kMostCorners.
[[nodiscard]] Occluder occluder(const nlohmann::json& value);

/// The polygons of an occluder "cover". LineError for more vertices than render::kMostCoverVertices.
[[nodiscard]] std::vector<Polygon> cover(const nlohmann::json& value);

}  // namespace occlude::cases
