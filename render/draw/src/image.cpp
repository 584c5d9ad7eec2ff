// SPDX-License-Identifier: MIT
#include "occlude/render/image.h"

#include <png.h>
#include <zlib.h>

#include <fstream>
#include <string>
#include <string_view>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

/// The length of the start of every PNG: 8 bytes of signature, and the chunk IHDR: length, type, 13 bytes of data and
/// checksum.
constexpr std::size_t kHead = 8 + 4 + 4 + 13 + 4;

std::string big_endian(std::size_t value) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(value >> shift & 0xFFU);
  return bytes;
}

std::size_t number_at(std::string_view bytes, std::size_t at) {
  std::size_t value = 0;
  for (const char byte : bytes.substr(at, 4)) value = value << 8U | static_cast<unsigned char>(byte);
  return value;
}

/// A chunk of a PNG. `type` has four letters.
std::string chunk(std::string_view type, std::string_view data) {
  const std::string typed = std::string(type) + std::string(data);
  const auto checksum = crc32_z(0, reinterpret_cast<const Bytef*>(typed.data()), typed.size());
  return big_endian(data.size()) + typed + big_endian(checksum);
}

/// A text chunk, which readers ignore, to be inserted after the start. The simplified interface of libpng cannot write
/// one.
std::string marker(const std::filesystem::path& file) {
  return chunk("tEXt", std::string("Software") + '\0' + "occlude, " + file.filename().string());
}

/// `what` names the picture in an error.
std::string encode(const std::string& what, const Image& picture) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(picture.width);
  png.height = static_cast<png_uint_32>(picture.height);
  png.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  constexpr int kAllBits = 0;     // no reduction to 8 bits is needed
  constexpr int kPackedRows = 0;  // row stride: rows are contiguous
  if (png_image_write_to_memory(&png, bytes.data(), &size, kAllBits, picture.pixels.data(), kPackedRows, nullptr) == 0)
    throw InputError(what + ": cannot encode the picture: " + png.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::vector<std::uint32_t> ItemBuffer::pixels_of(std::size_t polygons) const {
  std::vector<std::uint32_t> counts = see_through;
  counts.resize(polygons);
  for (const std::uint32_t p : pixels) {
    if (p != kNothing) ++counts[p];
  }
  return counts;
}

Image halved(const Image& image) {
  Image half{image.width / 2, image.height / 2, {}};
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      const auto mean = [&](std::uint8_t Rgba::*channel) {
        const int sum = image.at(2 * x, 2 * y).*channel + image.at(2 * x + 1, 2 * y).*channel +
                        image.at(2 * x, 2 * y + 1).*channel + image.at(2 * x + 1, 2 * y + 1).*channel;
        return static_cast<std::uint8_t>((sum + 2) / 4);
      };
      half.pixels.push_back({mean(&Rgba::r), mean(&Rgba::g), mean(&Rgba::b), mean(&Rgba::a)});
    }
  }
  return half;
}

std::string png_of(const Image& picture) { return encode("a picture", picture); }

void write_png(OutputFile& file, const Image& image) {
  file.write(encode(file.path().string(), image).insert(kHead, marker(file.path())));
}

void Animation::add(const Image& image) {
  constexpr std::size_t kFrame = 8 + 4;  // a chunk's length and type before its data, its checksum after it
  const std::string png = encode(file_.path().string(), image);
  if (added_ == 0) {
    constexpr std::uint32_t kWithoutEnd = 0;
    file_.write(png.substr(0, kHead) + marker(file_.path()) +
                chunk("acTL", big_endian(pictures_) + big_endian(kWithoutEnd)));
  }
  const std::string delay{'\0', '\1', static_cast<char>(fps_ >> 8U), static_cast<char>(fps_)};  // 1 / fps seconds
  const std::string whole_and_opaque(2, '\0');
  file_.write(chunk("fcTL", big_endian(chunks_++) + big_endian(static_cast<std::size_t>(image.width)) +
                                big_endian(static_cast<std::size_t>(image.height)) + big_endian(0) + big_endian(0) + delay +
                                whole_and_opaque));
  for (std::size_t at = kHead; at < png.size();) {
    const std::size_t length = number_at(png, at);
    const std::string_view type = std::string_view(png).substr(at + 4, 4),
                           data = std::string_view(png).substr(at + 8, length);
    if (type == "IDAT")
      file_.write(added_ == 0 ? chunk(type, data) : chunk("fdAT", big_endian(chunks_++) + std::string(data)));
    at += kFrame + length;
  }
  if (++added_ == pictures_) file_.write(chunk("IEND", {}));
}

bool is_own_png(const std::filesystem::path& file) {
  const std::string expected = marker(file);
  std::string found(expected.size(), '\0');
  std::ifstream(file, std::ios::binary).seekg(kHead).read(found.data(), static_cast<std::streamsize>(found.size()));
  return found == expected;
}

}  // namespace occlude::render
