// SPDX-License-Identifier: MIT
// What a line says about a cover, and whether that hides a box from all eyes.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "camera_picture.h"
#include "model_polygons.h"
#include "occlude/oracle/region.h"

namespace occlude::proof {

/// The coefficients of a plane, or the sides of a rectangle. Like the functions below it throws LineError.
[[nodiscard]] std::array<double, 4> four_numbers(const nlohmann::json& object, const char* name);

/// The member "eyes" of a line for a region; none without it.
[[nodiscard]] Eyes eyes_in(const nlohmann::json& object);

[[nodiscard]] bool contains(const oracle::EyeRegion& eyes, const oracle::Point& eye);

/// Why the windows on the line do not hide the box from the eyes. Empty when they do. Sheets count in `drawn`.
[[nodiscard]] std::string fault_of_windows(const oracle::EyeRegion& eyes, const nlohmann::json& object,
                                           const oracle::HalfSpaceCoefficients& drawn, const oracle::Box& box,
                                           const ModelPolygons& polygons);

/// Why the polygons on the line do not hide the box together. Empty when they do.
[[nodiscard]] std::string fault_of_polygons(const oracle::Viewpoint& view, const nlohmann::json& object,
                                            const oracle::HalfSpaceCoefficients& drawn, const oracle::Box& box,
                                            const ModelPolygons& polygons);

}  // namespace occlude::proof
