// SPDX-License-Identifier: MIT
#include "legend.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "font.h"
#include "plate_lines.h"
#include "styles.h"

namespace occlude::render {
namespace {

// In pixels of a picture 720 high.
constexpr double kTextSize = 15, kRow = 24, kSwatch = 15, kPadding = 12;

constexpr Rgba kGround{255, 255, 255, 255}, kText{24, 28, 32, 255};
constexpr double kGroundShare = 0.86;

void require(FT_Error error) {
  if (error != 0) throw std::runtime_error("the font of the legend cannot be used");
}

/// Text of one size.
class Font {
 public:
  explicit Font(int pixels) {
    FT_Library library = nullptr;
    require(FT_Init_FreeType(&library));
    library_.reset(library);
    const std::string_view bytes = font_file("DejaVuSans.ttf");
    FT_Face face = nullptr;
    require(FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()), static_cast<FT_Long>(bytes.size()),
                               0, &face));
    face_.reset(face);
    require(FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(pixels)));
  }

  /// Calls visit(x, y, share) for each pixel of the text, whose first letter starts at (0, 0) on the base line. Returns the
  /// width of the text. REQUIRES: ASCII.
  template <class Visit>
  int draw(std::string_view text, const Visit& visit) const {
    int pen = 0;
    for (const char letter : text) {
      require(FT_Load_Char(face_.get(), static_cast<FT_ULong>(letter), FT_LOAD_RENDER));
      const FT_GlyphSlot glyph = face_->glyph;
      const FT_Bitmap& bitmap = glyph->bitmap;
      for (unsigned y = 0; y < bitmap.rows; ++y) {
        for (unsigned x = 0; x < bitmap.width; ++x) {
          const std::uint8_t share =
              bitmap.buffer[static_cast<std::ptrdiff_t>(y) * bitmap.pitch + static_cast<std::ptrdiff_t>(x)];
          visit(pen + glyph->bitmap_left + static_cast<int>(x), static_cast<int>(y) - glyph->bitmap_top, share / 255.0);
        }
      }
      pen += static_cast<int>(glyph->advance.x / 64);  // FreeType's unit is 1/64 pixel
    }
    return pen;
  }
  [[nodiscard]] int width(std::string_view text) const {
    return draw(text, [](int, int, double) {});
  }

 private:
  struct Done {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
  };
  std::unique_ptr<std::remove_pointer_t<FT_Library>, Done> library_;
  std::unique_ptr<std::remove_pointer_t<FT_Face>, Done> face_;
};

/// The pixels of a picture that a rectangle covers, as far as they are in it.
template <class Visit>
void visit_rectangle(Image& image, int x0, int y0, int width, int height, const Visit& visit) {
  for (int y = std::max(0, y0); y < std::min(image.height, y0 + height); ++y) {
    for (int x = std::max(0, x0); x < std::min(image.width, x0 + width); ++x) visit(x, y);
  }
}

}  // namespace

void draw_legend(Image& image, std::span<const LegendEntry> entries) {
  if (entries.empty()) return;
  constexpr double kReadable = 0.7;  // of these sizes
  const double scale = std::max(kReadable, image.height / 720.0);
  const auto scaled = [&](double pixels) { return static_cast<int>(std::lround(pixels * scale)); };
  const Font font(scaled(kTextSize));
  const int padding = scaled(kPadding), row = scaled(kRow), swatch = scaled(kSwatch);
  int widest = 0;
  for (const LegendEntry& entry : entries) widest = std::max(widest, font.width(entry.text));
  const int height = static_cast<int>(entries.size()) * row + padding, width = swatch + widest + 3 * padding;
  const int left = padding, top = image.height - padding - height;
  visit_rectangle(image, left, top, width, height, [&](int x, int y) { blend(image.at(x, y), kGround, kGroundShare); });
  int y0 = top + padding / 2 + (row - swatch) / 2;
  for (const LegendEntry& entry : entries) {
    const int x0 = left + padding;
    visit_rectangle(image, x0, y0, swatch, swatch, [&](int x, int y) {
      constexpr glm::dvec3 kOwn{0.80, 0.70, 0.60};  // of a wall
      const bool is_border = x == x0 || y == y0 || x == x0 + swatch - 1 || y == y0 + swatch - 1;
      image.at(x, y) = is_border ? kText : to_rgba(styled(entry.style, kOwn, x, y, image.height));
    });
    const int base = y0 + swatch - scaled(2), text = x0 + swatch + padding;
    font.draw(entry.text, [&](int x, int y, double share) {
      visit_rectangle(image, text + x, base + y, 1, 1, [&](int px, int py) { blend(image.at(px, py), kText, share); });
    });
    y0 += row;
  }
}

}  // namespace occlude::render
