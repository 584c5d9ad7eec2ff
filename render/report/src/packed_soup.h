// SPDX-License-Identifier: MIT
// A model in single precision, as bytes that compress well: what the page of `inspect` draws and culls.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/rgb.h"

namespace occlude::render {

struct PackedSoup {
  glm::dvec3 origin{};  ///< of the coordinates; 0 for a model that is about 0
  std::string bytes;    ///< packed_soup.cpp has the format
};

/// REQUIRES: `colours` is empty, or has one for each polygon.
[[nodiscard]] PackedSoup packed(culler::SoupView soup, std::span<const Rgb> colours = {});

}  // namespace occlude::render
