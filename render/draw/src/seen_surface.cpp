// SPDX-License-Identifier: MIT
#include "seen_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace occlude::render {
namespace {

/// The least and the largest depth of a polygon's corners.
struct DepthRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

DepthRange depth_range(culler::SoupView soup, std::uint32_t polygon, const PixelRays& rays) {
  DepthRange range;
  for (const std::uint32_t v : soup.loop(polygon)) {
    const double depth = rays.depth(soup.vertices[v]);
    range = {std::min(range.low, depth), std::max(range.high, depth)};
  }
  return range;
}

}  // namespace

SeenSurface::SeenSurface(const Items& items, const glm::dvec2& offset, const PixelRays& rays, culler::SoupView soup,
                         std::span<const glm::dvec3> normals)
    : items_(items), offset_(offset), rays_(rays), normals_(normals), depths_{items.width, items.height, {}} {
  depths_.pixels.reserve(items.pixels.size());
  std::uint32_t last = kNothing;  // neighbours mostly show the same polygon
  DepthRange range;
  for (int y = 0; y < items.height; ++y) {
    for (int x = 0; x < items.width; ++x) {
      const std::uint32_t p = items.at(x, y);
      double depth = std::numeric_limits<double>::infinity();
      if (p != kNothing) {
        if (p != last) range = depth_range(soup, p, rays);
        last = p;
        const auto [origin, direction] = ray(x, y);
        const double plane = glm::dot(normals[p], soup.vertices[soup.loop(p)[0]] - origin) / glm::dot(normals[p], direction);
        // Polygons that are seen edge-on, or are not quite plane, would be anywhere. A NaN becomes the least depth.
        depth = plane >= range.low ? std::min(plane, range.high) : range.low;
      }
      depths_.pixels.push_back(static_cast<float>(depth));
    }
  }
}

glm::dvec3 SeenSurface::normal(int x, int y) const {
  const glm::dvec3& normal = normals_[polygon(x, y)];
  return glm::dot(normal, ray(x, y).direction) > 0 ? -normal : normal;
}

double SeenSurface::noise(int x, int y) const {
  // "Interleaved gradient noise" (Jimenez 2014). Offsets are eighths of a pixel.
  const double at = 0.06711056 * (x + 40 * offset_.x) + 0.00583715 * (y + 40 * offset_.y);
  const double noise = 52.9829189 * (at - std::floor(at));
  return 2 * std::numbers::pi * (noise - std::floor(noise));
}

double middle_depth(const SeenSurface& seen) {
  std::vector<double> depths;
  visit_some(seen, [&](int x, int y) { depths.push_back(seen.depth(x, y)); });
  if (depths.empty()) return 0;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::ranges::nth_element(depths, middle);
  return *middle;
}

}  // namespace occlude::render
