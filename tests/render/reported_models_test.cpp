// SPDX-License-Identifier: MIT
// Models that people reported as refused for nothing, or as read wrongly; and what all readers agree on about such.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "folder_test.h"
#include "occlude/render/model_io.h"

namespace occlude::render {
namespace reported_models_test {

using glm::dvec3;

class ReportedModelsTest : public FolderTest {
 protected:
  [[nodiscard]] Model read(const std::string& name, const std::string& bytes) const { return read_model(save(name, bytes)); }
  [[nodiscard]] std::string failure(const std::string& name, const std::string& bytes) const {
    return failure_after(folder_ / name, [&] { return read(name, bytes); });
  }
};

std::pair<dvec3, dvec3> box(const Model& model) {
  dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const dvec3& v : model.soup.vertices) low = glm::min(low, v), high = glm::max(high, v);
  return {low, high};
}

constexpr const char* kPlyHead =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n";

/// Floats as a text PLY of the vertices and a face of the last three.
std::string ply_of(const std::string& vertices) {
  return kPlyHead + ("element face 1\nproperty list uchar int vertex_indices\nend_header\n" + vertices) + "3 2 3 4\n";
}

std::string obj_of(const std::string& vertices) {
  std::string text;
  for (std::size_t at = 0; at < vertices.size(); at = vertices.find('\n', at) + 1)
    text += "v " + vertices.substr(at, vertices.find('\n', at) - at) + "\n";
  return text + "f 3 4 5\n";
}

std::string off_of(const std::string& vertices) { return "OFF\n5 1 0\n" + vertices + "3 2 3 4\n"; }

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  unsigned bits = 0;
  int count = 0;
  for (const unsigned char byte : bytes) {
    bits = bits << 8U | byte;
    for (count += 8; count >= 6; count -= 6) text += kDigits[bits >> static_cast<unsigned>(count - 6) & 63U];
  }
  if (count > 0) text += kDigits[bits << static_cast<unsigned>(6 - count) & 63U];
  return text;
}

std::string gltf_of(const std::string& vertices) {
  std::string bytes;
  for (const char *at = vertices.data(), *const end = at + vertices.size(); at != end;) {
    char* next = nullptr;
    const float number = std::strtof(at, &next);
    if (next == at) break;
    const auto raw = std::bit_cast<std::array<char, 4>>(number);
    bytes.append(raw.data(), raw.size());
    at = next;
  }
  const std::size_t size = bytes.size();
  bytes += std::string("\2\3\4\0", 4);
  return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"},
                 {"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteLength":)" +
         std::to_string(size) + R"(},{"buffer":0,"byteOffset":)" + std::to_string(size) + R"(,"byteLength":3}],
    "buffers":[{"byteLength":)" +
         std::to_string(size + 3) + R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) + R"("}]})";
}

/// The same in each of the formats that can have vertices without a face.
std::vector<std::pair<const char*, std::string>> in_all_formats(const std::string& vertices) {
  return {
      {"a.obj", obj_of(vertices)}, {"a.ply", ply_of(vertices)}, {"a.off", off_of(vertices)}, {"a.gltf", gltf_of(vertices)}};
}

TEST_F(ReportedModelsTest, VerticesThatNoFaceUsesMayBeAnything) {
  for (const auto& [name, bytes] : in_all_formats("nan nan nan\n1e38 -inf 1e-44\n0 0 0\n2 0 0\n2 3 0\n")) {
    if (name == std::string("a.off")) continue;  // the library knows no nan
    const Model model = read(name, bytes);
    EXPECT_EQ(model.soup.size(), 1U) << name;
    EXPECT_EQ(model.soup.vertices, (std::vector<dvec3>{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}})) << name;
    EXPECT_EQ(model.soup.indices, (std::vector<std::uint32_t>{0, 1, 2})) << name;
    EXPECT_EQ(model.notes.unused_vertices, 2U) << name;
    if (name == std::string("a.gltf")) continue;  // what is not used is not looked at
    EXPECT_EQ(text_of(model.notes), "2 vertices that no face uses are left out: their numbers are not legal") << name;
  }
  for (const auto& [name, bytes] : in_all_formats("7 8 9\n10 11 12\n0 0 0\n2 0 0\n2 3 0\n"))
    EXPECT_EQ(read(name, bytes).notes.unused_vertices, 2U) << name;
}

TEST_F(ReportedModelsTest, WhatAFaceUsesMustBeSound) {
  for (const auto& [name, bytes] : in_all_formats("0 0 0\n1 0 0\n0 0 0\n2 nan 0\n2 3 0\n")) {
    if (name == std::string("a.off")) continue;
    EXPECT_TRUE(failure(name, bytes).ends_with(" is not finite")) << name;
  }
}

/// Rounding noise: what is below 2^-100 is 0, beside numbers of which that is no digit.
TEST_F(ReportedModelsTest, NumbersThatAreNearlyZeroAreZero) {
  for (const auto& [name, bytes] : in_all_formats("0 0 0\n1 0 0\n0 0 1e-40\n2 0 3.75e-33\n2 3 -1.5e-10\n")) {
    const Model model = read(name, bytes);
    EXPECT_EQ(model.soup.vertices[0], dvec3(0)) << name;
    EXPECT_EQ(model.soup.vertices[1], dvec3(2, 0, 0)) << name;
    EXPECT_EQ(text_of(model.notes), "2 coordinates nearer to 0 than 2^-100 are taken as 0") << name;
  }
  EXPECT_EQ(
      read("a.obj", "v 0 0 0\nv 2 0 3.749399456654644e-33\nv 2 3 1.07797e-46\nv 0 3 -1.9684875951497816e-10\nf 1 2 3 4\n")
          .soup.size(),
      1U);
}

TEST_F(ReportedModelsTest, NumbersOfNearlyNoSizeAreZeroAndHugeOnesAreNot) {
  for (const char* const tiny :
       {"1e-400", "-1e-400", "0.000001E-400", "1e-99999999999999999999", "0.1e-310", "1000e-400", "12.5e-500"}) {
    const Model model = read("a.obj", std::string("v 0 0 0\nv 2 0 ") + tiny + "\nv 2 3 0\nf 1 2 3\n");
    EXPECT_EQ(box(model).second, dvec3(2, 3, 0)) << tiny;
    EXPECT_EQ(model.notes.tiny_numbers, 1U) << tiny;
  }
  for (const char* const huge : {"1e400", "-1e400", "1e99999999999999999999", "0.00001e1000", "123456e304"}) {
    EXPECT_EQ(failure("a.obj", std::string("v 0 0 0\nv 2 0 ") + huge + "\nv 2 3 0\nf 1 2 3\n"),
              ":2: z is out of range (neither 0 nor of magnitude 2^-100 to 2^100)")
        << huge;
  }
}

/// A model of which nothing would be left.
TEST_F(ReportedModelsTest, AModelThatIsTinyItselfIsRefused) {
  EXPECT_EQ(failure("a.obj", "v 0 0 0\nv 1e-20 0 1e-33\nv 0 1e-20 0\nf 1 2 3\n"),
            ": coordinates are nearer to 0 than 2^-100, and none reaches 2^-47: give them in another unit");
  EXPECT_EQ(read("a.obj", "v 0 0 0\nv 1e-20 0 1e-28\nv 0 1e-20 0\nf 1 2 3\n").soup.size(), 1U);
  for (const char* const large : {"1e-14 0 0", "0 -1e-14 0", "0 0 1e-14"})
    EXPECT_EQ(read("a.obj", std::string("v 0 0 0\nv 1e-20 0 1e-33\nv ") + large + "\nf 1 2 3\n").soup.size(), 1U) << large;
}

TEST_F(ReportedModelsTest, ATurnedCube) {
  // As a program writes it that turns by sines and cosines.
  const Model model = read("a.obj",
                           "v 0 0 0\nv 0 0 -1\nv 6.123233995736766e-17 -1 6.123233995736766e-17\nv 1 0 0\n"
                           "v 1 -1 -3.749399456654644e-33\nf 1 2 3\nf 1 4 5 3\n");
  EXPECT_EQ(model.soup.face_count(), 2U);
  EXPECT_EQ(model.notes.tiny_numbers, 1U);
}

TEST_F(ReportedModelsTest, FacesOfTwoCornersAreLeftOut) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const Model obj = read("a.obj", corners + "f 1 2\nf 1 2 3 4\nf 3\nl 1 2\np 1\nf 1 3 4\n");
  EXPECT_EQ(obj.soup.size(), 2U);
  EXPECT_EQ(text_of(obj.notes), "2 faces with fewer than three corners are left out");
  const Model ply =
      read("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement "
           "face 3\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 1\n4 0 1 2 "
           "3\n0\n");
  EXPECT_EQ(ply.soup.size(), 1U);
  EXPECT_EQ(text_of(ply.notes), "2 faces with fewer than three corners are left out");
  const Model off = read("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 1\n4 0 1 2 3\n");
  EXPECT_EQ(off.soup.size(), 1U);
  EXPECT_EQ(text_of(off.notes), "1 face with fewer than three corners is left out");
}

TEST_F(ReportedModelsTest, StripsOfTriangles) {
  const std::string head = kPlyHead + std::string("element tristrips 1\nproperty list int int vertex_indices\nend_header\n");
  const std::string vertices = "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n";
  const Model model = read("a.ply", head + vertices + "9 0 1 2 3 -1 2 3 3 4\n");
  ASSERT_EQ(model.soup.size(), 2U);
  const auto loop = [&](std::size_t p) {
    std::vector<std::pair<double, double>> corners;
    for (const std::uint32_t v : model.soup.loop(p))
      corners.emplace_back(model.soup.vertices[v].x, model.soup.vertices[v].y);
    return corners;
  };
  EXPECT_EQ(loop(0), (std::vector<std::pair<double, double>>{{0, 0}, {0, 1}, {1, 0}}));
  // Both triangles of the second strip have an edge of length 0.
  EXPECT_EQ(read("a.ply", head + vertices + "5 0 1 2 3 4\n").soup.size(), 3U);
  EXPECT_EQ(failure("a.ply", head + vertices + "3 0 1 5\n"),
            ":15: tristrips 0: vertex index 5 is out of range (5 vertices)");
}

TEST_F(ReportedModelsTest, VerticesWithAWeight) {
  const std::string faces = "f 1 2 3\n";
  const Model model = read("a.obj", "v\t20 -20\t \t-20 2\t\nv 20 20 -20 2\nv 5 5 5 0.5\n" + faces);
  EXPECT_EQ(model.soup.vertices, (std::vector<dvec3>{{10, -10, -10}, {10, 10, -10}, {10, 10, 10}}));
  // Six numbers are a place and a colour.
  EXPECT_EQ(read("a.obj", "v 1 0 0 .5 .5 .5\nv 0 1 0 1 1 1\nv 0 0 1 0 0 0\n" + faces).soup.vertices,
            (std::vector<dvec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(failure("a.obj", "v 1 0 0 0\nv 0 1 0\nv 0 0 1\n" + faces), ":1: x is not finite");
}

/// A cube 5 along x, with blanks before a colour's first number.
TEST_F(ReportedModelsTest, BlanksInCollada) {
  const std::string blank = " \t\r\n ";
  const Model model =
      read("a.dae", R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit name="u" meter="1"/><up_axis>)" +
                        blank +
                        R"(Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse><color>)" +
                        blank +
                        R"(0.5 0.5 0.5 1 </color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">)" +
                        blank +
                        R"(0 0 0 0 0 1 0 1 0</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
                        blank +
                        R"(0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><matrix>)" +
                        blank +
                        R"(1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
  EXPECT_EQ(box(model), std::pair(dvec3(5, 0, 0), dvec3(5, 1, 1)));
}

}  // namespace reported_models_test
}  // namespace occlude::render
