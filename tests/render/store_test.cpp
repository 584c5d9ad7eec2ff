// SPDX-License-Identifier: MIT
#include "occlude/render/store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "frame/culler_access.h"
#include "harness/rehashed.h"
#include "harness/store_parts.h"
#include "occlude/render/city.h"
#include "occlude/render/errors.h"
#include "occlude/render/model_io.h"
#include "occlude/render/walk.h"
#include "occlude/render/witness.h"
#include "store_format.h"

namespace store_test {

using namespace occlude;
using namespace occlude::render;
using culler::Method;

class StoreTest : public testing::Test {
 protected:
  StoreTest() : folder_(std::filesystem::temp_directory_path() / ("occlude_store_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    OutputFile output(file());
    write_store(output, culler_);
    output.commit();
    std::ifstream in(file(), std::ios::binary);
    bytes_ = {std::istreambuf_iterator<char>(in), {}};
  }
  ~StoreTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path file() const { return folder_ / "walls.store"; }
  [[nodiscard]] std::filesystem::path other() const { return folder_ / "other.store"; }

  /// Writes a changed store to other().
  void write_changed(const std::function<void(std::string&)>& change) const {
    std::string bytes = bytes_;
    change(bytes);
    std::ofstream(other(), std::ios::binary) << bytes;
  }
  /// The message for a changed store, less the name of the file.
  [[nodiscard]] std::string refusal(const std::function<void(std::string&)>& change) const {
    write_changed(change);
    try {
      for (const Method method : {Method::frusta, Method::cover}) static_cast<void>(read_store(other(), method));
    } catch (const InputError& error) {
      const std::string said = error.what();
      EXPECT_TRUE(said.starts_with(other().string() + ": ")) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
      return said.substr(other().string().size() + 2);
    }
    return "";
  }

  /// The witnesses of some frames, line by line.
  [[nodiscard]] std::vector<std::string> witnesses(const culler::Culler& culler, Method method) const {
    culler::CullOptions options{.method = culler::Method::frusta};
    options.method = method;
    std::vector<std::string> lines;
    culler::View view;
    for (std::size_t frame = 0; frame < 40; frame += 10) {
      const culler::Camera camera = city_.path.camera(frame, 16.0 / 9);
      const culler::CullResult& result = culler.cull(camera, options, view);
      append_witnesses(lines, frame, camera, culler, result, options, covers_of(culler, camera, result, options));
    }
    return lines;
  }

  [[nodiscard]] StoreHeader header() const {
    StoreHeader header;
    std::memcpy(&header, bytes_.data(), sizeof header);
    return header;
  }
  [[nodiscard]] std::vector<StoreSection> table() const {
    std::vector<StoreSection> table(header().sections);
    std::memcpy(table.data(), bytes_.data() + sizeof(StoreHeader), table.size() * sizeof(StoreSection));
    return table;
  }
  /// The refusal of a store with another table, and the right hashes for it.
  [[nodiscard]] std::string with_table(const std::function<void(StoreHeader&, std::vector<StoreSection>&)>& change) const {
    return refusal([&](std::string& bytes) {
      StoreHeader changed = header();
      std::vector<StoreSection> sections = table();
      change(changed, sections);
      changed.hash = hash_of(changed, sections);
      std::memcpy(bytes.data(), &changed, sizeof changed);
      std::memcpy(bytes.data() + sizeof changed, sections.data(), sections.size() * sizeof(StoreSection));
    });
  }

  City city_ = generate_city(1000, 3);
  culler::Culler culler_ = culler::preprocess(
      city_.soup, {.hierarchy = {.leaf_size = 4}, .lists = {.threshold = 0.1, .regions = 64}}, {.viewpoints = 1});
  std::filesystem::path folder_;
  std::string bytes_;
};

TEST_F(StoreTest, CullsAsTheModel) {
  for (const Method method : {Method::frusta, Method::cover}) {
    const culler::Culler read = read_store(file(), method);
    EXPECT_EQ(read.hierarchy().leaf_size(), 4U);
    EXPECT_EQ(read.config().lists.regions, 64);
    // Read for covers, it has no occluders. They are made now, without samples.
    EXPECT_EQ(occluders_of(read).lists().stored().hidden.empty(), method == Method::cover);
    EXPECT_EQ(occluders_of(read).size(), occluders_of(culler_).size());
    const std::vector<std::string> expected = witnesses(culler_, method);
    EXPECT_GT(expected.size(), 100U);
    EXPECT_EQ(witnesses(read, method), expected);
  }
}

TEST_F(StoreTest, HoldsTheModel) {
  EXPECT_TRUE(is_store(file()));
  const culler::PolygonSoup model = read_model(file()).soup;
  EXPECT_EQ(model.vertices, city_.soup.vertices);
  EXPECT_EQ(model.indices, city_.soup.indices);
  EXPECT_EQ(model.first, city_.soup.first);
}

TEST_F(StoreTest, HoldsFacesAndWhatIsSeeThrough) {
  culler::PolygonSoup soup = city_.soup;
  std::vector<std::uint32_t> doorway;
  for (const auto& [y, z] :
       std::vector<std::pair<int, int>>{{0, 0}, {4, 0}, {4, 8}, {6, 8}, {6, 0}, {10, 0}, {10, 9}, {0, 9}}) {
    doorway.push_back(soup.add_vertex({0, y, z}));
  }
  soup.see_through_from(soup.size() - 2);
  ASSERT_EQ(soup.add_face(doorway), culler::FaceShape::pieces);
  OutputFile output(folder_ / "faces.pre");
  write_store(output, culler::Culler(soup));
  output.commit();
  const culler::PolygonSoup model = read_model(folder_ / "faces.pre").soup;
  EXPECT_EQ(model.indices, soup.indices);
  EXPECT_EQ(model.faces, soup.faces);
  EXPECT_EQ(model.see_through, soup.see_through);
  const culler::Culler culler = read_store(folder_ / "faces.pre", Method::cover);
  EXPECT_TRUE(is_model_of(soup, culler));
  culler::PolygonSoup other = soup;
  other.see_through[0] = 1;
  EXPECT_FALSE(is_model_of(other, culler));
  other = soup;
  other.faces.back() += 1;
  EXPECT_FALSE(is_model_of(other, culler));
}

TEST_F(StoreTest, IsOfOneModel) {
  WalkOptions options;
  options.preprocess = file();
  EXPECT_EQ(make_culler(city_.soup, options).hierarchy().nodes().size(), culler_.hierarchy().nodes().size());
  const auto refusal_of = [&](const std::function<void(culler::PolygonSoup&)>& change) -> std::string {
    culler::PolygonSoup other = city_.soup;
    change(other);
    try {
      static_cast<void>(make_culler(other, options));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string expected = file().string() + ": made from another model: preprocess this one";
  EXPECT_EQ(refusal_of([](auto& soup) { soup.vertices[5].z += 1e-9; }), expected);
  EXPECT_EQ(refusal_of([](auto& soup) { std::swap(soup.indices[0], soup.indices[1]); }), expected);
  EXPECT_EQ(refusal_of([](auto& soup) { soup.add_box({0, 0, 0}, {1, 1, 1}); }), expected);
}

TEST_F(StoreTest, IsWrittenTheSameTwice) {
  OutputFile output(other());
  write_store(output, read_store(file(), Method::frusta));
  output.commit();
  std::ifstream in(other(), std::ios::binary);
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>(in), {}}), bytes_);
  EXPECT_EQ(hash_of_store(file()), hash_of_store(other()));
}

TEST_F(StoreTest, WhatIsRefused) {
  EXPECT_EQ(refusal([](std::string&) {}), "");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes.clear(); }), "not a file of occlude preprocess");
  EXPECT_EQ(refusal([](std::string& bytes) { bytes = "ply\n" + bytes; }), "not a file of occlude preprocess");
  for (const int version : {1, 2, 6, 8}) {
    EXPECT_EQ(
        refusal([&](std::string& bytes) { bytes[19] = static_cast<char>(version); }),
        "format version " + std::to_string(version) + ", but this program reads version 7: preprocess the model again");
  }
  EXPECT_EQ(refusal([](std::string& bytes) { bytes += 'x'; }), "there is data after the last section");
}

/// Whichever bit changes, the store is refused: no byte of it is in no hash.
TEST_F(StoreTest, ABitFlippedAnywhereIsRefused) {
  constexpr std::uint32_t kSeed = 1;
  std::mt19937_64 random(kSeed);
  for (int run = 0; run < 1000; ++run) {
    const std::size_t bit = random() % (8 * bytes_.size());
    const auto flip = [&](std::string& bytes) {
      bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ static_cast<char>(1U << bit % 8));
    };
    EXPECT_NE(refusal(flip), "") << "bit " << bit << ", seed " << kSeed;
  }
}

/// The same of the bits of the header, the table, and the beginnings and ends of sections, with what fills them up.
TEST_F(StoreTest, ABitFlippedAtABorderIsRefused) {
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < sizeof(StoreHeader) + 2 * sizeof(StoreSection); ++i) at.push_back(i);
  for (const StoreSection& section : table()) {
    if (section.bytes == 0) continue;
    at.insert(at.end(), {section.offset, section.offset + section.bytes - 1, aligned(section.offset + section.bytes) - 1});
  }
  for (const std::size_t i : at) {
    EXPECT_NE(refusal([&](std::string& bytes) { bytes[i] = static_cast<char>(bytes[i] ^ 4); }), "") << i;
  }
}

TEST_F(StoreTest, CutAnywhereItIsRefused) {
  std::vector<std::size_t> ends{19, 23, 40, 63, 64, 100};
  for (const StoreSection& section : table()) {
    ends.insert(ends.end(), {section.offset, section.offset + section.bytes / 2});
    if (section.bytes > 0) ends.push_back(section.offset + section.bytes - 1);
  }
  ends.push_back(bytes_.size() - 1);
  for (const std::size_t end : ends) {
    EXPECT_EQ(refusal([&](std::string& bytes) { bytes.resize(end); }),
              "the file ends too early, at byte " + std::to_string(end));
  }
}

TEST_F(StoreTest, TablesThatLieAreRefused) {
  const std::string damaged = "its table is damaged: preprocess the model again";
  EXPECT_EQ(with_table([](auto&, auto&) {}), "");
  for (const std::uint64_t wrong : {std::uint64_t{0}, std::uint64_t{63}, bytes_.size() + 64, ~std::uint64_t{0}}) {
    EXPECT_NE(with_table([&](auto& header, auto&) { header.bytes = wrong; }), "") << wrong;
    EXPECT_EQ(with_table([&](auto&, auto& table) { table[2].offset = wrong; }), damaged) << wrong;
    EXPECT_NE(with_table([&](auto&, auto& table) { table[2].bytes = wrong; }), "") << wrong;
  }
  EXPECT_EQ(with_table([&](auto&, auto& table) { table.back().bytes += 64; }), damaged);
  EXPECT_EQ(with_table([&](auto&, auto& table) { table[1].name.fill('x'); }), damaged);
  EXPECT_EQ(with_table([&](auto&, auto& table) { std::swap(table[1].name, table[2].name); }).substr(0, 4), "part");
  EXPECT_EQ(with_table([&](auto&, auto& table) { table[1].element = 0; }).substr(0, 4), "part");
  EXPECT_EQ(with_table([&](auto&, auto& table) { table[1].name.fill(0); }).substr(0, 4), "part");
  EXPECT_EQ(with_table([&](auto& header, auto& table) {
              header.sections = 0xFFFFFFFFU;
              table.resize(1);
            }),
            "the file ends too early, at byte " + std::to_string(bytes_.size()));
}

/// A few bytes cannot ask for any amount of work, whatever their settings are.
TEST_F(StoreTest, ListsThatItCouldNotHoldAreRefused) {
  const auto forged = [&](double regions) {
    return refusal([&](std::string& bytes) {
      harness::StoreParts parts(std::as_bytes(std::span(bytes)));
      std::vector<double> config = parts["config"].get<double>();
      config[3] = regions;
      parts["config"].set(config);
      std::erase_if(parts.parts, [](const auto& part) { return culler::Culler::method_of(part.name) == Method::frusta; });
      const std::vector<std::byte> store = parts.store();
      bytes.assign(reinterpret_cast<const char*>(store.data()), store.size());
    });
  };
  EXPECT_EQ(forged(0x1p30), "part \"config\": it asks for more regions than its bytes could hold");
  EXPECT_EQ(forged(32768), "");
}

/// What is not read for frames by cover is in the file all the same.
TEST_F(StoreTest, ManyRegionsAreReadForFramesByEitherMethod) {
  const culler::Culler many(city_.soup, {.lists = {.regions = 200'000}});
  OutputFile output(other());
  write_store(output, many);
  output.commit();
  for (const Method method : {Method::frusta, Method::cover}) {
    EXPECT_EQ(read_store(other(), method).config().lists.regions, 200'000);
  }
}

/// With the right hashes the contents decide. tests/culler/parts_test.cpp has more of these.
TEST_F(StoreTest, ContentsThatCannotBeAreRefused) {
  for (const StoreSection& section : table()) {
    if (section.bytes < section.element) continue;
    const std::string name(section.name.data());
    const std::string said = refusal([&](std::string& bytes) {
      std::memset(bytes.data() + section.offset, 0xFE, std::min<std::size_t>(section.element, 8));
      harness::rehash(std::as_writable_bytes(std::span(bytes)));
    });
    const bool may_be = name == "cells" || name == "space";  // regions may be anywhere
    EXPECT_EQ(said.empty(), may_be) << name;
  }
}

}  // namespace store_test
