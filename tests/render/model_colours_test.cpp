// SPDX-License-Identifier: MIT
// The colours that files have, and of which polygons.
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "colours.h"
#include "occlude/render/errors.h"
#include "occlude/render/model_io.h"

namespace occlude::render {
namespace model_colours_test {

namespace fs = std::filesystem;
using Colours = std::vector<Rgb>;

class ModelColoursTest : public testing::Test {
 protected:
  ModelColoursTest() { fs::create_directories(folder_); }
  ~ModelColoursTest() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path store(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  [[nodiscard]] Colours read(const std::string& name, const std::string& bytes) const {
    return read_model(store(name, bytes), {.with_colours = true}).colours;
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("occlude_colours_" + std::to_string(getpid()));
};

TEST(Colours, AreCutOffAndRounded) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(rgb_of({-1, 0.5, 7}), (Rgb{0, 128, 255}));
  EXPECT_EQ(rgb_of({kNone, 0.001, 0.999}), (Rgb{0, 0, 255}));
  EXPECT_EQ(rgb_of_light({0, 0.5, 1}), (Rgb{0, 188, 255}));
  EXPECT_EQ(rgb_of_light({0.002, 0.2140411, kNone}), (Rgb{7, 127, 0}));
  EXPECT_EQ(mean_colour(std::vector<std::uint32_t>{0, 1, 1}, {{30, 0, 255}, {60, 1, 255}}), (Rgb{50, 1, 255}));
}

/// A white picture, one bit a pixel.
std::string white_png(std::uint32_t width, std::uint32_t height) {
  const auto number = [](std::uint32_t n) {
    return std::string{static_cast<char>(n >> 24U), static_cast<char>(n >> 16U), static_cast<char>(n >> 8U),
                       static_cast<char>(n)};
  };
  const auto chunk = [&](const std::string& type, const std::string& data) {
    const std::string all = type + data;
    const uLong check = crc32(0, reinterpret_cast<const Bytef*>(all.data()), static_cast<uInt>(all.size()));
    return number(static_cast<std::uint32_t>(data.size())) + all + number(static_cast<std::uint32_t>(check));
  };
  const std::string row = '\0' + std::string((width + 7) / 8, '\xff');
  std::string rows;
  for (std::uint32_t y = 0; y < height; ++y) rows += row;
  uLongf size = compressBound(rows.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  packed.resize(size);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", number(width) + number(height) + std::string("\1\0\0\0\0", 5)) +
         chunk("IDAT", packed) + chunk("IEND", "");
}

TEST(Colours, OfPicturesThatAreNotTooLarge) {
  EXPECT_EQ(mean_light_of_png(white_png(100, 50)), glm::dvec3(1));
  EXPECT_EQ(mean_light_of_png(white_png(8192, 8193)), std::nullopt);
  EXPECT_EQ(mean_light_of_png(""), std::nullopt);
}

TEST_F(ModelColoursTest, ObjHasThoseOfMaterials) {
  static_cast<void>(store("a.mtl", "newmtl red\nKd 1 0 0.5\nnewmtl grey\nd 0.5\nKd 0.2\nnewmtl odd\nKd spectral a.rfl\n"));
  // A material that is not there, and a concave face, which has two pieces.
  const fs::path file = store("a.obj",
                              "mtllib a.mtl\nv 0 0 0\nv 4 0 0\nv 2 1 0\nv 2 4 0\nf 1 2 4\nusemtl red\nf 1 2\nf 4 3 1 2\n"
                              "usemtl none\nf 1 2 4\nusemtl grey\nf 1 2 4\nusemtl odd\nf 1 2 4\n");
  const Model model = read_model(file, {.with_colours = true});
  EXPECT_EQ(model.notes.triangulated, 1U);
  EXPECT_EQ(model.colours, (Colours{kWhite, {255, 0, 128}, {255, 0, 128}, kWhite, {51, 51, 51}, kWhite}));
  EXPECT_EQ(model.soup.see_through, (std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0}));
  EXPECT_TRUE(read_model(file).colours.empty()) << "not asked for";
  const Conversion turned{.to_metres = true, .to_z_up = true, .file = {2, {0, 1, 0}}};
  EXPECT_EQ(read_model(file, {.conversion = turned, .with_colours = true}).colours, model.colours);
}

TEST_F(ModelColoursTest, WhatIsAllWhiteHasNone) {
  static_cast<void>(store("a.mtl", "newmtl white\nKd 1 1 1\n"));
  EXPECT_TRUE(read("a.obj", "mtllib a.mtl\nv 0 0 0\nv 4 0 0\nv 2 1 0\nusemtl white\nf 1 2 3\n").empty());
}

/// Four vertices and three faces, the second of fewer than three corners.
std::string ply(const std::string& of_vertices, const std::string& vertex, const std::string& of_faces,
                const std::string& face, bool has_faces_first = false) {
  std::string head[] = {"element vertex 4\nproperty float x\nproperty float y\nproperty float z\n" + of_vertices,
                        "element face 3\n" + of_faces + "property list uchar int vertex_indices\n"};
  std::string data[] = {"", ""};
  const char* const places[] = {"0 0 0", "4 0 0", "4 4 0", "0 4 0"};
  for (int v = 0; v < 4; ++v) data[0] += places[v] + (v == 0 ? vertex : of_vertices.empty() ? "" : " 0 0 0") + "\n";
  for (const char* const loop : {"4 0 1 2 3", "2 0 1", "3 1 2 3"}) data[1] += face + loop + "\n";
  if (has_faces_first) std::swap(head[0], head[1]), std::swap(data[0], data[1]);
  return "ply\nformat ascii 1.0\n" + head[0] + head[1] + "end_header\n" + data[0] + data[1];
}

std::string channels(const std::string& type) {
  return "property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\n";
}

TEST_F(ModelColoursTest, PlyHasThoseOfVerticesOrFaces) {
  const Colours of_vertices{{50, 25, 1}, {0, 0, 0}}, of_faces{{200, 100, 5}, {200, 100, 5}};
  for (const bool has_faces_first : {false, true}) {
    EXPECT_EQ(read("a.ply", ply(channels("uchar"), " 200 100 5", "", "", has_faces_first)), of_vertices);
    EXPECT_EQ(read("a.ply", ply("", "", channels("uchar"), "200 100 5 ", has_faces_first)), of_faces);
    EXPECT_EQ(read("a.ply", ply(channels("uchar"), " 200 100 5", channels("uchar"), "7 7 7 ", has_faces_first)),
              of_vertices);
  }
  EXPECT_EQ(read("a.ply", ply("", "", channels("ushort"), "51400 25700 1285 ")), of_faces);
  EXPECT_EQ(read("a.ply", ply("", "", channels("float"), "0.784 0.392 0.0196 ")), of_faces);
  EXPECT_EQ(read("a.ply", ply("", "", channels("int"), "200 100 5 ")), of_faces);
  EXPECT_EQ(read("a.ply", ply("", "", channels("float"), "7 -1 nan ")), (Colours{{255, 0, 0}, {255, 0, 0}}));
  EXPECT_TRUE(read("a.ply", ply("", "", "", "")).empty());
  EXPECT_TRUE(read("a.ply", ply("", "", "property uchar red\nproperty uchar green\n", "1 2 ")).empty()) << "no blue";
  const std::string listed = "property list uchar uchar red\nproperty uchar green\nproperty uchar blue\n";
  EXPECT_TRUE(read("a.ply", ply("", "", listed, "1 2 3 4 ")).empty()) << "red is a list";
  const fs::path file = store("a.ply", ply(channels("uchar"), " 200 100 5", "", ""));
  EXPECT_TRUE(read_model(file).colours.empty()) << "not asked for";
  EXPECT_THROW(static_cast<void>(read("a.ply", ply("", "", channels("uchar"), "200 x 5 "))), InputError);
}

TEST_F(ModelColoursTest, StripsOfPlyHaveThoseOfTheirVertices) {
  EXPECT_EQ(read("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
                     channels("uchar") +
                     "element tristrips 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 30 0 0\n4 0 0 0 0 0\n"
                     "0 4 0 0 60 0\n4 4 0 0 0 90\n6 0 1 2 -1 3 2\n"),
            (Colours{{10, 20, 0}}));
}

/// Two triangles, each of a material.
TEST_F(ModelColoursTest, ColladaHasThoseOfMaterials) {
  const auto effect = [](const char* name, const char* colour) {
    return "<effect id=\"" + std::string(name) + "_e\"><profile_COMMON><technique sid=\"t\"><phong><diffuse><color>" +
           colour + "</color></diffuse></phong></technique></profile_COMMON></effect>";
  };
  const auto material = [](const std::string& name) {
    return "<material id=\"" + name + "\"><instance_effect url=\"#" + name + "_e\"/></material>";
  };
  const auto bound = [](const std::string& name) {
    return "<instance_material symbol=\"" + name + "\" target=\"#" + name + "\"/>";
  };
  const auto triangle = [](const std::string& name, const char* corners) {
    return "<triangles count=\"1\" material=\"" + name + "\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" +
           corners + "</p></triangles>";
  };
  const std::string file =
      "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset/>"
      "<library_effects>" +
      effect("red", "1 0 0 1") + effect("dark", "0.2 0.4 0.6 1") + "</library_effects><library_materials>" +
      material("red") + material("dark") +
      "</library_materials><library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"pa\" "
      "count=\"12\">"
      "0 0 0 4 0 0 0 4 0 4 4 0</float_array><technique_common><accessor source=\"#pa\" count=\"4\" stride=\"3\">"
      "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
      "</technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>" +
      triangle("red", "0 1 2") + triangle("dark", "1 3 2") +
      "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\"><node id=\"n\">"
      "<instance_geometry url=\"#g\"><bind_material><technique_common>" +
      bound("red") + bound("dark") +
      "</technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes><scene>"
      "<instance_visual_scene url=\"#s\"/></scene></COLLADA>";
  EXPECT_EQ(read("a.dae", file), (Colours{{255, 0, 0}, {51, 102, 153}}));
  EXPECT_TRUE(read_model(folder_ / "a.dae").colours.empty()) << "not asked for";
}

}  // namespace model_colours_test
}  // namespace occlude::render
