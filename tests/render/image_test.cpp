// SPDX-License-Identifier: MIT
#include "occlude/render/image.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

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

}  // namespace
}  // namespace occlude::render
