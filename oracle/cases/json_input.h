// SPDX-License-Identifier: MIT
// Reads and checks values of JSON lines.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "cases/case.h"

namespace occlude::cases {

/// A line that cannot be read. The message names the member at fault.
struct LineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[nodiscard]] const nlohmann::json& member(const nlohmann::json& object, const char* name);

/// A number. The strings "nan", "inf" and "-inf" stand for the numbers that JSON cannot write.
[[nodiscard]] double number(const nlohmann::json& value, const char* name);

[[nodiscard]] kernel::Vec3 vec3(const nlohmann::json& value, const char* name);

[[nodiscard]] std::vector<kernel::Vec3> vec3s(const nlohmann::json& value, const char* name);

/// The member "eye" or "direction".
[[nodiscard]] kernel::Viewpoint viewpoint(const nlohmann::json& object);

/// The member "eyes" or "directions": a box of eyes, or of directions of view, by "center" and "half_edges".
[[nodiscard]] kernel::ViewRegion view_region(const nlohmann::json& object);

/// The member "box": "min" and "max", or "center" and "half_edges".
[[nodiscard]] Box box(const nlohmann::json& object);

/// Most vertices of a polytope and of all its faces together. The oracle tests the plane through every two vertices against
/// every vertex, which takes seconds at this limit. (The time for a polygon is proportional to its vertices.)
inline constexpr std::size_t kMostCorners = 4096;

/// Most vertices of an occluder seen from a region. The time of oracle and kernel may grow with the cube of their number.
inline constexpr std::size_t kMostRegionVertices = 128;

/// An occluder: "polygon", or "vertices" and "faces". An index beyond 32 bits becomes the largest 32-bit one, so it stays
/// too large. Throws LineError for a polytope with more than kMostCorners.
[[nodiscard]] Occluder occluder(const nlohmann::json& value);

/// The polygons of an occluder "cover". Throws LineError for more than render::kMostCoverVertices vertices.
[[nodiscard]] std::vector<Polygon> cover(const nlohmann::json& value);

}  // namespace occlude::cases
