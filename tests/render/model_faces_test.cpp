// SPDX-License-Identifier: MIT
// What readers make of faces that are not what a fan draws, of what lets light through, and of what is of no use.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "occlude/render/errors.h"
#include "occlude/render/model_io.h"

namespace occlude::render {
namespace model_faces_test {

namespace fs = std::filesystem;
using Marks = std::vector<std::uint8_t>;

class ModelFacesTest : public testing::Test {
 protected:
  ModelFacesTest() { fs::create_directories(folder_); }
  ~ModelFacesTest() override { fs::remove_all(folder_); }

  void store(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  [[nodiscard]] Model read(const std::string& name, const std::string& bytes, const ReadOptions& options = {}) const {
    store(name, bytes);
    return read_model(folder_ / name, options);
  }
  [[nodiscard]] std::string failure(const std::string& name, const std::string& bytes) const {
    try {
      static_cast<void>(read(name, bytes));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "no error";
  }

  fs::path folder_ = fs::temp_directory_path() / ("occlude_model_faces_" + std::to_string(getpid()));
};

/// The sum of the areas of all triangles of a face.
double area(const culler::PolygonSoup& soup, std::uint32_t face) {
  double sum = 0;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size() && soup.face(p) == face; ++i) {
      const glm::dvec3& a = soup.vertices[loop[0]];
      sum += glm::length(glm::cross(soup.vertices[loop[i]] - a, soup.vertices[loop[i + 1]] - a)) / 2;
    }
  }
  return sum;
}

/// A wall around a doorway as one face, with a floor before and after it.
constexpr const char* kDoorway =
    "v 0 -10 0\nv 0 -2 0\nv 0 -2 4\nv 0 2 4\nv 0 2 0\nv 0 10 0\nv 0 10 6\nv 0 -10 6\nv 9 -10 0\nv 9 10 0\n"
    "f 1 9 10 6\nf 1 2 3 4 5 6 7 8\nf 1 6 10 9\n";

void expect_doorway(const Model& model) {
  EXPECT_EQ(model.soup.face_count(), 3U);
  EXPECT_EQ(model.soup.faces, (std::vector<std::uint32_t>{0, 1, 1, 1, 1, 1, 1, 2}));
  EXPECT_EQ(area(model.soup, 1), 20 * 6 - 4 * 4);
  EXPECT_EQ(area(model.soup, 0), 180);
  EXPECT_EQ(model.notes.triangulated, 1U);
  EXPECT_EQ(text_of(model.notes), "");
}

TEST_F(ModelFacesTest, AConcaveFaceIsItsTriangles) {
  expect_doorway(read("a.obj", kDoorway));
  std::string vertices = "0 -10 0\n0 -2 0\n0 -2 4\n0 2 4\n0 2 0\n0 10 0\n0 10 6\n0 -10 6\n9 -10 0\n9 10 0\n";
  const std::string faces = "4 0 8 9 5\n8 0 1 2 3 4 5 6 7\n4 0 5 9 8\n";
  expect_doorway(read("a.ply",
                      "ply\nformat ascii 1.0\nelement vertex 10\nproperty int x\nproperty int y\nproperty int z\n"
                      "element face 3\nproperty list uchar int vertex_indices\nend_header\n" +
                          vertices + faces));
  expect_doorway(read("a.off", "OFF\n10 3 0\n" + vertices + faces));
}

TEST_F(ModelFacesTest, AWindowByAKeyholeStaysOpen) {
  const Model model = read("a.obj",
                           "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 3 3 0\nv 3 6 0\nv 6 6 0\nv 6 3 0\n"
                           "f 1 2 3 4 1 5 6 7 8 5\n");
  EXPECT_EQ(area(model.soup, 0), 81 - 9);
  EXPECT_EQ(model.soup.face_count(), 1U);
}

TEST_F(ModelFacesTest, AFaceThatCrossesItselfHidesNothing) {
  const std::string tie = "v 0 0 0\nv 4 4 0\nv 4 0 0\nv 0 5 0\nf 1 2 3 4\nf 1 2 3\n";
  for (const bool is_opaque_all : {false, true}) {
    const Model model = read("a.obj", tie, {.is_opaque_all = is_opaque_all});
    EXPECT_EQ(model.soup.see_through, (Marks{1, 0}));
    EXPECT_EQ(model.notes.crossing, 1U);
    EXPECT_EQ(text_of(model.notes), "1 face that crosses itself is drawn as a fan and hides nothing");
  }
}

/// A triangle each of no material, opaque ones and see-through ones.
TEST_F(ModelFacesTest, ObjMaterialsThatLetLightThrough) {
  store("a b.mtl",
        "newmtl wall\nd 1\nTr 0\nnewmtl glass\nKd 1 1 1\nd 0.4\nnewmtl smoke\r\n Tr 0.5\r\nnewmtl leaves\nmap_d leaf.png\n"
        "newmtl halo\nd -halo 0.9\n");
  const std::string text =
      "mtllib a b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl wall\nf 1 2 3\nusemtl glass\nf 1 2 3\nusemtl smoke\nf 1 2 "
      "3\n"
      "usemtl leaves\nf 1 2 3\nusemtl halo\nf 1 2 3\nusemtl none\nf 1 2 3\n";
  const Model model = read("a.obj", text);
  EXPECT_EQ(model.soup.see_through, (Marks{0, 0, 1, 1, 1, 1, 0}));
  EXPECT_EQ(text_of(model.notes), "");
  EXPECT_TRUE(read("a.obj", text, {.is_opaque_all = true}).soup.see_through.empty());
  fs::remove(folder_ / "a b.mtl");
  const Model missing = read("a.obj", text);
  EXPECT_TRUE(missing.soup.see_through.empty());
  EXPECT_NE(text_of(missing.notes).find("materials are taken for opaque: "), std::string::npos);
  EXPECT_NE(text_of(missing.notes).find("b.mtl: cannot read: No such file or directory"), std::string::npos);
}

/// COLLADA by the import library: two triangles, the second of glass.
TEST_F(ModelFacesTest, ImportedMaterialsThatLetLightThrough) {
  const auto scene = [](const std::string& transparency) {
    const auto effect = [](const std::string& id, const std::string& more) {
      return "<effect id=\"" + id +
             "\"><profile_COMMON><technique sid=\"t\"><lambert><diffuse><color>1 1 1 1</color></diffuse>" + more +
             "</lambert></technique></profile_COMMON></effect>";
    };
    const auto triangle = [](const std::string& material) {
      return "<triangles material=\"" + material +
             "\" count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p></triangles>";
    };
    return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset>
<library_effects>)" +
           effect("ew", "") +
           effect("eg", "<transparent opaque=\"A_ONE\"><color>1 1 1 1</color></transparent><transparency><float>" +
                            transparency + "</float></transparency>") +
           R"(</library_effects><library_materials><material id="w"><instance_effect url="#ew"/></material>
<material id="g"><instance_effect url="#eg"/></material></library_materials>
<library_geometries><geometry id="g0"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 1 1 0</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>)" +
           triangle("wall") + triangle("glass") +
           R"(</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g0"><bind_material><technique_common>
<instance_material symbol="wall" target="#w"/><instance_material symbol="glass" target="#g"/>
</technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
  };
  EXPECT_EQ(read("a.dae", scene("0.3")).soup.see_through, (Marks{0, 1}));
  EXPECT_TRUE(read("a.dae", scene("1")).soup.see_through.empty());
  EXPECT_TRUE(read("a.dae", scene("0.3"), {.is_opaque_all = true}).soup.see_through.empty());
}

std::string ply(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n" + header +
         "end_header\n" + body;
}

TEST_F(ModelFacesTest, OnlyWhatFacesUseMustBeSound) {
  const std::string header = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string vertices = "0 0 0\nnan 0 0\n1 0 0\n0 1 0\n";
  const Model model = read("a.ply", ply(header, vertices + "3 0 2 3\n"));
  EXPECT_EQ(model.soup.vertices, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(model.soup.indices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(model.notes.unused_vertices, 1U);
  EXPECT_EQ(failure("a.ply", ply(header, vertices + "3 0 2 1\n")), "a.ply:11: vertex 1: x is not finite");
  EXPECT_EQ(read("a.obj", "v nan 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n").notes.unused_vertices, 1U);
}

TEST_F(ModelFacesTest, FacesWithTooFewCornersAreLeftOut) {
  const Model model = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\nf\nf 1 2 2\nl 1 2\np 1\n");
  EXPECT_EQ(model.soup.face_count(), 2U);
  EXPECT_EQ(model.notes.few_corners, 2U);
  EXPECT_EQ(model.notes.without_area, 1U);
  EXPECT_EQ(model.notes.points_and_lines, 2U);
  EXPECT_EQ(text_of(model.notes), "2 faces with fewer than three corners are left out");
  EXPECT_EQ(failure("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n"), "a.obj: no polygons");
}

/// 1e-300 is a double, 1e-400 is not; 10^400 * 1e-9 is too large, whatever its exponent.
TEST_F(ModelFacesTest, RoundingNoiseIsZero) {
  const std::string face = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* const noise : {"1e-31", "-1e-300", "1e-400", "-0.001E-99999", "1e-99999999999999999999999"}) {
    const Model model = read("a.obj", std::string("v 0 0 ") + noise + "\n" + face);
    EXPECT_EQ(model.soup.vertices[0], glm::dvec3(0, 0, 0)) << noise;
  }
  EXPECT_EQ(text_of(read("a.obj", "v 1e-31 0 1e-31\n" + face).notes),
            "2 coordinates nearer to 0 than 2^-100 are taken as 0");
  for (const std::string& large : {std::string("1e31"), std::string("1e400"), '1' + std::string(400, '0') + "e-9"}) {
    EXPECT_EQ(failure("a.obj", "v 0 0 " + large + "\n" + face),
              "a.obj:1: z is out of range (neither 0 nor of magnitude 2^-100 to 2^100)");
  }
}

TEST_F(ModelFacesTest, ObjVerticesMayHaveWeightsOrColours) {
  const Model model = read("a.obj", "v 2 0 0 2\nv 0 1 0 0.5 0.5 0.5\nv 0 0 1\nf 1 2 3\n");
  EXPECT_EQ(model.soup.vertices, (std::vector<glm::dvec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(failure("a.obj", "v 2 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n"), "a.obj:1: x is not finite");
}

TEST_F(ModelFacesTest, PlyStripsAreTriangles) {
  const Model model = read("a.ply", ply("element tristrips 1\nproperty list int int vertex_indices\n",
                                        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 0 1 3 2 -1 3 2 2 1\n"));
  EXPECT_EQ(model.soup.indices, (std::vector<std::uint32_t>{0, 1, 3, 1, 3, 2}));
}

}  // namespace model_faces_test
}  // namespace occlude::render
