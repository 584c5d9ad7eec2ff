// SPDX-License-Identifier: MIT
// The checks on models of every format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

/// Why `v` is not a legal vertex: a coordinate is not finite, or not 0 and outside [2^-100, 2^100] in magnitude.
[[nodiscard]] std::optional<std::string> vertex_fault(const glm::dvec3& v);

/// Why `loop` (indices from 0) is not a legal polygon over `vertices` vertices: it has fewer than three indices, or one is
/// out of range. Repeated indices and zero area are legal. `base` is the number of the first vertex in the file, 0 or 1.
[[nodiscard]] std::optional<std::string> loop_fault(std::span<const std::int64_t> loop, std::size_t vertices, int base = 0);

/// Adds a polygon. REQUIRES: no loop_fault.
void add_polygon(culler::PolygonSoup& soup, std::span<const std::int64_t> loop);

/// Throws InputError for a model without polygons, or with too many for 32-bit indices.
void require_usable(const std::filesystem::path& file, culler::SoupView soup);

}  // namespace occlude::render
