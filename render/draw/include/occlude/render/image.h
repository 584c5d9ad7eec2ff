// SPDX-License-Identifier: MIT
// Pictures in memory and PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "occlude/render/output_file.h"

namespace occlude::render {

/// Rows from top to bottom, pixels from left to right.
template <class Pixel>
struct Raster {
  int width = 0, height = 0;
  std::vector<Pixel> pixels;

  [[nodiscard]] const Pixel& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend bool operator==(const Rgba&, const Rgba&) = default;
};

using Image = Raster<Rgba>;

/// The polygon visible at each pixel, as its index in the drawn soup; kNothing where there is none.
using ItemBuffer = Raster<std::uint32_t>;
inline constexpr std::uint32_t kNothing = 0xFFFFFFFF;

/// The same picture in half the size, each pixel the mean of four; odd last rows and columns are left out.
[[nodiscard]] Image halved(const Image& image);

/// The bytes of a PNG file.
[[nodiscard]] std::string png_of(const Image& image);

/// Writes a PNG file that contains a mark of this program and the file's name. The caller commits the file.
void write_png(OutputFile& file, const Image& image);

/// Whether write_png made this file and the file still has its original name.
[[nodiscard]] bool is_own_png(const std::filesystem::path& file);

}  // namespace occlude::render
