// SPDX-License-Identifier: MIT
// Cameras for the culler's tests, and what a frame draws.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "frame/culler_access.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/half_space.h"
#include "scenes.h"

namespace occlude::culler {

inline kernel::HalfSpace to_kernel(const HalfSpace& h) { return {{h.normal.x, h.normal.y, h.normal.z}, h.offset}; }

inline std::vector<bool> drawn_polygons(const Culler& culler, const CullResult& frame) {
  std::vector<bool> drawn(culler.hierarchy().soup().size(), false);
  for (const PolygonRange& range : frame.drawn) {
    for (std::uint32_t p = range.first; p < range.first + range.count; ++p) {
      EXPECT_FALSE(drawn[p]) << "drawn twice";
      drawn[p] = true;
    }
  }
  return drawn;
}

/// Whether a part of the occluder is in the node, so that the occluder must not cull it.
inline bool holds_part(const Culler& culler, const HierarchyNode& node, const Occluder& occluder) {
  return std::ranges::any_of(occluders_of(culler).parts(occluder.index),
                             [&](std::uint32_t part) { return part >= node.first && part - node.first < node.count; });
}

inline Camera random_camera(std::mt19937& random) {
  const auto number = [&](double low, double high) { return uniform(random, low, high); };
  Camera camera;
  camera.eye = {number(-45, 45), number(-45, 45), number(0.5, 4)};
  camera.target = camera.eye + glm::dvec3{number(-1, 1), number(-1, 1), number(-0.2, 0.2)};
  if (random() % 4 == 0) camera.projection = Projection::orthographic;
  if (random() % 3 == 0) camera.far_plane = 40;
  camera.height = 20;
  return camera;
}

/// The matrix of a Camera, with a far plane where it must have one.
inline MatrixCamera matrix_of(Camera camera) {
  if (camera.projection == Projection::orthographic && std::isinf(camera.far_plane)) camera.far_plane = 1e4;
  return MatrixCamera::from_camera(camera, ClipDepth::zero_to_w, Nearer::less);
}

/// The message of the std::invalid_argument that `call` throws; "" if it throws none.
template <class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// The number in the input of the polygon that is the occluder. REQUIRES: an occluder of one polygon.
inline std::uint32_t original(const Culler& culler, const Occluder& occluder) {
  const auto parts = occluders_of(culler).parts(occluder.index);
  EXPECT_EQ(parts.size(), 1U);
  return culler.hierarchy().original(parts[0]);
}

inline bool is_drawn(const Culler& culler, const CullResult& frame, std::uint32_t original) {
  const auto drawn = drawn_polygons(culler, frame);
  for (std::uint32_t p = 0; p < drawn.size(); ++p) {
    if (culler.hierarchy().original(p) == original) return drawn[p];
  }
  return false;
}

/// The frame of a camera at the origin that looks along +x.
inline CullResult look(const Culler& culler, const CullOptions& options = {.method = Method::frusta}) {
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {1, 0, 0};
  return culler.cull(camera, options);
}

/// A culler with few polygons per leaf, and few regions.
inline Culler small_leaves(const PolygonSoup& soup) {
  return Culler(soup, {.hierarchy = {.leaf_size = 2}, .lists = {.regions = 8}});
}

inline BuildConfig small_config(Bounds bounds, RegionKind kind = RegionKind::grid) {
  return {.hierarchy = {.leaf_size = 4, .bounds = bounds}, .lists = {.kind = kind, .threshold = 0.05, .regions = 48}};
}

/// Both bounds, each with another kind of regions.
inline const std::array kSmallConfigs{small_config(Bounds::aabb, RegionKind::tree),
                                      small_config(Bounds::obb, RegionKind::grid)};

/// A culler with one polygon per leaf, so that each polygon is decided for itself.
inline Culler one_polygon_leaves(const PolygonSoup& soup) {
  BuildConfig config;
  config.hierarchy.leaf_size = 1;
  return Culler(soup, config);
}

}  // namespace occlude::culler
