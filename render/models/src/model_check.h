// SPDX-License-Identifier: MIT
// What every model must satisfy, whatever format it comes in.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

/// Why `v` cannot be a vertex: a coordinate not finite, or neither 0 nor of magnitude in [2^-100, 2^100].
[[nodiscard]] std::optional<std::string> vertex_fault(const glm::dvec3& v);

/// Why `loop` (indices from 0) cannot be a polygon over `vertices` vertices: fewer than three indices, or one out of range.
/// Repeated indices and zero area are legal soup. `base` is what the file calls the first vertex, 0 or 1.
[[nodiscard]] std::optional<std::string> loop_fault(std::span<const std::int64_t> loop, std::size_t vertices, int base = 0);

/// Adds a loop without fault.
void add_polygon(culler::PolygonSoup& soup, std::span<const std::int64_t> loop);

/// Throws InputError for a model without polygons or with more than 32-bit indices can number.
void require_usable(const std::filesystem::path& file, const culler::PolygonSoup& soup);

}  // namespace occlude::render
