// SPDX-License-Identifier: MIT
#include "occlude/render/plate_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <optional>

#include "glass.h"
#include "legend.h"
#include "occlude/culler/executor.h"
#include "occlude/render/pixel_rays.h"
#include "plate_light.h"
#include "plate_lines.h"
#include "seen_surface.h"
#include "styles.h"
#include "surfaces.h"

namespace occlude::render {
namespace {

using glm::dvec2;
using glm::dvec3;

/// Where each of the pictures that make a plate looks between the centres of the pixels: a square turned by 27 degrees, so
/// that all four differ across and up.
constexpr std::array<dvec2, 4> kOffsets{{{-0.125, -0.375}, {0.375, -0.125}, {-0.375, 0.125}, {0.125, 0.375}}};

// Light on every surface, more of it from above, and that of the sun.
constexpr double kAmbient = 0.66, kFromAbove = 0.14, kSunlight = 0.36;

// The share of light that is left at an outline and at a bend.
constexpr double kOutline = 0.55, kBend = 0.85;
// A bend is an edge where the cosine of its angle is less than this (32 degrees); an outline is where the next pixel is this
// many pixels or more before or behind the plane.
constexpr double kBent = 0.85, kApart = 6;

// One sees this many times as far as in the pictures that are timed.
constexpr double kClear = 5;

// The sky at the top of the picture, and from its 1 / kSkyFades downwards.
constexpr dvec3 kSkyAbove{0.66, 0.78, 0.90}, kSkyBelow{0.88, 0.92, 0.95};
constexpr double kSkyFades = 1.6;

/// The light that an edge between a pixel and a neighbour leaves.
double edge(const SeenSurface& seen, int x, int y, int nx, int ny) {
  if (!seen.holds(nx, ny)) return 1;
  const std::uint32_t p = seen.polygon(x, y), q = seen.polygon(nx, ny);
  if (p == q) return 1;
  if (p == kNothing || q == kNothing) return kOutline;
  const dvec3 normal = seen.normal(x, y), to = seen.position(nx, ny) - seen.position(x, y);
  const double apart =
      std::fabs(glm::dot(normal, to)) / seen.rays().pixel_size(std::min(seen.depth(x, y), seen.depth(nx, ny)));
  if (apart > kApart) return kOutline;
  return glm::dot(normal, seen.normal(nx, ny)) < kBent ? kBend : 1;
}

}  // namespace

struct PlateRenderer::Impl {
  Impl(culler::SoupView model, SceneRenderer& scene)
      : soup(model),
        renderer(scene),
        width(scene.width()),
        height(scene.height()),
        normals(unit_normals(model)),
        colours(surface_colours(model, normals)) {}

  class Samples;
  struct Light {
    const Samples* from_sun;  ///< none: nothing is in shade
    double haze_depth;        ///< where a surface has half the colour of the sky
  };

  void set_styles(std::span<const PlateLayer> layers);
  [[nodiscard]] Image shaded(const Samples& seen, const Light& light) const;
  [[nodiscard]] dvec3 colour(const SeenSurface& seen, const Light& light, int x, int y) const;
  [[nodiscard]] dvec3 through(std::uint32_t see_through, const dvec3& behind, int x, int y) const;

  culler::SoupView soup;
  SceneRenderer& renderer;
  int width, height;
  std::vector<dvec3> normals, colours;
  std::vector<Style> styles;  ///< of each polygon
};

/// What a camera sees, once for each of kOffsets.
class PlateRenderer::Impl::Samples {
 public:
  Samples(Impl& impl, const culler::Camera& camera, std::span<const culler::PolygonRange> ranges,
          const std::optional<Cut>& cut)
      : rays_(camera, impl.width, impl.height) {
    pictures_.reserve(kOffsets.size());
    for (std::size_t i = 0; i < kOffsets.size(); ++i) {
      items_[i] = impl.renderer.item_buffer(camera, ranges, kOffsets[i], cut);
      pictures_.emplace_back(items_[i], kOffsets[i], rays_, impl.soup, impl.normals);
    }
  }
  Samples(const Samples&) = delete;
  Samples& operator=(const Samples&) = delete;

  [[nodiscard]] std::span<const SeenSurface> pictures() const { return pictures_; }
  /// The nearest see-through polygon in one of the pictures, or kNothing.
  [[nodiscard]] std::uint32_t before(std::size_t picture, int x, int y) const {
    const Items& before = items_[picture].before;
    return before.pixels.empty() ? kNothing : before.at(x, y);
  }
  /// With a camera at the sun: the share of the pictures in which the sun reaches a point.
  [[nodiscard]] double sun_at(const dvec3& point, double angle) const {
    double lit = 0;
    for (const SeenSurface& from_sun : pictures_) {
      lit += is_in_sun(from_sun, point, angle) ? 1 : 0;
      angle += 2 * std::numbers::pi / static_cast<double>(pictures_.size());
    }
    return lit / static_cast<double>(pictures_.size());
  }

 private:
  PixelRays rays_;
  std::array<ItemBuffer, kOffsets.size()> items_;
  std::vector<SeenSurface> pictures_;
};

dvec3 PlateRenderer::Impl::colour(const SeenSurface& seen, const Light& light, int x, int y) const {
  const dvec3 sky = glm::mix(kSkyAbove, kSkyBelow, std::min(1.0, kSkyFades * (y + 0.5) / height));
  const double lines = edge(seen, x, y, x + 1, y) * edge(seen, x, y, x, y + 1);
  const std::uint32_t p = seen.polygon(x, y);
  if (p == kNothing) return sky * lines;
  const dvec3 normal = seen.normal(x, y);
  const double facing = glm::dot(normal, kSun);
  const double sun =
      facing > 0 && light.from_sun != nullptr ? light.from_sun->sun_at(seen.position(x, y), seen.noise(x, y)) : 0;
  const double all = (kAmbient + kFromAbove * (0.5 + 0.5 * normal.z)) * seen_sky(seen, x, y) + kSunlight * facing * sun;
  const dvec3 surface = styled(styles[p], colours[p], x, y, height) * glm::mix(1.0, all * lines, relief(styles[p]));
  return glm::mix(sky, surface, std::exp2(-seen.depth(x, y) / light.haze_depth));
}

/// The colour of what is behind a see-through polygon, or of nothing.
dvec3 PlateRenderer::Impl::through(std::uint32_t see_through, const dvec3& behind, int x, int y) const {
  if (see_through == kNothing) return behind;
  return glm::mix(behind, styled(styles[see_through], colours[see_through], x, y, height), kGlassShare);
}

PlateRenderer::PlateRenderer(culler::SoupView soup, SceneRenderer& renderer)
    : impl_(std::make_unique<Impl>(soup, renderer)) {}

PlateRenderer::~PlateRenderer() = default;

/// Each polygon has the style of the first layer that holds it.
void PlateRenderer::Impl::set_styles(std::span<const PlateLayer> layers) {
  styles.assign(soup.size(), Style::plain);
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    for (const culler::PolygonRange& range : layer->ranges) {
      std::fill_n(styles.begin() + range.first, range.count, layer->style);
    }
  }
}

Image PlateRenderer::Impl::shaded(const Samples& seen, const Light& light) const {
  Image image{width, height, {}};
  image.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto shade_row = [&](std::size_t row) {
    const auto y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      dvec3 sum{0, 0, 0};
      for (std::size_t i = 0; i < kOffsets.size(); ++i) {
        sum += through(seen.before(i, x, y), colour(seen.pictures()[i], light, x, y), x, y);
      }
      image.at(x, y) = to_rgba(sum / static_cast<double>(kOffsets.size()));
    }
  };
  culler::Executor::own_threads().run(static_cast<std::size_t>(height), shade_row);
  return image;
}

std::vector<bool> PlateRenderer::seen(const culler::Camera& camera, std::span<const culler::PolygonRange> ranges) {
  std::vector<bool> is_seen(impl_->soup.size());
  for (const dvec2& offset : kOffsets) {
    const std::vector<std::uint32_t> pixels = impl_->renderer.item_buffer(camera, ranges, offset).pixels_of(is_seen.size());
    for (std::size_t p = 0; p < pixels.size(); ++p) is_seen[p] = is_seen[p] || pixels[p] != 0;
  }
  return is_seen;
}

Image PlateRenderer::draw(const culler::Camera& camera, std::span<const PlateLayer> layers, const PlateExtras& extras) {
  impl_->set_styles(layers);
  std::vector<culler::PolygonRange> ranges;
  for (const PlateLayer& layer : layers) ranges.insert(ranges.end(), layer.ranges.begin(), layer.ranges.end());
  const Impl::Samples seen(*impl_, camera, ranges, extras.cut);
  const SeenSurface& first = seen.pictures().front();
  if (extras.casters) ranges = {*extras.casters};
  std::optional<Impl::Samples> from_sun;
  if (const auto sun = sun_camera(first, impl_->soup, camera.aspect)) from_sun.emplace(*impl_, *sun, ranges, extras.cut);
  Image image = impl_->shaded(seen, {from_sun ? &*from_sun : nullptr, kClear * impl_->renderer.haze_depth(camera)});
  draw_lines(image, first, camera.near_plane, extras.lines);
  draw_legend(image, extras.legend);
  return image;
}

}  // namespace occlude::render
