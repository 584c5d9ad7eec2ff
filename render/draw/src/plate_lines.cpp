// SPDX-License-Identifier: MIT
#include "plate_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace occlude::render {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kLeast = 0.6;        // pixels
constexpr double kHalfWidth = 1;      // pixels, in a picture 720 high
constexpr double kHiddenShare = 0.3;  // of a line behind the surface
constexpr double kNearer = 1.001;     // lines on a surface are before it

std::uint8_t mixed(std::uint8_t under, std::uint8_t over, double share) {
  return static_cast<std::uint8_t>(std::lround(under + share * (over - under)));
}

/// The part of a line beyond the near plane, in the picture.
class SeenLine {
 public:
  SeenLine(const PixelRays& rays, double near, const Line& line) : rays_(rays) {
    dvec3 a = line.from, b = line.to;
    const double depth_a = rays.depth(a), depth_b = rays.depth(b);
    is_seen_ = depth_a > near || depth_b > near;
    if (!is_seen_) return;
    if (depth_a < near) a += (near - depth_a) / (depth_b - depth_a) * (b - a);
    if (depth_b < near) b += (near - depth_b) / (depth_a - depth_b) * (a - b);
    depth_a_ = std::max(near, rays.depth(a));
    depth_b_ = std::max(near, rays.depth(b));
    a_ = rays.project(a, depth_a_);
    b_ = rays.project(b, depth_b_);
  }

  [[nodiscard]] bool is_seen() const { return is_seen_; }

  struct Nearest {
    double distance, depth;
  };
  /// The distance of the line from a place in the picture, in pixels, and the depth of its nearest point.
  [[nodiscard]] Nearest nearest(const dvec2& place) const {
    const dvec2 along = b_ - a_;
    const double squared = glm::dot(along, along);
    const double t = squared > 0 ? std::clamp(glm::dot(place - a_, along) / squared, 0.0, 1.0) : 0;
    // In perspective 1 / depth is linear in the picture, else the depth is.
    const double depth =
        rays_.is_perspective() ? 1 / ((1 - t) / depth_a_ + t / depth_b_) : (1 - t) * depth_a_ + t * depth_b_;
    return {glm::length(place - (a_ + t * along)), depth};
  }

  /// Calls visit(x, y) for the pixels of the picture that may be within `width` of the line, row by row or column by column.
  template <class Visit>
  void visit(int columns, int rows, double width, const Visit& visit) const {
    const dvec2 along = b_ - a_;
    const bool is_steep = std::fabs(along.y) > std::fabs(along.x);
    const int main = is_steep ? 1 : 0, other = 1 - main;
    const int main_end = is_steep ? rows : columns, other_end = is_steep ? columns : rows;
    // Across the main axis a line that is at most 45 degrees steep is at most 1.5 times as wide.
    const double reach = 1.5 * width + 1;
    const auto within = [](double value, int end) {
      return value > 0 ? static_cast<int>(std::min(value, static_cast<double>(end))) : 0;  // also of what is not a number
    };
    const double low = std::min(a_[main], b_[main]) - reach, high = std::max(a_[main], b_[main]) + reach;
    for (int i = within(low, main_end); i < within(high + 1, main_end); ++i) {
      const double t = along[main] == 0 ? 0 : std::clamp((i + 0.5 - a_[main]) / along[main], 0.0, 1.0);
      const double middle = a_[other] + t * along[other];
      for (int k = within(middle - reach, other_end); k < within(middle + reach + 1, other_end); ++k) {
        is_steep ? visit(k, i) : visit(i, k);
      }
    }
  }

 private:
  const PixelRays& rays_;
  bool is_seen_ = false;
  dvec2 a_{}, b_{};
  double depth_a_ = 0, depth_b_ = 0;
};

}  // namespace

void blend(Rgba& pixel, const Rgba& colour, double share) {
  pixel = {mixed(pixel.r, colour.r, share), mixed(pixel.g, colour.g, share), mixed(pixel.b, colour.b, share), pixel.a};
}

void draw_lines(Image& image, const SeenSurface& seen, double near, std::span<const Line> lines) {
  const double half_width = std::max(kLeast, kHalfWidth * image.height / 720);
  for (const Line& line : lines) {
    const SeenLine drawn(seen.rays(), near, line);
    if (!drawn.is_seen()) continue;
    drawn.visit(image.width, image.height, half_width, [&](int x, int y) {
      const auto [distance, depth] = drawn.nearest({x + 0.5, y + 0.5});
      const double cover = std::clamp(half_width + 0.5 - distance, 0.0, 1.0);
      if (cover == 0) return;
      const bool is_hidden = seen.polygon(x, y) != kNothing && seen.depth(x, y) * kNearer < depth;
      blend(image.at(x, y), line.colour, cover * (is_hidden ? kHiddenShare : 1));
    });
  }
}

}  // namespace occlude::render
