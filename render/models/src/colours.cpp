// SPDX-License-Identifier: MIT
#include "colours.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <new>

namespace occlude::render {
namespace {

/// As a byte, rounded once.
std::uint8_t byte_of(double share) {
  return static_cast<std::uint8_t>(std::lround(255 * (share > 0 ? std::min(share, 1.0) : 0)));
}

/// IEC 61966-2-1.
double srgb_of_light(double light) { return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055; }

/// What the simplified interface of libpng holds, until this goes.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes) {
    png_.version = PNG_IMAGE_VERSION;
    is_open_ = png_image_begin_read_from_memory(&png_, bytes.data(), bytes.size()) != 0;
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_image_free(&png_); }

  [[nodiscard]] std::size_t pixels() const { return is_open_ ? std::size_t{png_.width} * png_.height : 0; }
  /// Of each pixel the light that is red, green and blue, times the opacity, and the opacity, in 16 bits. Empty if the
  /// picture is damaged.
  [[nodiscard]] std::vector<std::uint16_t> light() {
    constexpr int kPackedRows = 0;
    png_.format = PNG_FORMAT_LINEAR_RGB_ALPHA;
    std::vector<std::uint16_t> light(4 * pixels());
    if (png_image_finish_read(&png_, nullptr, light.data(), kPackedRows, nullptr) == 0) light.clear();
    return light;
  }

 private:
  png_image png_{};
  bool is_open_ = false;
};

}  // namespace

Rgb rgb_of(const glm::dvec3& colour) { return {byte_of(colour.r), byte_of(colour.g), byte_of(colour.b)}; }

Rgb rgb_of_light(const glm::dvec3& light) {
  return rgb_of({srgb_of_light(light.r), srgb_of_light(light.g), srgb_of_light(light.b)});
}

Rgb mean_colour(std::span<const std::uint32_t> loop, const std::vector<Rgb>& colours) {
  glm::dvec3 sum(0);
  for (const std::uint32_t corner : loop) {
    const auto& [red, green, blue] = colours[corner];
    sum += glm::dvec3(red, green, blue);
  }
  return rgb_of(sum / (255.0 * static_cast<double>(loop.size())));
}

std::optional<glm::dvec3> mean_light_of_png(std::string_view bytes) try {
  constexpr std::size_t kMostPixels = std::size_t{1} << 26U;
  PngReader png(bytes);
  if (png.pixels() == 0 || png.pixels() > kMostPixels) return std::nullopt;
  const std::vector<std::uint16_t> light = png.light();
  glm::dvec3 sum(0);
  double opacity = 0;
  for (std::size_t i = 0; i < light.size(); i += 4) {
    sum += glm::dvec3(light[i], light[i + 1], light[i + 2]);
    opacity += light[i + 3];
  }
  if (opacity == 0) return std::nullopt;
  return sum / opacity;
} catch (const std::bad_alloc&) {
  return std::nullopt;
}

}  // namespace occlude::render
