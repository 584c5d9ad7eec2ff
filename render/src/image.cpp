// SPDX-License-Identifier: MIT
#include "occlude/render/image.h"

#include <png.h>

#include <string>

#include "occlude/render/errors.h"
#include "occlude/render/output_file.h"

namespace occlude::render {
namespace {

std::string encode(const std::filesystem::path& file, const Image& picture) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(picture.width);
  png.height = static_cast<png_uint_32>(picture.height);
  png.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  constexpr int kAllBits = 0;     // no reduction to 8 bits: there are no more
  constexpr int kPackedRows = 0;  // row stride: rows follow one another
  if (png_image_write_to_memory(&png, bytes.data(), &size, kAllBits, picture.pixels.data(), kPackedRows, nullptr) == 0)
    throw InputError(file.string() + ": cannot encode the picture: " + png.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace

void write_png(const std::filesystem::path& file, const Image& image) {
  OutputFile output(file);
  output.write(encode(file, image));
  output.commit();
}

}  // namespace occlude::render
