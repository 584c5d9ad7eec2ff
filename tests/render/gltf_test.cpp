// SPDX-License-Identifier: MIT
// glTF files, made here and kept in tests/data/models.
#include <draco/compression/encode.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "model_readers.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/model_io.h"
#include "page_reader.h"

namespace occlude::render {
namespace gltf_test {

namespace fs = std::filesystem;
using culler::PolygonSoup;
using glm::dvec3;
using nlohmann::json;

/// Numbers one after another, as a file has them.
template <class T>
std::string bytes_of(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

template <class T>
constexpr int component_of() {
  if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
  if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
  if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
  if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
  if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
  if constexpr (std::is_same_v<T, float>) return 5126;
}

constexpr const char* kBase64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(const std::string& bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kBase64[bits >> (18 - 6 * k) & 63U];
  }
  return text;
}

/// A file in the making: one buffer, a scene with one node, its mesh with one primitive.
struct File {
  json root = {{"asset", {{"version", "2.0"}}},
               {"scene", 0},
               {"scenes", {{{"nodes", {0}}}}},
               {"nodes", {{{"mesh", 0}}}},
               {"meshes", {{{"primitives", {{{"attributes", json::object()}}}}}}},
               {"accessors", json::array()},
               {"bufferViews", json::array()}};
  std::string bytes;

  json& primitive() { return root["meshes"][0]["primitives"][0]; }
  json& node(std::size_t i = 0) { return root["nodes"][i]; }

  std::size_t add_view(const std::string& content) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", content.size()}});
    bytes += content;
    return root["bufferViews"].size() - 1;
  }
  template <class T>
  std::size_t add(const std::vector<T>& numbers, const char* type, std::size_t width, bool is_normalized = false) {
    json accessor = {{"bufferView", add_view(bytes_of(numbers))},
                     {"componentType", component_of<T>()},
                     {"count", numbers.size() / width},
                     {"type", type}};
    if (is_normalized) accessor["normalized"] = true;
    root["accessors"].push_back(accessor);
    return root["accessors"].size() - 1;
  }
  template <class T>
  void set_positions(const std::vector<T>& numbers, bool is_normalized = false) {
    primitive()["attributes"]["POSITION"] = add(numbers, "VEC3", 3, is_normalized);
  }
  template <class T>
  void set_indices(const std::vector<T>& indices) {
    primitive()["indices"] = add(indices, "SCALAR", 1);
  }

  [[nodiscard]] std::string text() const {
    json whole = root;
    whole["buffers"][0] = {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}};
    return whole.dump();
  }
  /// As a container, whose buffers may be more than the first.
  [[nodiscard]] std::string binary() const {
    json whole = root;
    whole["buffers"][0]["byteLength"] = bytes.size();
    std::string text = whole.dump(), content = bytes;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    content.resize((content.size() + 3) / 4 * 4, '\0');
    const auto number = [](std::size_t value) { return bytes_of(std::vector{static_cast<std::uint32_t>(value)}); };
    return "glTF" + number(2) + number(28 + text.size() + content.size()) + number(text.size()) + "JSON" + text +
           number(content.size()) + std::string("BIN\0", 4) + content;
  }
};

/// Four corners of a square, and two triangles of it.
const std::vector<float> kSquare = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<std::uint16_t> kTwo = {0, 1, 2, 0, 2, 3};

File square() {
  File file;
  file.set_positions(kSquare);
  file.set_indices(kTwo);
  return file;
}

/// The corners of all polygons, in order.
std::vector<dvec3> corners(const PolygonSoup& soup) {
  std::vector<dvec3> all;
  for (const std::uint32_t index : soup.indices) all.push_back(soup.vertices[index]);
  return all;
}

std::vector<dvec3> moved(std::vector<dvec3> points, const dvec3& by) {
  for (dvec3& point : points) point += by;
  return points;
}

std::pair<dvec3, dvec3> box(const PolygonSoup& soup) {
  dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const dvec3& v : soup.vertices) low = glm::min(low, v), high = glm::max(high, v);
  return {low, high};
}

double area(const PolygonSoup& soup) {
  double sum = 0;
  const std::vector<dvec3> all = corners(soup);
  for (std::size_t i = 0; i < all.size(); i += 3)
    sum += glm::length(glm::cross(all[i + 1] - all[i], all[i + 2] - all[i])) / 2;
  return sum;
}

class GltfTest : public testing::Test {
 protected:
  GltfTest() { fs::create_directories(folder_); }
  ~GltfTest() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path store(const std::string& name, const std::string& content) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  [[nodiscard]] Model read(const File& file) const { return read_gltf(store("a.gltf", file.text())); }
  [[nodiscard]] Model read_binary(const File& file) const { return read_gltf(store("a.glb", file.binary())); }

  [[nodiscard]] Model read_coloured(const File& file) const { return read_gltf(store("a.gltf", file.text()), true); }

  /// The message without the name of the file.
  [[nodiscard]] static std::string failure(const fs::path& file, bool with_colours = false) {
    try {
      static_cast<void>(read_gltf(file, with_colours));
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_TRUE(what.starts_with(file.string() + ": ")) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      return what.substr(std::min(what.size(), file.string().size() + 2));
    }
    return "no error";
  }
  [[nodiscard]] std::string failure(const File& file) const { return failure(store("a.gltf", file.text())); }
  [[nodiscard]] std::string failure_coloured(const File& file) const { return failure(store("a.gltf", file.text()), true); }

  [[nodiscard]] static Model kept(const std::string& name) { return read_gltf(fs::path(OCCLUDE_MODELS) / name); }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("occlude_gltf_" + std::to_string(getpid()));
};

TEST_F(GltfTest, FilesThatPeopleReported) {
  {
    const PolygonSoup soup = kept("quantised_short.glb").soup;
    EXPECT_EQ(box(soup), std::pair(dvec3(5, 6, 7), dvec3(6, 8, 10)));
    EXPECT_NEAR(area(soup), 22, 1e-12);
  }
  {
    const PolygonSoup plain = kept("house_gltfpack.glb").soup, compressed = kept("house_gltfpack_c.glb").soup;
    EXPECT_EQ(plain.size(), 26U);
    const auto [low, high] = box(plain);
    EXPECT_LT(glm::length(low - dvec3(-10, 0, -10)), 1e-9);
    EXPECT_LT(glm::length(high - dvec3(10, 3, 10)), 1e-3);  // of 16383 steps
    EXPECT_NEAR(area(plain), area(compressed), 1e-9);
    EXPECT_EQ(box(plain), box(compressed));
  }
  {
    const PolygonSoup soup = kept("instances.glb").soup;
    EXPECT_EQ(soup.size(), 60U);
    EXPECT_EQ(box(soup).second.y, 9);
  }
  {
    // The top of the lower part and the bottom of the upper one.
    const PolygonSoup soup = kept("far_joint.glb").soup;
    EXPECT_EQ(box(soup), std::pair(dvec3(308456.37, 6215873.91, 42.5), dvec3(308457.37, 6215875.91, 43.5)));
    const auto at_joint = [](const dvec3& v) { return v.y == 6215874.91; };
    EXPECT_EQ(std::ranges::count_if(soup.vertices, at_joint), 8);
  }
  {
    const PolygonSoup soup = kept("glass.glb").soup;
    EXPECT_EQ(soup.size(), 14U);
    for (std::size_t p = 0; p < soup.size(); ++p) EXPECT_EQ(soup.is_opaque(p), p >= 2) << p;
  }
  EXPECT_EQ(box(kept("sparse.glb").soup), std::pair(dvec3(0), dvec3(1, 5, 1)));
  EXPECT_EQ(box(kept("mirrored.glb").soup), std::pair(dvec3(2, 0, 0), dvec3(3, 1, 1)));
}

TEST_F(GltfTest, TextAndContainerAreTheSame) {
  const Model text = read(square()), binary = read_binary(square());
  EXPECT_EQ(text.soup.size(), 2U);
  EXPECT_EQ(corners(text.soup), (std::vector<dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(corners(text.soup), corners(binary.soup));
  EXPECT_EQ(text.soup.vertices.size(), 4U);
  EXPECT_EQ(text.notes.file, (Convention{1, {0, 1, 0}}));
  EXPECT_TRUE(text.notes.warnings.empty());
}

TEST_F(GltfTest, TheCommandsReadItSo) {
  EXPECT_EQ(corners(read_model(store("A.GLTF", square().text())).soup), corners(read(square()).soup));
  EXPECT_EQ(corners(read_model(store("a.glb", square().binary())).soup), corners(read(square()).soup));
}

TEST_F(GltfTest, IndicesOfEveryKindAndNone) {
  const std::vector<dvec3> expected = corners(read(square()).soup);
  File bytes;
  bytes.set_positions(kSquare);
  bytes.set_indices(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3});
  EXPECT_EQ(corners(read(bytes).soup), expected);
  File words;
  words.set_positions(kSquare);
  words.set_indices(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
  EXPECT_EQ(corners(read(words).soup), expected);
  File none;
  none.set_positions(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0});
  EXPECT_EQ(corners(read(none).soup), expected);
}

TEST_F(GltfTest, StripsAndFans) {
  const auto faces = [&](int mode) {
    File file;
    file.set_positions(kSquare);
    file.primitive()["mode"] = mode;
    const PolygonSoup soup = read(file).soup;
    std::vector<std::vector<double>> loops;
    for (std::size_t p = 0; p < soup.size(); ++p) {
      auto& loop = loops.emplace_back();
      // The corners are numbered round the square.
      for (const std::uint32_t v : soup.loop(p))
        loop.push_back(soup.vertices[v].y == 0 ? soup.vertices[v].x : 3 - soup.vertices[v].x);
    }
    return loops;
  };
  EXPECT_EQ(faces(5), (std::vector<std::vector<double>>{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(faces(6), (std::vector<std::vector<double>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(GltfTest, PointsAndLinesAreLeftOut) {
  File file = square();
  const json one = file.primitive();
  for (const int mode : {0, 1, 2, 3}) {
    json other = one;
    other["mode"] = mode;
    file.root["meshes"][0]["primitives"].push_back(other);
  }
  const Model model = read(file);
  EXPECT_EQ(model.soup.size(), 2U);
  EXPECT_EQ(model.notes.points_and_lines, 6U + 3U + 6U + 5U);
}

TEST_F(GltfTest, CornersThatAreLeftOverAndVerticesThatAreNotUsed) {
  File file;
  file.set_positions(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, NAN, 9, 9, 1, 1, 1});
  file.set_indices(std::vector<std::uint16_t>{0, 1, 2, 0, 1});
  json other = file.primitive();  // shares the vertices
  other["indices"] = file.add(std::vector<std::uint16_t>{0, 4, 2}, "SCALAR", 1);
  file.root["meshes"][0]["primitives"].push_back(other);
  const Model model = read(file);
  EXPECT_EQ(model.soup.size(), 2U);
  EXPECT_EQ(model.notes.few_corners, 1U);
  EXPECT_EQ(model.notes.unused_vertices, 1U);
}

TEST_F(GltfTest, PrimitivesWithoutPositionsAreLeftOut) {
  File file = square();
  file.root["meshes"][0]["primitives"].push_back({{"attributes", json::object()}, {"indices", 1}});
  EXPECT_EQ(read(file).soup.size(), 2U);
}

template <class T>
File triangle_of(T one, bool is_normalized) {
  File file;
  // Elements are four components apart, as quantised positions must be.
  const std::size_t view = file.add_view(bytes_of(std::vector<T>{0, 0, 0, 0, one, 0, 0, 0, 0, one, 0, 0}));
  file.root["bufferViews"][view]["byteStride"] = 4 * sizeof(T);
  file.root["accessors"].push_back({{"bufferView", view},
                                    {"componentType", component_of<T>()},
                                    {"count", 3},
                                    {"type", "VEC3"},
                                    {"normalized", is_normalized}});
  file.primitive()["attributes"]["POSITION"] = 0;
  return file;
}

TEST_F(GltfTest, QuantisedPositionsOfEveryKind) {
  const auto x = [&](const File& file) { return corners(read(file).soup)[1].x; };
  EXPECT_EQ(x(triangle_of<std::int8_t>(-100, false)), -100);
  EXPECT_EQ(x(triangle_of<std::int8_t>(-100, true)), -100.0 / 127);
  EXPECT_EQ(x(triangle_of<std::int8_t>(-128, true)), -1);
  EXPECT_EQ(x(triangle_of<std::uint8_t>(200, false)), 200);
  EXPECT_EQ(x(triangle_of<std::uint8_t>(200, true)), 200.0 / 255);
  EXPECT_EQ(x(triangle_of<std::int16_t>(-32768, false)), -32768);
  EXPECT_EQ(x(triangle_of<std::int16_t>(-32768, true)), -1);
  EXPECT_EQ(x(triangle_of<std::int16_t>(12345, true)), 12345.0 / 32767);
  EXPECT_EQ(x(triangle_of<std::uint16_t>(65535, false)), 65535);
  EXPECT_EQ(x(triangle_of<std::uint16_t>(12345, true)), 12345.0 / 65535);
  EXPECT_EQ(x(triangle_of<float>(0.1F, false)), double{0.1F});
}

TEST_F(GltfTest, SparseAccessorsOverZerosAndOverOthers) {
  File file = square();
  json& accessor = file.root["accessors"][0];
  const std::size_t where = file.add_view(bytes_of(std::vector<std::uint8_t>{1, 3}));
  const std::size_t what = file.add_view(bytes_of(std::vector<float>{5, 0, 0, 0, 7, 0}));
  accessor["sparse"] = {
      {"count", 2}, {"indices", {{"bufferView", where}, {"componentType", 5121}}}, {"values", {{"bufferView", what}}}};
  EXPECT_EQ(corners(read(file).soup),
            (std::vector<dvec3>{{0, 0, 0}, {5, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 7, 0}}));
  accessor.erase("bufferView");
  EXPECT_EQ(corners(read(file).soup),
            (std::vector<dvec3>{{0, 0, 0}, {5, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 7, 0}}));
  accessor["sparse"]["count"] = 3;
  EXPECT_EQ(failure(file),
            "node 0: mesh 0: primitive 0: POSITION: accessor 0: sparse: 3 elements, 1 bytes apart from byte 0 on, do not "
            "fit in 2 bytes");
  accessor["sparse"]["count"] = 2;
  accessor["count"] = 3;
  EXPECT_EQ(failure(file), "node 0: mesh 0: primitive 0: POSITION: accessor 0: sparse: indices: element 3 of 3");
}

/// Rotations are written in few digits.
TEST_F(GltfTest, PlacementsAreDoubles) {
  File file = square();
  file.root["nodes"] = {{{"children", {1}}, {"translation", {308456.37, 6215873.91, 42.5}}},
                        {{"mesh", 0}, {"rotation", {0, 0, 0.7071068, 0.7071068}}, {"scale", {2, 3, -1}}}};
  for (const dvec3& corner : moved(corners(read(file).soup), {-308456.37, -6215873.91, -42.5})) {
    EXPECT_TRUE(corner.x == 0 || corner.x == -3) << corner.x;
    EXPECT_TRUE(corner.y == 0 || corner.y == 2) << corner.y;
  }
  file.node(1) = {{"mesh", 0}, {"matrix", {0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 1, 0, 1e-9, 0, 0, 1}}};
  file.node(0)["translation"] = {1, 0, 0};
  EXPECT_EQ(corners(read(file).soup)[2], dvec3(-3 + 1e-9 + 1, 2, 0));
  file.node(1)["matrix"][15] = 2;
  EXPECT_EQ(failure(file), "node 1: matrix: its last row is not 0, 0, 0, 1");
}

TEST_F(GltfTest, OnlyTheSceneIsShown) {
  File file = square();
  file.root["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 1}}}, {{"children", {1}}}};
  file.root["scenes"] = {{{"nodes", {0}}}, {{"nodes", {2, 0}}}};
  EXPECT_EQ(read(file).soup.size(), 2U);
  file.root["scene"] = 1;
  const PolygonSoup soup = read(file).soup;
  ASSERT_EQ(soup.size(), 4U);
  EXPECT_EQ(corners(soup)[0].z, 1);
  file.root.erase("scene");
  EXPECT_EQ(corners(read(file).soup)[0].z, 0);
  EXPECT_EQ(read(file).soup.size(), 4U);
  file.node(2)["extensions"]["KHR_node_visibility"]["visible"] = false;
  EXPECT_EQ(read(file).soup.size(), 2U);
}

TEST_F(GltfTest, GraphsThatAreNoTreesAreRefused) {
  File file = square();
  file.root["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"children", {2}}}, {{"children", json::array()}}};
  EXPECT_EQ(read(file).soup.size(), 2U);
  file.node(2)["children"] = {0};
  EXPECT_EQ(failure(file), "node 0: it is below itself");
  file.node(2)["children"] = {2};
  EXPECT_EQ(failure(file), "node 2: children: node 2 has another parent");
  file.node(2)["children"] = {3};
  EXPECT_EQ(failure(file), "node 2: children: node 3: there are 3");
  file.node(2)["children"] = json::array();
  file.root["scenes"][0]["nodes"] = {0, 0};
  EXPECT_EQ(failure(file), "scene 0: nodes: node 0 is listed twice");
  file.root["scenes"][0]["nodes"] = {1};
  EXPECT_EQ(failure(file), "scene 0: nodes: node 1 has a parent");
  file.root["scene"] = 1;
  EXPECT_EQ(failure(file), "scene 1: there are 1");
}

TEST_F(GltfTest, TreesMayBeDeep) {
  File file = square();
  constexpr std::size_t kDepth = 100'000;
  for (std::size_t i = 0; i < kDepth; ++i) {
    file.node(i)["children"] = {i + 1};
    file.root["nodes"].push_back({{"translation", {1, 0, 0}}});
  }
  file.node(kDepth)["mesh"] = 0;
  const PolygonSoup soup = read(file).soup;
  ASSERT_EQ(soup.size(), 4U);
  EXPECT_EQ(corners(soup)[6], dvec3(kDepth, 0, 0));
}

TEST_F(GltfTest, Instances) {
  File file = square();
  const std::vector<dvec3> plain = corners(read(file).soup);
  json attributes = {{"TRANSLATION", file.add(std::vector<float>{1, 0, 0, 0, 2, 0, 0, 0, 3}, "VEC3", 3)}};
  file.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
  file.node()["translation"] = {6e6 + 0.1, 0, 0};
  file.root["extensionsRequired"] = file.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  PolygonSoup soup = read(file).soup;
  ASSERT_EQ(soup.size(), 6U);
  EXPECT_EQ(corners(soup)[7], dvec3(1, 2, 0) + dvec3(6e6 + 0.1, 0, 0));
  file.node()["scale"] = {2, 2, 2};  // of the instances and their places
  EXPECT_EQ(corners(read(file).soup)[7], dvec3(2, 4, 0) + dvec3(6e6 + 0.1, 0, 0));
  file.node().erase("scale");
  // A quarter turn about z, in shorts; and scales in bytes, which are not normalized.
  attributes["ROTATION"] =
      file.add(std::vector<std::int16_t>{0, 0, 23170, 23170, 0, 0, 0, 32767, 0, 0, 0, 32767}, "VEC4", 4, true);
  attributes["SCALE"] = file.add(std::vector<std::int8_t>{2, 4, 1, 1, 1, 1, 1, 1, 1}, "VEC3", 3);
  file.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
  file.node().erase("translation");
  soup = read(file).soup;
  EXPECT_LT(glm::length(corners(soup)[1] - dvec3(1, 2, 0)), 1e-15);
  EXPECT_LT(glm::length(corners(soup)[2] - dvec3(1 - 4, 2, 0)), 1e-15);
  EXPECT_EQ(corners(soup)[8], dvec3(1, 1 + 2, 0));
  file.root["accessors"][attributes["SCALE"].get<std::size_t>()]["count"] = 2;
  EXPECT_EQ(failure(file), "node 0: EXT_mesh_gpu_instancing: SCALE: 2 instances instead of 3");
}

TEST_F(GltfTest, MorphTargetsAtRest) {
  File file = square();
  json& primitive = file.primitive();
  primitive["targets"] = {{{"POSITION", file.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3)}},
                          {{"NORMAL", 0}},
                          {{"POSITION", file.add(std::vector<float>{8, 0, 0, 8, 0, 0, 8, 0, 0, 8, 0, 0}, "VEC3", 3)}}};
  const std::vector<dvec3> plain = corners(read(file).soup);
  EXPECT_EQ(plain, corners(read(square()).soup));
  file.root["meshes"][0]["weights"] = {0.1, 1, 0.5};
  EXPECT_EQ(corners(read(file).soup), moved(plain, {4, 0, 0.1}));
  file.node()["weights"] = {0, 0, 1};
  EXPECT_EQ(corners(read(file).soup), moved(plain, {8, 0, 0}));
  file.root["accessors"][2]["count"] = 3;
  EXPECT_EQ(failure(file), "node 0: mesh 0: primitive 0: target 0: POSITION: 3 elements for 4 vertices");
}

TEST_F(GltfTest, SkinsAtRest) {
  File file = square();
  json& attributes = file.primitive()["attributes"];
  attributes["JOINTS_0"] = file.add(std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", 4);
  // In bytes, whose sum is not quite 1 for the second vertex: what is missing must not move it.
  attributes["WEIGHTS_0"] =
      file.add(std::vector<std::uint8_t>{255, 0, 0, 0, 127, 127, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0}, "VEC4", 4, true);
  const std::vector<float> inverses = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,  //
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
  file.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", file.add(inverses, "MAT4", 16)}}};
  file.root["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {1000, 0, 0}}},  // which does not move it
                        {{"translation", {6e6, 0, 0}}, {"children", {2}}},
                        {{"translation", {0, 0.25, 0}}, {"scale", {2, 1, 1}}}};
  file.root["scenes"][0]["nodes"] = {0, 1};
  // The first joint moves by (6e6, 0, 0); the second moves by (-1, 0, 0), scales, and moves by (6e6, 0.25, 0).
  EXPECT_EQ(corners(read(file).soup),
            (std::vector<dvec3>{
                {6e6, 0, 0}, {6e6 + 0.5, 0.125, 0}, {6e6, 1.25, 0}, {6e6, 0, 0}, {6e6, 1.25, 0}, {6e6 - 2, 1.25, 0}}));
  file.root["skins"][0]["joints"] = {1};
  EXPECT_EQ(failure(file), "node 0: mesh 0: primitive 0: vertex 1: joint 1 of 1");
}

TEST_F(GltfTest, WhatLetsLightThroughHidesNothing) {
  File file = square();
  file.root["materials"] = json::array({json::object()});
  file.primitive()["material"] = 0;
  EXPECT_TRUE(read(file).soup.is_opaque(0));
  for (const char* const mode : {"BLEND", "MASK"}) {
    file.root["materials"][0] = {{"alphaMode", mode}};
    EXPECT_FALSE(read(file).soup.is_opaque(1)) << mode;
  }
  file.root["materials"][0] = {{"alphaMode", "OPAQUE"}};
  for (const char* const name : {"KHR_materials_transmission", "ADOBE_materials_thin_transparency"}) {
    json& transmission = file.root["materials"][0]["extensions"][name];
    transmission = json::object();
    EXPECT_TRUE(read(file).soup.is_opaque(0)) << name;
    transmission["transmissionFactor"] = 0.1;
    EXPECT_FALSE(read(file).soup.is_opaque(0)) << name;
    transmission = json::object();
  }
  file.primitive()["material"] = 1;
  EXPECT_EQ(failure(file), "node 0: mesh 0: primitive 0: material 1: there are 1");
}

/// A pixel of red light and one of green.
constexpr const char* kRedAndGreen =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAD0lEQVR4nGP4z8DA8J8BAAf/Af8Bf4mnAAAAAElFTkSuQmCC";
/// An opaque blue pixel, and a red one that is not there.
constexpr const char* kBlue =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEUlEQVR4nGNgYPj//z8DAwMADvoC/n68pVoAAAAASUVORK5CYII=";

/// The square with a material that has a texture.
File textured(const json& image) {
  File file = square();
  file.primitive()["material"] = 0;
  file.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  file.root["textures"] = {{{"source", 0}}};
  file.root["images"] = json::array({image});
  return file;
}

using Colours = std::vector<Rgb>;

TEST_F(GltfTest, ColoursOfMaterialsAreLight) {
  File file = square();
  file.primitive()["material"] = 0;
  file.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0, 1, 0.25}}}}}};
  EXPECT_EQ(read_coloured(file).colours, Colours(2, {188, 0, 255}));
  EXPECT_TRUE(read_coloured(file).soup.is_opaque(0));
  EXPECT_TRUE(read(file).colours.empty()) << "not asked for";
  // Beside a primitive without a material.
  json& primitives = file.root["meshes"][0]["primitives"];
  const json plain = {{"attributes", {{"POSITION", 0}}}};
  primitives.insert(primitives.begin(), plain);
  EXPECT_EQ(read_coloured(file).colours.front(), kWhite);
  EXPECT_EQ(read_coloured(file).colours.back(), (Rgb{188, 0, 255}));
  file.root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1};
  EXPECT_EQ(failure_coloured(file), "node 0: mesh 0: primitive 1: material 0: baseColorFactor: 3 numbers instead of 4");
}

TEST_F(GltfTest, ATextureIsItsMean) {
  const std::string data = "data:image/png;base64,";
  EXPECT_EQ(read_coloured(textured({{"uri", data + kRedAndGreen}})).colours, Colours(2, {188, 188, 0}));
  EXPECT_EQ(read_coloured(textured({{"uri", data + kBlue}})).colours, Colours(2, {0, 0, 255}));
  File file = textured({{"uri", data + kRedAndGreen}});
  file.root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 1, 1, 1};
  EXPECT_EQ(read_coloured(file).colours, Colours(2, {137, 188, 0}));
  EXPECT_TRUE(text_of(read_coloured(file).notes).empty());
  // In a view of a container, and in a file.
  const std::string png = from_base64(kBlue);
  file = textured(json::object());
  file.root["images"][0] = {{"bufferView", file.add_view(png)}, {"mimeType", "image/png"}};
  EXPECT_EQ(read_gltf(store("a.glb", file.binary()), true).colours, Colours(2, {0, 0, 255}));
  static_cast<void>(store("a b.png", png));
  EXPECT_EQ(read_coloured(textured({{"uri", "a%20b.png"}})).colours, Colours(2, {0, 0, 255}));
}

TEST_F(GltfTest, WhatIsNoPngIsWhite) {
  static_cast<void>(store("cut.png", from_base64(kBlue).substr(0, 50)));
  static_cast<void>(store("../occlude_outside.png", from_base64(kBlue)));
  for (const char* const uri :
       {"cut.png", "none.png", "../occlude_outside.png", "data:image/png;base64,/9j/", "http://a/b.png"}) {
    File file = textured({{"uri", uri}});
    const Model model = read_coloured(file);
    EXPECT_TRUE(model.colours.empty()) << uri;
    EXPECT_EQ(text_of(model.notes), "1 texture is taken for white: only pictures in PNG are read") << uri;
    EXPECT_TRUE(text_of(read(file).notes).empty()) << "not asked for";
    file.root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0, 1, 1};
    EXPECT_EQ(read_coloured(file).colours, Colours(2, {0, 0, 255})) << uri;
  }
  fs::remove(folder_ / "../occlude_outside.png");
  File file = textured({{"uri", "none.png"}});
  file.root["textures"] = json::array({json::object()});
  EXPECT_EQ(text_of(read_coloured(file).notes), "1 texture is taken for white: only pictures in PNG are read");
}

TEST_F(GltfTest, ColoursOfVerticesAreTheirMean) {
  // Triangles of vertices 0, 1, 2 and 2, 1, 3, whatever the square is made of.
  File file;
  file.set_positions(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  file.set_indices(std::vector<std::uint8_t>{0, 1, 2, 2, 1, 3});
  const auto colours_are = [&](std::size_t accessor) {
    file.primitive()["attributes"]["COLOR_0"] = accessor;
    return read_coloured(file).colours;
  };
  const Colours expected{{156, 0, 0}, {0, 0, 156}};
  EXPECT_EQ(colours_are(file.add(std::vector<float>{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, "VEC3", 3)), expected);
  EXPECT_EQ(
      colours_are(file.add(std::vector<std::uint8_t>{255, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 255, 9}, "VEC4", 4, true)),
      expected);
  EXPECT_EQ(colours_are(file.add(std::vector<std::uint16_t>{65535, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 65535}, "VEC3", 3, true)),
            expected);
  EXPECT_TRUE(read(file).colours.empty()) << "not asked for";
  file.primitive()["material"] = 0;
  file.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0.5, 1}}}}}};
  EXPECT_EQ(read_coloured(file).colours, (Colours{{0, 0, 0}, {0, 0, 113}}));
  const std::size_t pairs = file.add(std::vector<float>(8), "VEC2", 2), few = file.add(std::vector<float>(9), "VEC3", 3);
  for (const auto& [accessor, reason] :
       {std::pair(pairs, "accessor 5: type: 2 instead of 3 components"), std::pair(few, "3 elements for 4 vertices"),
        std::pair(few + 1, "accessor 7: there are 7")}) {
    file.primitive()["attributes"]["COLOR_0"] = accessor;
    EXPECT_EQ(failure_coloured(file), std::string("node 0: mesh 0: primitive 0: COLOR_0: ") + reason);
    EXPECT_EQ(failure(file), "no error") << "not asked for";
  }
}

TEST_F(GltfTest, ExtensionsByName) {
  File file = square();
  file.root["extensionsRequired"] = {"KHR_texture_transform", "KHR_materials_unlit", "KHR_mesh_quantization"};
  file.root["extensionsUsed"] = {"KHR_texture_transform", "EXT_bend", "KHR_mesh_quantization", "EXT_twist"};
  EXPECT_EQ(read(file).notes.warnings,
            (std::vector<std::string>{"what these extensions say is left out: EXT_bend, EXT_twist"}));
  file.root["extensionsRequired"].push_back("EXT_bend");
  EXPECT_EQ(failure(file), "extensionsRequired: EXT_bend is not supported");
}

TEST_F(GltfTest, BuffersAreInTheFolderAlone) {
  File file = square();
  const std::vector<dvec3> expected = corners(read(file).soup);
  static_cast<void>(store("inside/sub/a b.bin", file.bytes));
  static_cast<void>(store("outside.bin", file.bytes));
  fs::create_symlink("sub/a b.bin", folder_ / "inside/link.bin");
  fs::create_symlink("../outside.bin", folder_ / "inside/link_out.bin");
  fs::create_directory_symlink("..", folder_ / "inside/up");
  ASSERT_EQ(mkfifo((folder_ / "inside/pipe.bin").c_str(), 0600), 0);
  const auto with_uri = [&](const std::string& uri) {
    json whole = file.root;
    whole["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", uri}}};
    return store("inside/a.gltf", whole.dump());
  };
  for (const char* const uri : {"sub/a%20b.bin", "sub/a b.bin", "./sub/a%20b.bin", "link.bin"})
    EXPECT_EQ(corners(read_gltf(with_uri(uri)).soup), expected) << uri;
  const auto refused = [&](const std::string& uri, const std::string& reason) {
    const std::string place = "node 0: mesh 0: primitive 0: POSITION: accessor 0: bufferView 0: buffer 0: ";
    EXPECT_EQ(failure(with_uri(uri)), place + "\"" + uri + "\": " + reason);
  };
  const std::string out = "it is not in the folder of the model";
  refused("../outside.bin", out);
  refused("%2e%2e/outside.bin", out);
  refused("sub/../sub/a%20b.bin", out);
  refused((folder_ / "inside/sub/a b.bin").string(), out);
  refused("/dev/zero", out);
  refused("link_out.bin", out);
  refused("up/outside.bin", out);
  refused("none.bin", "cannot read: No such file or directory");
  refused("http://localhost/a.bin", "only files are read");
  refused("file:sub/a.bin", "only files are read");
  refused("sub/a%20b.bin%00", "no name of a file");
  EXPECT_NE(failure(with_uri("pipe.bin")).find("it is not a regular file"), std::string::npos);
  EXPECT_NE(failure(with_uri("sub")).find("it is a directory"), std::string::npos);
  fs::resize_file(store("inside/large.bin", ""), kMostBytes + 1);  // a hole
  EXPECT_NE(failure(with_uri("large.bin")).find("it is larger than 4096 MiB"), std::string::npos);
  file.bytes += "more";
  EXPECT_NE(failure(with_uri("link.bin")).find("bytes instead of"), std::string::npos);
}

/// Memory follows the content of the files that a model names, not their names. The corners are never zero.
TEST_F(GltfTest, AFileWithManyNamesCountsOnce) {
  constexpr std::size_t kTriangles = 29'000, kNames = 200;
  std::vector<float> numbers;
  for (std::size_t i = 0; i < kTriangles; ++i)
    numbers.insert(numbers.end(), {1.1F, 1.1F, 1.1F, 2.1F, 1.1F, 1.1F, 1.1F, 2.1F, 1.1F});
  const std::string content = bytes_of(numbers);
  File file;
  file.root["meshes"][0]["primitives"] = json::array();
  const auto add_name = [&](std::size_t i) {
    const std::string name = std::to_string(i) + ".bin";
    if (i == 0) static_cast<void>(store(name, content));
    if (i != 0) fs::create_hard_link(folder_ / "0.bin", folder_ / name);
    file.root["buffers"][i] = {{"byteLength", content.size()}, {"uri", "./" + name}};
    file.root["bufferViews"][i] = {{"buffer", i}, {"byteLength", content.size()}};
    file.root["accessors"][i] = {{"bufferView", i}, {"componentType", 5126}, {"count", 3 * kTriangles}, {"type", "VEC3"}};
    file.root["meshes"][0]["primitives"][i] = {{"attributes", {{"POSITION", i}}}};
  };
  for (std::size_t i = 0; i < 3; ++i) add_name(i);
  EXPECT_EQ(read_gltf(store("a.gltf", file.root.dump())).soup.size(), 3 * kTriangles);
  for (std::size_t i = 3; i < kNames; ++i) add_name(i);
  EXPECT_TRUE(failure(store("a.gltf", file.root.dump()))
                  .starts_with("cannot import: the reader of glTF "));  // a sanitizer ends it otherwise
}

TEST_F(GltfTest, BuffersThatNoTriangleNeedsMayBeMissing) {
  File file = square();
  file.root["buffers"] = {json::object(), {{"byteLength", 100}, {"uri", "picture.bin"}}};
  file.root["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 100}});
  EXPECT_EQ(read_binary(file).soup.size(), 2U);
}

/// What an accessor says of its bytes, and the refusal.
TEST_F(GltfTest, AccessorsThatDoNotFitAreRefused) {
  const std::string positions = "node 0: mesh 0: primitive 0: POSITION: accessor 0: ";
  const auto with = [&](const char* list, const char* member, const json& value) {
    File file = square();
    file.root[list][0][member] = value;
    return failure(file);
  };
  const std::string huge = "18446744073709551615";
  EXPECT_EQ(with("accessors", "count", 5), positions + "5 elements, 12 bytes apart from byte 0 on, do not fit in 48 bytes");
  EXPECT_EQ(with("accessors", "count", UINT64_MAX),
            positions + huge + " elements, 12 bytes apart from byte 0 on, do not fit in 48 bytes");
  EXPECT_EQ(with("accessors", "byteOffset", UINT64_MAX),
            positions + "4 elements, 12 bytes apart from byte " + huge + " on, do not fit in 48 bytes");
  EXPECT_EQ(with("accessors", "count", -1), positions + "count: expected a whole number that is not negative");
  EXPECT_EQ(with("accessors", "count", 1.5), positions + "count: expected a whole number that is not negative");
  EXPECT_EQ(with("accessors", "componentType", 5130), positions + "componentType: 5130 is not one of glTF");
  EXPECT_EQ(with("accessors", "type", "VEC2"), positions + "type: 2 instead of 3 components");
  EXPECT_EQ(with("accessors", "type", "VEC9"), positions + "type: \"VEC9\" is not one of glTF");
  EXPECT_EQ(with("accessors", "bufferView", 9), positions + "bufferView 9: there are 2");
  EXPECT_EQ(with("bufferViews", "byteStride", 8), positions + "elements of 12 bytes are 8 bytes apart");
  EXPECT_EQ(with("bufferViews", "byteStride", UINT64_MAX),
            positions + "4 elements, " + huge + " bytes apart from byte 0 on, do not fit in 48 bytes");
  EXPECT_EQ(with("bufferViews", "byteLength", UINT64_MAX),
            positions + "bufferView 0: bytes 0 to 0 + " + huge + " of a buffer of 60");
  EXPECT_EQ(with("bufferViews", "byteOffset", 61), positions + "bufferView 0: bytes 61 to 61 + 48 of a buffer of 60");
  EXPECT_EQ(with("bufferViews", "buffer", 1), positions + "bufferView 0: buffer 1: there are 1");
}

TEST_F(GltfTest, ErrorsNameMeshPrimitiveAndVertex) {
  File file;
  file.set_positions(std::vector<float>{0, 0, 0, 1, 0, 0, NAN, 1, 0});
  file.root["meshes"][0]["name"] = "wall\x1b[31m";
  EXPECT_EQ(failure(file), "node 0: mesh 0 \"wall\\x1b[31m\": primitive 0: vertex 2: x is not finite");
  File other = square();
  other.root["accessors"][1]["componentType"] = 5122;
  EXPECT_EQ(failure(other), "node 0: mesh 0: primitive 0: indices: expected unsigned integers");
  other.root["accessors"][1]["componentType"] = 5123;
  other.root["accessors"][0]["count"] = 3;
  EXPECT_EQ(failure(other), "node 0: mesh 0: primitive 0: indices: corner 5 is vertex 3 of 3");
  other.primitive()["mode"] = 7;
  EXPECT_EQ(failure(other), "node 0: mesh 0: primitive 0: mode: 7 is not one of glTF");
  File empty = square();
  empty.root["scenes"][0]["nodes"] = json::array();
  EXPECT_EQ(failure(empty), "no polygons");
}

/// By the import library.
TEST_F(GltfTest, Version1IsReadAsBefore) {
  const std::string bytes = bytes_of(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0});
  json root = {{"asset", {{"version", "1.0"}}}, {"scene", "s"}};
  root["scenes"]["s"]["nodes"] = {"n"};
  root["nodes"]["n"]["meshes"] = {"m"};
  root["meshes"]["m"]["primitives"] = {{{"attributes", {{"POSITION", "a"}}}, {"material", "stuff"}}};
  root["materials"]["stuff"] = json::object();
  root["accessors"]["a"] = {{"bufferView", "v"}, {"byteOffset", 0}, {"byteStride", 12},
                            {"count", 3},        {"type", "VEC3"},  {"componentType", 5126}};
  root["bufferViews"]["v"] = {{"buffer", "b"}, {"byteOffset", 0}, {"byteLength", bytes.size()}};
  root["buffers"]["b"] = {{"byteLength", bytes.size()},
                          {"type", "arraybuffer"},
                          {"uri", "data:application/octet-stream;base64," + base64(bytes)}};
  for (const json& version : {json("1.0"), json(1.0)}) {
    root["asset"]["version"] = version;
    const Model model = read_gltf(store("a.gltf", root.dump()));
    EXPECT_EQ(corners(model.soup), (std::vector<dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
    EXPECT_EQ(model.notes.file, (Convention{1, {0, 1, 0}}));
  }
}

TEST_F(GltfTest, FilesThatAreNotGltfAreRefused) {
  const auto of = [&](const std::string& content) { return failure(store("a.glb", content)); };
  EXPECT_EQ(of("").substr(0, 25), "no JSON that can be read:");
  EXPECT_EQ(of("{\"asset\":").substr(0, 25), "no JSON that can be read:");
  EXPECT_EQ(of("[]"), "the JSON is not an object");
  EXPECT_EQ(of("{}"), "asset: missing");
  EXPECT_EQ(of(R"({"asset":{"version":"3.0"}})"), "asset: version: glTF 3.0 is not supported, but 2.0");
  EXPECT_EQ(of(R"({"asset":{"version":"2.0","minVersion":"2.1"}})"),
            "asset: minVersion: glTF 2.1 is not supported, but 2.0");
  const std::string sound = square().binary();
  EXPECT_EQ(of(sound.substr(0, 8)), "the file ends within its header");
  EXPECT_EQ(of(sound.substr(0, sound.size() - 1)).substr(0, 13), "the file has ");
  std::string bad = sound;
  bad[4] = 1;
  EXPECT_EQ(of(bad), "version 1 of the container is not supported, but 2");
  bad = sound;
  bad[15] = 127;
  EXPECT_EQ(of(bad).substr(0, 10), "a chunk of");
  EXPECT_NE(of(std::string(1 << 20U, '[')), "no error");
  bad = sound;
  for (std::size_t i = bad.rfind('}') + 1; bad[i] == ' '; ++i) bad[i] = '\0';
  EXPECT_EQ(of(bad), "no error");
}

// Compression.

/// A wavy surface of n * n vertices, in general position, and its triangles.
struct Surface {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;

  explicit Surface(std::uint32_t n) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> noise(0, 0.5F);
    for (std::uint32_t y = 0; y < n; ++y) {
      for (std::uint32_t x = 0; x < n; ++x) {
        for (const float c : {static_cast<float>(x), static_cast<float>(y), 0.F}) positions.push_back(c + noise(random));
        const std::uint32_t a = y * n + x;
        if (x + 1 < n && y + 1 < n) indices.insert(indices.end(), {a, a + 1, a + n, a + 1, a + n + 1, a + n});
      }
    }
  }
};

/// Each triangle from its least corner on, sorted.
std::vector<std::array<std::array<double, 3>, 3>> triangles(const PolygonSoup& soup) {
  std::vector<std::array<std::array<double, 3>, 3>> all;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    auto& triangle = all.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3& v = soup.vertices[soup.loop(p)[k]];
      triangle[k] = {v.x, v.y, v.z};
    }
    std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
  }
  std::ranges::sort(all);
  return all;
}

File plain_file(const Surface& surface) {
  File file;
  file.set_positions(surface.positions);
  file.set_indices(surface.indices);
  return file;
}

/// Puts compressed bytes in place of a view's, which are then in a buffer that is not there.
void compress_view(File& file, std::size_t view, const std::vector<unsigned char>& compressed, json extension) {
  const std::size_t replacement = file.add_view({compressed.begin(), compressed.end()});
  extension["buffer"] = 0;
  extension["byteOffset"] = file.root["bufferViews"][replacement]["byteOffset"];
  extension["byteLength"] = compressed.size();
  file.root["bufferViews"][view]["buffer"] = 1;
  file.root["bufferViews"][view]["byteOffset"] = 0;
  file.root["bufferViews"][view]["extensions"]["EXT_meshopt_compression"] = extension;
  file.root["buffers"] = {json::object(),
                          {{"byteLength", 1000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
}

std::vector<unsigned char> encoded_vertices(const void* vertices, std::size_t count, std::size_t size) {
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(count, size));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), vertices, count, size));
  return bytes;
}

TEST_F(GltfTest, MeshoptInAllModes) {
  const Surface surface(20);
  const std::size_t vertices = surface.positions.size() / 3, count = surface.indices.size();
  File file = plain_file(surface);
  const auto expected = triangles(read(file).soup);
  file.root["extensionsRequired"] = {"EXT_meshopt_compression"};
  compress_view(file, 0, encoded_vertices(surface.positions.data(), vertices, 12),
                {{"mode", "ATTRIBUTES"}, {"count", vertices}, {"byteStride", 12}});
  EXPECT_EQ(triangles(read_binary(file).soup), expected);
  meshopt_encodeIndexVersion(1);
  File as_triangles = file;
  std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(count, vertices));
  bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), surface.indices.data(), count));
  compress_view(as_triangles, 1, bytes, {{"mode", "TRIANGLES"}, {"count", count}, {"byteStride", 4}});
  EXPECT_EQ(triangles(read_binary(as_triangles).soup), expected);
  File as_indices = file;
  bytes.resize(meshopt_encodeIndexSequenceBound(count, vertices));
  bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), surface.indices.data(), count));
  compress_view(as_indices, 1, bytes, {{"mode", "INDICES"}, {"count", count}, {"byteStride", 4}});
  EXPECT_EQ(triangles(read_binary(as_indices).soup), expected);

  json& extension = as_indices.root["bufferViews"][1]["extensions"]["EXT_meshopt_compression"];
  const std::string place = "node 0: mesh 0: primitive 0: indices: accessor 1: bufferView 1: ";
  const auto refusal = [&] { return failure(store("a.glb", as_indices.binary())); };
  extension["count"] = bytes.size() + 1;
  EXPECT_EQ(refusal(), place + std::to_string(bytes.size() + 1) + " elements of 4 bytes cannot be in " +
                           std::to_string(bytes.size()) + " compressed bytes");
  extension["count"] = count;
  extension["mode"] = "TRIANGLES";
  EXPECT_EQ(refusal(), place + "EXT_meshopt_compression: the data is damaged");
  extension["mode"] = "CIRCLES";
  EXPECT_EQ(refusal(), place + "mode: \"CIRCLES\" is not supported");
  extension["mode"] = "INDICES";
  extension["filter"] = "EXPONENTIAL";
  EXPECT_EQ(refusal(), place + "filter: \"EXPONENTIAL\" is not supported for elements of 4 bytes");
}

/// The shortest that vertices can be: all alike.
TEST_F(GltfTest, MeshoptOfEqualVertices) {
  constexpr std::size_t kVertices = 30'000;
  File file;
  file.set_positions(std::vector<float>(3 * kVertices, 1));
  const std::vector<float> equal(3 * kVertices, 1);
  compress_view(file, 0, encoded_vertices(equal.data(), kVertices, 12),
                {{"mode", "ATTRIBUTES"}, {"count", kVertices}, {"byteStride", 12}});
  EXPECT_EQ(read_binary(file).soup.size(), kVertices / 3);
}

TEST_F(GltfTest, MeshoptFilters) {
  const Surface surface(8);
  const std::size_t vertices = surface.positions.size() / 3;
  File file = plain_file(surface);
  const auto expected = triangles(read(file).soup);
  std::vector<float> filtered(surface.positions.size());
  meshopt_encodeFilterExp(filtered.data(), vertices, 12, 24, surface.positions.data());
  compress_view(file, 0, encoded_vertices(filtered.data(), vertices, 12),
                {{"mode", "ATTRIBUTES"}, {"count", vertices}, {"byteStride", 12}, {"filter", "EXPONENTIAL"}});
  const auto read_back = triangles(read_binary(file).soup);
  ASSERT_EQ(read_back.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(read_back[i][k][c], expected[i][k][c], 1e-5);
    }
  }
  // Quarter turns about z of instances.
  File turned = square();
  const std::vector<float> quaternion = {0, 0, 0.70710678F, 0.70710678F};
  std::vector<std::int16_t> encoded(4);
  meshopt_encodeFilterQuat(encoded.data(), 1, 8, 16, quaternion.data());
  const std::size_t rotation = turned.add(std::vector<std::int16_t>(4), "VEC4", 4, true);
  compress_view(turned, turned.root["accessors"][rotation]["bufferView"].get<std::size_t>(),
                encoded_vertices(encoded.data(), 1, 8),
                {{"mode", "ATTRIBUTES"}, {"count", 1}, {"byteStride", 8}, {"filter", "QUATERNION"}});
  turned.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["ROTATION"] = rotation;
  EXPECT_LT(glm::length(corners(read_binary(turned).soup)[1] - dvec3(0, 1, 0)), 1e-3);
  // Octahedral: unit vectors, here as positions.
  File round;
  const std::vector<float> units = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  encoded.resize(12);
  meshopt_encodeFilterOct(encoded.data(), 3, 8, 16, units.data());
  const std::size_t view = round.add_view(std::string(24, '\0'));
  round.root["bufferViews"][view]["byteStride"] = 8;
  compress_view(round, view, encoded_vertices(encoded.data(), 3, 8),
                {{"mode", "ATTRIBUTES"}, {"count", 3}, {"byteStride", 8}, {"filter", "OCTAHEDRAL"}});
  round.root["accessors"].push_back(
      {{"bufferView", view}, {"componentType", 5122}, {"count", 3}, {"type", "VEC3"}, {"normalized", true}});
  round.primitive()["attributes"]["POSITION"] = 0;
  EXPECT_EQ(corners(read_binary(round).soup), (std::vector<dvec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
}

/// The surface by Draco's encoder, its positions in so many bits, or as they are.
std::string draco_bytes(const Surface& surface, int bits, std::uint32_t& position_id,
                        const std::vector<std::uint8_t>& colours) {
  draco::Mesh mesh;
  const auto points = static_cast<std::uint32_t>(surface.positions.size() / 3);
  mesh.set_num_points(points);
  draco::GeometryAttribute attribute;
  attribute.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
  const int id = mesh.AddAttribute(attribute, true, points);
  for (std::uint32_t i = 0; i < points; ++i)
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &surface.positions[std::size_t{3} * i]);
  if (!colours.empty()) {
    draco::GeometryAttribute colour;
    colour.Init(draco::GeometryAttribute::COLOR, nullptr, 3, draco::DT_UINT8, true, 3, 0);
    const int of_colours = mesh.AddAttribute(colour, true, points);
    for (std::uint32_t i = 0; i < points; ++i)
      mesh.attribute(of_colours)->SetAttributeValue(draco::AttributeValueIndex(i), &colours[std::size_t{3} * i]);
  }
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    mesh.AddFace({draco::PointIndex(surface.indices[i]), draco::PointIndex(surface.indices[i + 1]),
                  draco::PointIndex(surface.indices[i + 2])});
  }
  position_id = mesh.attribute(id)->unique_id();
  draco::Encoder encoder;
  if (bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
  if (bits == 0) encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

/// If there are colours, they are the attribute after the positions.
File draco_file(const Surface& surface, int bits, const std::vector<std::uint8_t>& colours = {}) {
  File file;
  std::uint32_t id = 0;
  const std::size_t view = file.add_view(draco_bytes(surface, bits, id, colours));
  file.root["accessors"] = {{{"componentType", 5126}, {"count", surface.positions.size() / 3}, {"type", "VEC3"}},
                            {{"componentType", 5125}, {"count", surface.indices.size()}, {"type", "SCALAR"}}};
  file.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  file.primitive() = {
      {"attributes", {{"POSITION", 0}}},
      {"indices", 1},
      {"extensions", {{"KHR_draco_mesh_compression", {{"bufferView", view}, {"attributes", {{"POSITION", id}}}}}}}};
  return file;
}

TEST_F(GltfTest, Draco) {
  const Surface surface(20);
  const auto expected = triangles(read(plain_file(surface)).soup);
  EXPECT_EQ(triangles(read(draco_file(surface, 0)).soup), expected);
  const Model quantised = read_binary(draco_file(surface, 16));
  ASSERT_EQ(quantised.soup.size(), expected.size());
  EXPECT_NEAR(area(quantised.soup), area(read(plain_file(surface)).soup), 0.05);
  const auto [low, high] = box(quantised.soup);
  const auto [low_before, high_before] = box(read(plain_file(surface)).soup);
  EXPECT_LT(glm::length(low - low_before) + glm::length(high - high_before), 1e-3);
  EXPECT_EQ(quantised.notes.unused_vertices, 0U);

  File file = draco_file(surface, 16);
  file.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 77;
  EXPECT_EQ(failure(file), "node 0: mesh 0: primitive 0: KHR_draco_mesh_compression: attribute 77: there is none");
  file = draco_file(surface, 16);
  file.bytes.resize(100);
  file.root["bufferViews"][0]["byteLength"] = 100;
  EXPECT_TRUE(failure(file).starts_with("node 0: mesh 0: primitive 0: KHR_draco_mesh_compression: the data is damaged: "));
}

TEST_F(GltfTest, DracoWithColours) {
  const Surface surface(2);
  const std::size_t vertices = surface.positions.size() / 3;
  std::vector<std::uint8_t> colours;
  for (std::size_t v = 0; v < vertices; ++v)
    colours.insert(colours.end(), {0, static_cast<std::uint8_t>(v == 0 ? 255 : 0), 255});
  File file = draco_file(surface, 0, colours);
  file.root["accessors"].push_back({{"componentType", 5121}, {"count", vertices}, {"type", "VEC3"}, {"normalized", true}});
  file.primitive()["attributes"]["COLOR_0"] = 2;
  json& compressed = file.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"];
  compressed["COLOR_0"] = compressed["POSITION"].get<int>() + 1;
  const Model model = read_coloured(file);
  ASSERT_EQ(model.colours.size(), model.soup.size());
  const auto at_first = std::ranges::count(surface.indices, 0U);
  EXPECT_EQ(std::ranges::count(model.colours, Rgb{0, 156, 255}), at_first);
  EXPECT_EQ(std::ranges::count(model.colours, Rgb{0, 0, 255}), static_cast<std::ptrdiff_t>(model.soup.size()) - at_first);
}

/// A morph target beside compressed positions is not compressed.
TEST_F(GltfTest, DracoWithAMorphTarget) {
  const Surface surface(4);
  File file = draco_file(surface, 0);
  file.primitive()["targets"] = {{{"POSITION", file.add(std::vector<float>(surface.positions.size(), 1), "VEC3", 3)}}};
  file.root["meshes"][0]["weights"] = {2};
  EXPECT_EQ(box(read(file).soup).first, box(read(plain_file(surface)).soup).first + dvec3(2));
}

/// gltfpack with its default options: quantised, reordered, its own way of joining meshes.
TEST_F(GltfTest, ARoundTripThroughGltfpackIsTheSame) {
  if (std::system("command -v gltfpack >/dev/null") != 0) GTEST_SKIP() << "gltfpack is not installed";
  const Surface surface(12);
  const auto before = triangles(read_gltf(store("before.glb", plain_file(surface).binary())).soup);
  for (const char* const options : {"", " -c", " -cc", " -noq", " -vp 16"}) {
    const fs::path packed = folder_ / "packed.glb";
    ASSERT_EQ(
        std::system(("gltfpack -i " + (folder_ / "before.glb").string() + " -o " + packed.string() + options + " >/dev/null")
                        .c_str()),
        0);
    const Model after = read_gltf(packed);
    ASSERT_EQ(after.soup.size(), before.size()) << options;
    // Steps are those of 14 bits over less than 13 units.
    double worst = 0;
    const auto all = triangles(after.soup);
    for (const auto& triangle : before) {
      double best = std::numeric_limits<double>::infinity();
      for (const auto& other : all) {
        for (std::size_t turn = 0; turn < 3; ++turn) {
          double farthest = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t c = 0; c < 3; ++c)
              farthest = std::max(farthest, std::fabs(triangle[k][c] - other[(k + turn) % 3][c]));
          }
          best = std::min(best, farthest);
        }
      }
      worst = std::max(worst, best);
    }
    EXPECT_LT(worst, 13.0 / 16384) << options;
  }
}

}  // namespace gltf_test
}  // namespace occlude::render
