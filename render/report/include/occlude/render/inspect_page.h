// SPDX-License-Identifier: MIT
// The page in which one flies through a model while the culler culls each frame: one HTML file, which needs no other and no
// network.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/rgb.h"

namespace occlude::render {

/// Models with more triangles are not for pages.
inline constexpr std::size_t kMostPageTriangles = 4'000'000;

/// What is put into a page.
struct Inspected {
  std::string name;
  culler::SoupView model;
  std::span<const Rgb> colours = {};  ///< of each polygon; empty: it has none
  glm::dvec3 up{0, 0, 1};
  const CameraPath* path = nullptr;  ///< to fly along; none: round the model
};

/// Whether this is a page that culler/js/page/build.sh has made.
[[nodiscard]] bool is_inspect_page(std::string_view page);

/// The page with the model in it. REQUIRES: is_inspect_page(page); at most kMostPageTriangles.
[[nodiscard]] std::string inspect_page(std::string_view page, const Inspected& inspected);

}  // namespace occlude::render
