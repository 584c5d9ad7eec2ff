// SPDX-License-Identifier: MIT
#include "cell_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <utility>

namespace occlude::cli {
namespace {

constexpr double kMostPixels = 1024;  ///< across: of a corridor through a town a cell of 2 m is some pixels wide

/// A quarter each: blue, purple, red, orange, yellow. Each is lighter than the one before.
constexpr std::array<glm::dvec3, 5> kColours{{{10, 10, 70}, {95, 20, 120}, {190, 45, 80}, {245, 125, 20}, {255, 240, 120}}};

render::Rgba colour_of(double share) {
  const double at = share * (kColours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kColours.size() - 2);
  const glm::dvec3 c = glm::round(glm::mix(kColours[below], kColours[below + 1], at - static_cast<double>(below)));
  return {static_cast<std::uint8_t>(c.x), static_cast<std::uint8_t>(c.y), static_cast<std::uint8_t>(c.z)};
}

/// Boxes as they lie in the picture: to the right, and upwards.
class FromAbove {
 public:
  FromAbove(std::span<const MapCell> cells, const UpAxis& up) : up_(up), low_(low(cells[0].box)), high_(high(cells[0].box)) {
    for (const MapCell& cell : cells) low_ = glm::min(low_, low(cell.box)), high_ = glm::max(high_, high(cell.box));
    const glm::dvec2 size = high_ - low_;
    const double longest = std::max(size.x, size.y);
    scale_ = longest > 0 ? kMostPixels / longest : 0;
    width = pixels(size.x);
    height = pixels(size.y);
  }

  int width, height;

  /// Calls f(x, y) for the pixels whose middle is in the box; if there are none, for that of its least corner.
  template <class F>
  void for_each_pixel(const kernel::Aabb& box, const F& f) const {
    const glm::dvec2 from = (low(box) - low_) * scale_, to = (high(box) - low_) * scale_;
    const auto [left, right] = range(from.x, to.x, width);
    const auto [bottom, top] = range(from.y, to.y, height);
    for (int y = bottom; y <= top; ++y) {
      for (int x = left; x <= right; ++x) f(x, height - 1 - y);
    }
  }

 private:
  [[nodiscard]] glm::dvec2 low(const kernel::Aabb& box) const {
    return {box.min[(up_.axis + 1) % 3], up_.is_down ? -box.max[(up_.axis + 2) % 3] : box.min[(up_.axis + 2) % 3]};
  }
  [[nodiscard]] glm::dvec2 high(const kernel::Aabb& box) const {
    return {box.max[(up_.axis + 1) % 3], up_.is_down ? -box.min[(up_.axis + 2) % 3] : box.max[(up_.axis + 2) % 3]};
  }
  [[nodiscard]] int pixels(double length) const { return std::max(1, static_cast<int>(std::round(length * scale_))); }
  [[nodiscard]] static std::pair<int, int> range(double from, double to, int pixels) {
    const int first = std::clamp(static_cast<int>(std::ceil(from - 0.5)), 0, pixels - 1);
    return {first, std::clamp(static_cast<int>(std::ceil(to - 0.5)) - 1, first, pixels - 1)};
  }

  UpAxis up_;
  glm::dvec2 low_, high_;
  double scale_;
};

}  // namespace

std::optional<UpAxis> axis_of(const glm::dvec3& up) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 along{0, 0, 0};
    along[axis] = 1;
    if (up == along || up == -along) return UpAxis{axis, up != along};
  }
  return std::nullopt;
}

render::Image map_of(std::span<const MapCell> cells, const UpAxis& up) {
  const FromAbove view(cells, up);
  const std::size_t pixels = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
  constexpr auto kNone = static_cast<std::size_t>(-1);
  render::Raster<std::size_t> numbers{view.width, view.height, std::vector<std::size_t>(pixels, kNone)};
  std::size_t greatest = 1;
  for (const MapCell& cell : cells) {
    greatest = std::max(greatest, cell.number);
    view.for_each_pixel(cell.box, [&](int x, int y) {
      std::size_t& number = numbers.at(x, y);
      if (number == kNone || number < cell.number) number = cell.number;
    });
  }
  render::Image image{view.width, view.height, {}};
  image.pixels.reserve(pixels);
  for (const std::size_t number : numbers.pixels) {
    const double share = static_cast<double>(number) / static_cast<double>(greatest);
    image.pixels.push_back(number == kNone ? render::Rgba{0, 0, 0, 0} : colour_of(share));
  }
  return image;
}

}  // namespace occlude::cli
