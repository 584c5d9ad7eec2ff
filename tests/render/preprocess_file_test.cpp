// SPDX-License-Identifier: MIT
#include "occlude/render/preprocess_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "occlude/render/errors.h"
#include "occlude/render/walk.h"

namespace {

using namespace occlude;
using namespace occlude::render;

culler::PolygonSoup walls(int count) {
  culler::PolygonSoup soup;
  for (int i = 1; i <= count; ++i) {
    std::array<std::uint32_t, 4> loop{};
    const std::array<glm::dvec3, 4> corners{{{i, -i, -i}, {i, i, -i}, {i, i, i}, {i, -i, i}}};
    for (std::size_t k = 0; k < 4; ++k) loop[k] = soup.add_vertex(corners[k]);
    soup.add_polygon(loop);
  }
  return soup;
}

class PreprocessFileTest : public testing::Test {
 protected:
  PreprocessFileTest() : folder_(std::filesystem::temp_directory_path() / ("occlude_pre_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    OutputFile output(file());
    write_preprocess(output, soup_, preprocess_);
    output.commit();
  }
  ~PreprocessFileTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path file() const { return folder_ / "walls.pre"; }
  [[nodiscard]] WalkOptions of_file() const {
    WalkOptions options;
    options.preprocess = file();
    return options;
  }

  /// The message for a changed file.
  std::string refusal(const std::function<void(std::string&)>& change) {
    std::ifstream in(file(), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    change(bytes);
    const std::filesystem::path other = folder_ / "other.pre";
    std::ofstream(other, std::ios::binary) << bytes;
    try {
      static_cast<void>(read_preprocess(other, soup_));
    } catch (const InputError& error) {
      const std::string said = error.what();
      EXPECT_TRUE(said.starts_with(other.string() + ": ")) << said;
      return said.substr(other.string().size() + 2);
    }
    return "";
  }

  culler::PolygonSoup soup_ = walls(40);
  culler::Preprocess preprocess_ = culler::preprocess(
      soup_, {.hierarchy = {.leaf_size = 2, .bounds = culler::Bounds::obb}, .lists = {.threshold = 0.1, .regions = 64}},
      {.viewpoints = 1});
  std::filesystem::path folder_;
};

TEST_F(PreprocessFileTest, IsReadBackAsWritten) {
  const culler::Preprocess read = read_preprocess(file(), soup_);
  EXPECT_EQ(read.config.hierarchy.leaf_size, 2U);
  EXPECT_EQ(read.config.hierarchy.bounds, culler::Bounds::obb);
  EXPECT_EQ(read.config.lists.threshold, 0.1);
  EXPECT_EQ(read.config.lists.regions, 64);
  EXPECT_TRUE(read.config.occluders.shells);
  EXPECT_EQ(read.layout.order, preprocess_.layout.order);
  EXPECT_EQ(read.layout.left, preprocess_.layout.left);
  EXPECT_EQ(read.lists.first, preprocess_.lists.first);
  EXPECT_EQ(read.lists.occluders, preprocess_.lists.occluders);
  EXPECT_EQ(read.lists.hidden, preprocess_.lists.hidden);
  EXPECT_FALSE(read.lists.hidden.empty());
  EXPECT_EQ(make_culler(soup_, of_file()).hierarchy().nodes().size(), preprocess_.layout.left.size());
}

TEST_F(PreprocessFileTest, WhatIsRefused) {
  EXPECT_EQ(refusal([](std::string&) {}), "");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes.clear(); }), "not a file of occlude preprocess");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes = "ply\n" + bytes; }), "not a file of occlude preprocess");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes[19] = 7; }),
            "format version 7, but this program reads version 2: preprocess the model again");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes[19] = 1; }),
            "format version 1, but this program reads version 2: preprocess the model again");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes += 'x'; }), "there is data after the checksum");
  for (std::size_t at = 23; at < 4000; at += 61) {
    EXPECT_NE(refusal([&](std::string& bytes) { bytes.at(at) = static_cast<char>(bytes[at] ^ 4); }), "") << at;
  }
  for (std::size_t end = 19; end < 4000; end += 97) {
    EXPECT_EQ(refusal([&](std::string& bytes) { bytes.resize(end); }),
              "the file ends too early, at byte " + std::to_string(end));
  }
}

TEST_F(PreprocessFileTest, IsOfOneModel) {
  culler::PolygonSoup other = soup_;
  other.vertices[5].z += 1e-9;
  try {
    static_cast<void>(read_preprocess(file(), other));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), file().string() + ": made from another model: preprocess this one");
  }
}

TEST_F(PreprocessFileTest, WhatCannotBeOfTheModel) {
  const auto refusal = [&](const culler::Preprocess& wrong) -> std::string {
    OutputFile output(file());
    write_preprocess(output, soup_, wrong);
    output.commit();
    try {
      static_cast<void>(make_culler(soup_, of_file()));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(preprocess_), "");
  culler::Preprocess wrong = preprocess_;
  wrong.layout.order[3] = wrong.layout.order[4];
  EXPECT_EQ(refusal(wrong), file().string() + ": the order is not one of this model");
  wrong = preprocess_;
  wrong.config.lists.threshold = std::nan("");
  EXPECT_EQ(refusal(wrong), file().string() + ": the threshold of the lists must be above 0");
  for (const double regions : {0.0, 0x1p31, std::nan(""), HUGE_VAL}) {
    wrong = preprocess_;
    wrong.config.lists.regions = regions;
    EXPECT_EQ(refusal(wrong), file().string() + ": the number of regions must be from 1 to 2^30");
  }
}

}  // namespace
