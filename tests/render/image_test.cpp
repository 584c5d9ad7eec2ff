// SPDX-License-Identifier: MIT
#include "occlude/render/image.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace image_test {

namespace fs = std::filesystem;

class ImageTest : public testing::Test {
 protected:
  ImageTest() { fs::create_directories(folder_); }
  ~ImageTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string written(const Image& image) const {
    OutputFile file(folder_ / "a.png");
    write_png(file, image);
    file.commit();
    std::ostringstream out;
    out << std::ifstream(folder_ / "a.png", std::ios::binary).rdbuf();
    return out.str();
  }

  fs::path folder_ = fs::temp_directory_path() / ("occlude_image_" + std::to_string(getpid()));
};

TEST_F(ImageTest, RasterRowsRunFromTheTop) {
  const Raster<int> raster{2, 2, {1, 2, 3, 4}};
  EXPECT_EQ(raster.at(1, 0), 2);
  EXPECT_EQ(raster.at(0, 1), 3);
}

TEST_F(ImageTest, WritesAWholePngOfItsSize) {
  const std::string png = written({3, 2, std::vector<Rgba>(6, Rgba{10, 20, 30, 255})});
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(12, 4), "IHDR");
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\0\3\0\0\0\2", 8));
  EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND");
}

TEST_F(ImageTest, EqualPicturesGiveEqualFiles) {
  const Image image{2, 1, {Rgba{1, 2, 3, 255}, Rgba{4, 5, 6, 255}}};
  EXPECT_EQ(written(image), written(image));
  EXPECT_NE(written(image), written({2, 1, {Rgba{1, 2, 3, 255}, Rgba{4, 5, 7, 255}}}));
}

/// The types of the chunks of a PNG, and the data of those of the types of pictures: IDAT, and fdAT without its number.
struct Chunks {
  explicit Chunks(const std::string& png) {
    for (std::size_t at = 8; at < png.size();) {
      const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(png[at + i]); };
      const std::size_t length = std::size_t{byte(0)} << 24U | byte(1) << 16U | byte(2) << 8U | byte(3);
      const std::string type = png.substr(at + 4, 4), body = png.substr(at + 8, length);
      const auto checksum = crc32(0, reinterpret_cast<const Bytef*>(&png[at + 4]), static_cast<uInt>(length + 4));
      at += 8 + length;
      EXPECT_EQ(checksum, std::uint64_t{byte(0)} << 24U | byte(1) << 16U | byte(2) << 8U | byte(3)) << type;
      at += 4;
      types += type + ' ';
      if (type == "fcTL" || type == "fdAT") numbers.push_back(body[3]);
      if (type == "fcTL") controls.push_back(body.substr(4));
      if (type == "IDAT") pictures.push_back(body);
      if (type == "fdAT") pictures.push_back(body.substr(4));
    }
  }
  std::string types;
  std::vector<int> numbers;
  std::vector<std::string> controls, pictures;
};

TEST_F(ImageTest, AnAnimationHoldsItsPictures) {
  std::vector<Image> images;
  for (std::uint8_t i = 0; i < 3; ++i) images.push_back({3, 2, std::vector<Rgba>(6, Rgba{i, 20, 30, 255})});
  OutputFile file(folder_ / "a.png");
  Animation animation(file, 3, 25);
  for (const Image& image : images) animation.add(image);
  file.commit();
  std::ostringstream bytes;
  bytes << std::ifstream(folder_ / "a.png", std::ios::binary).rdbuf();
  const Chunks chunks(bytes.str());
  EXPECT_EQ(chunks.types, "IHDR tEXt acTL fcTL IDAT fcTL fdAT fcTL fdAT IEND ");
  EXPECT_EQ(chunks.numbers, (std::vector<int>{0, 1, 2, 3, 4}));  // none is missing, or viewers refuse the file
  for (const std::string& control : chunks.controls) {
    EXPECT_EQ(control, std::string("\0\0\0\3\0\0\0\2\0\0\0\0\0\0\0\0\0\1\0\x19\0\0", 22));
  }
  ASSERT_EQ(chunks.pictures.size(), images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
    EXPECT_EQ(chunks.pictures[i], Chunks(png_of(images[i])).pictures.at(0)) << i;
  EXPECT_TRUE(is_own_png(folder_ / "a.png"));
}

TEST_F(ImageTest, FailuresNameTheFileAndLeaveNothing) {
  OutputFile file(folder_ / "a.png");
  try {
    write_png(file, {0, 0, {}});
    FAIL() << "wrote a picture of nothing";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(file.path().string(), 0), 0U) << error.what();
  }
}

TEST_F(ImageTest, KnowsItsOwnByTheirNames) {
  const std::string bytes = written({1, 1, {Rgba{}}});
  EXPECT_TRUE(is_own_png(folder_ / "a.png"));
  std::ofstream(folder_ / "copy.png", std::ios::binary) << bytes;
  std::ofstream(folder_ / "short.png", std::ios::binary) << bytes.substr(0, 40);
  EXPECT_FALSE(is_own_png(folder_ / "copy.png"));
  EXPECT_FALSE(is_own_png(folder_ / "short.png"));
  EXPECT_FALSE(is_own_png(folder_ / "none.png"));
}

}  // namespace image_test
}  // namespace occlude::render
