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

  [[nodiscard]] const Pixel& at(int x, int y) const { return pixels[index(x, y)]; }
  [[nodiscard]] Pixel& at(int x, int y) { return pixels[index(x, y)]; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend bool operator==(const Rgba&, const Rgba&) = default;
};

using Image = Raster<Rgba>;

/// A polygon at each pixel, as its index in the drawn soup; kNothing where there is none.
using Items = Raster<std::uint32_t>;
inline constexpr std::uint32_t kNothing = 0xFFFFFFFF;

/// The polygons visible at each pixel. The raster itself has the opaque ones: see-through ones hide nothing. The rest is
/// empty if none of the drawn soup is see-through.
struct ItemBuffer : Items {
  Items before;                            ///< the nearest see-through polygon, where no opaque one hides it
  std::vector<std::uint32_t> see_through;  ///< the pixels at which no opaque polygon hides it, for each see-through polygon

  /// The number of pixels at which each of so many polygons is visible.
  [[nodiscard]] std::vector<std::uint32_t> pixels_of(std::size_t polygons) const;
};

/// The same picture in half the size, each pixel the mean of four; odd last rows and columns are left out.
[[nodiscard]] Image halved(const Image& image);

/// The bytes of a PNG file.
[[nodiscard]] std::string png_of(const Image& image);

/// Writes a PNG file that contains a mark of this program and the file's name. The caller commits the file.
void write_png(OutputFile& file, const Image& image);

/// Writes an animated PNG (PNG, third edition, section 11.3.6), which plays without end. A viewer that knows no animations
/// shows the first picture.
class Animation {
 public:
  /// REQUIRES: 0 < pictures, fps < 2^16. The file must outlive this object; the caller commits it.
  Animation(OutputFile& file, std::uint32_t pictures, std::uint32_t fps) : file_(file), pictures_(pictures), fps_(fps) {}
  /// The next picture. REQUIRES: the size of the first one; not more pictures than announced. The last one ends the file.
  void add(const Image& image);

 private:
  OutputFile& file_;
  std::uint32_t pictures_, fps_;
  std::uint32_t added_ = 0, chunks_ = 0;
};

/// Whether write_png or an Animation made this file and the file still has its original name.
[[nodiscard]] bool is_own_png(const std::filesystem::path& file);

}  // namespace occlude::render
