// SPDX-License-Identifier: MIT
// The checks on models of every format.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/validity.h"

namespace occlude::render {

/// Whether each coordinate is 0 or has a magnitude in [2^-100, 2^100].
[[nodiscard]] inline bool is_legal(const glm::dvec3& v) {
  return kernel::check(kernel::Vec3{v.x, v.y, v.z}) == kernel::Refusal::none;
}

/// Why `v` is not legal.
[[nodiscard]] std::optional<std::string> vertex_fault(const glm::dvec3& v);

/// Makes coordinates 0 that are nearer to it than 2^-100, and returns how many.
[[nodiscard]] std::size_t drop_tiny(glm::dvec3& v);

/// Throws InputError for a model of which 2^-100 is no rounding error: one of whose coordinates none is 2^53 times that.
void require_coarse(const std::filesystem::path& file, culler::SoupView soup);

/// Throws InputError for a model without polygons, or with too many for 32-bit indices.
void require_usable(const std::filesystem::path& file, culler::SoupView soup);

}  // namespace occlude::render
