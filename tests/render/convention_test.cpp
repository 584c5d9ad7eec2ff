// SPDX-License-Identifier: MIT
#include "occlude/render/convention.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "occlude/render/errors.h"
#include "occlude/render/model_io.h"
#include "occlude/render/store.h"

namespace occlude::render {
namespace convention_test {

namespace fs = std::filesystem;
using glm::dvec3;

TEST(ConventionTest, UnitsByNameAndByNumber) {
  for (const auto& [text, metres, words] :
       {std::tuple("m", 1.0, "metres"), std::tuple("km", 1000.0, "kilometres"), std::tuple("cm", 0.01, "centimetres"),
        std::tuple("mm", 0.001, "millimetres"), std::tuple("in", 0.0254, "inches"), std::tuple("ft", 0.3048, "feet"),
        std::tuple("0.0254", 0.0254, "inches"), std::tuple("1e-3", 0.001, "millimetres"), std::tuple("2.5", 2.5, "2.5 m")}) {
    EXPECT_EQ(parse_unit(text), metres) << text;
    EXPECT_EQ(unit_in_words(metres), words) << text;
  }
  for (const char* const text : {"", "metre", "0", "-1", "nan", "inf", "1e13", "1e-13", "1e999", "1e-999", "1m"})
    EXPECT_EQ(parse_unit(text), std::nullopt) << text;
  EXPECT_EQ(unit_in_words(0), "");
}

TEST(ConventionTest, AxesByName) {
  for (const auto& [text, up] :
       {std::pair("x", dvec3(1, 0, 0)), std::pair("-x", dvec3(-1, 0, 0)), std::pair("+y", dvec3(0, 1, 0)),
        std::pair("-y", dvec3(0, -1, 0)), std::pair("z", dvec3(0, 0, 1)), std::pair("-z", dvec3(0, 0, -1))}) {
    EXPECT_EQ(parse_up(text), up) << text;
    EXPECT_EQ(parse_up(up_in_words(up)), up) << text;
  }
  for (const char* const text : {"", "-", "w", "xy", "--z", "+-z", "Z"}) EXPECT_EQ(parse_up(text), std::nullopt) << text;
  EXPECT_EQ(up_in_words(dvec3(0)), "");
}

/// A turn keeps what is right-handed so, and loses no digit.
TEST(ConventionTest, EachAxisIsTurnedToZ) {
  for (const char* const text : {"x", "-x", "y", "-y", "z", "-z"}) {
    const dvec3 up = *parse_up(text);
    EXPECT_EQ(turned_to_z_up(up, up), dvec3(0, 0, 1)) << text;
    std::array<dvec3, 3> axes = {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)};
    for (dvec3& axis : axes) axis = turned_to_z_up(axis, up);
    EXPECT_EQ(glm::cross(axes[0], axes[1]), axes[2]) << text;
    const dvec3 turned = turned_to_z_up({0.1, 1.0 / 3, -7e22}, up);
    EXPECT_EQ(glm::abs(turned.x) + glm::abs(turned.y) + glm::abs(turned.z), 7e22 + 1.0 / 3 + 0.1) << text;
    EXPECT_FALSE(std::signbit(turned_to_z_up(dvec3(0), up).y)) << text;
  }
  EXPECT_EQ(turned_to_z_up({1, 2, 3}, {0, 1, 0}), dvec3(1, -3, 2));
  EXPECT_EQ(turned_to_z_up({1, 2, 3}, {1, 0, 0}), dvec3(-2, -3, 1));
}

/// A block of 10 x 20 x 30.
std::string collada_block(const std::string& unit_and_axis) {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)" +
         unit_and_axis + R"(</asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="24">
0 0 0 0 0 30 0 20 0 0 20 30 10 0 0 10 0 30 10 20 0 10 20 30</float_array><technique_common>
<accessor source="#pa" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><polygons count="6">
<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 3 2</p><p>4 6 7 5</p><p>0 4 5 1</p><p>2 3 7 6</p><p>0 2 6 4</p>
<p>1 5 7 3</p></polygons></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// One triangle, as FBX says its axes and unit.
std::string fbx_triangle(int up, int sign, const std::string& centimetres) {
  const auto number = [](int value) { return std::to_string(value); };
  return "; FBX 7.4.0 project file\nFBXHeaderExtension: {\n FBXHeaderVersion: 1003\n FBXVersion: 7400\n}\nGlobalSettings: "
         "{\n"
         " Version: 1000\n Properties70: {\n  P: \"UpAxis\", \"int\", \"Integer\", \"\"," +
         number(up) + "\n  P: \"UpAxisSign\", \"int\", \"Integer\", \"\"," + number(sign) +
         "\n  P: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," + centimetres +
         "\n }\n}\nObjects: {\n Geometry: 10, \"Geometry::g\", \"Mesh\" {\n  Vertices: *9 {\n   a: 0,0,0,10,0,0,0,20,30\n  "
         "}\n"
         "  PolygonVertexIndex: *3 {\n   a: 0,1,-3\n  }\n }\n Model: 11, \"Model::m\", \"Mesh\" {\n  Version: 232\n }\n}\n"
         "Connections: {\n C: \"OO\",11,0\n C: \"OO\",10,11\n}\n";
}

class ConventionOfFilesTest : public testing::Test {
 protected:
  ConventionOfFilesTest() { fs::create_directories(folder_); }
  ~ConventionOfFilesTest() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path store(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  [[nodiscard]] static std::string failure(const fs::path& file, const Conversion& conversion) {
    try {
      static_cast<void>(read_as(file, conversion));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
    return "no error";
  }
  [[nodiscard]] static Model read_as(const fs::path& file, const Conversion& conversion) {
    return read_model(file, {.conversion = conversion});
  }
  /// The largest coordinates; the smallest are 0.
  static dvec3 size(const Model& model) {
    dvec3 low(0), high(0);
    for (const dvec3& v : model.soup.vertices) low = glm::min(low, v), high = glm::max(high, v);
    EXPECT_TRUE(low == dvec3(0) || model.notes.convention.up != model.notes.file.up);
    return high - low;
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("occlude_convention_" + std::to_string(getpid()));
};

/// The numbers of the file are kept; what they mean is known.
TEST_F(ConventionOfFilesTest, Collada) {
  for (const auto& [said, convention] :
       {std::pair(R"(<unit name="u" meter="0.01"/><up_axis>Y_UP</up_axis>)", Convention{0.01, {0, 1, 0}}),
        std::pair(R"(<unit name="u" meter="0.0254"/><up_axis>Z_UP</up_axis>)", Convention{0.0254, {0, 0, 1}}),
        std::pair(R"(<unit name="u" meter="2"/><up_axis>X_UP</up_axis>)", Convention{2, {1, 0, 0}}),
        std::pair("", Convention{1, {0, 1, 0}}), std::pair(R"(<unit name="u" meter="0"/>)", Convention{0, {0, 0, 0}})}) {
    const Model model = read_model(store("a.dae", collada_block(said)));
    EXPECT_EQ(size(model), dvec3(10, 20, 30)) << said;
    EXPECT_EQ(model.notes.file, convention) << said;
    EXPECT_EQ(model.notes.convention, convention) << said;
  }
}

TEST_F(ConventionOfFilesTest, Fbx) {
  for (const auto& [up, sign, centimetres, convention] :
       {std::tuple(1, 1, "1", Convention{0.01, {0, 1, 0}}), std::tuple(2, 1, "100", Convention{1, {0, 0, 1}}),
        std::tuple(0, -1, "2.54", Convention{0.0254, {-1, 0, 0}}), std::tuple(7, 1, "-1", Convention{})}) {
    const Model model = read_model(store("a.fbx", fbx_triangle(up, sign, centimetres)));
    EXPECT_EQ(size(model), dvec3(10, 20, 30)) << up;
    EXPECT_EQ(model.notes.file, convention) << up;
  }
}

TEST_F(ConventionOfFilesTest, FormatsThatSayIt) {
  const Model block = read_model(fs::path(OCCLUDE_MODELS) / "block.3ds");
  EXPECT_EQ(size(block), dvec3(10, 20, 30));
  EXPECT_EQ(block.notes.file, (Convention{0, {0, 0, 1}}));
  EXPECT_EQ(read_model(fs::path(OCCLUDE_MODELS) / "mirrored.glb").notes.file, (Convention{1, {0, 1, 0}}));
  EXPECT_EQ(read_model(store("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).notes.file, Convention());
}

TEST_F(ConventionOfFilesTest, AreConvertedAsTheySay) {
  const fs::path file = store("a.dae", collada_block(R"(<unit name="u" meter="0.01"/><up_axis>Y_UP</up_axis>)"));
  const Model turned = read_as(file, {.to_z_up = true});
  EXPECT_EQ(size(turned), dvec3(10, 30, 20));
  EXPECT_EQ(turned.notes.convention, (Convention{0.01, {0, 0, 1}}));
  const Model scaled = read_as(file, {.to_metres = true});
  EXPECT_EQ(size(scaled), dvec3(10 * 0.01, 20 * 0.01, 30 * 0.01));
  EXPECT_EQ(scaled.notes.convention, (Convention{1, {0, 1, 0}}));
}

/// A product with the unit, rounded once: not a division, and no more than one.
TEST_F(ConventionOfFilesTest, ProductsWithTheUnitAreRoundedOnce) {
  std::string text;
  std::vector<dvec3> expected;
  for (int i = 1; i <= 300; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(i + 1) + ".1 0.7\n";
    expected.emplace_back(i * 0.3048, std::stod(std::to_string(i + 1) + ".1") * 0.3048, 0.7 * 0.3048);
  }
  for (int i = 1; i <= 300; i += 3)
    text += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  EXPECT_EQ(read_as(store("a.obj", text), {.to_metres = true, .file = {0.3048, dvec3(0)}}).soup.vertices, expected);
}

/// The outer placement is applied last.
TEST_F(ConventionOfFilesTest, PlacementsInPlacements) {
  std::string nested = collada_block("<up_axis>Z_UP</up_axis>");
  nested.insert(nested.find("<instance_geometry"), "<scale>2 4 8</scale><node><translate>1 1 1</translate>");
  nested.insert(nested.find("</node>"), "</node>");
  const Model model = read_model(store("a.dae", nested));
  dvec3 low(1e9), high(0);
  for (const dvec3& v : model.soup.vertices) low = glm::min(low, v), high = glm::max(high, v);
  EXPECT_EQ(low, dvec3(2, 4, 8));
  EXPECT_EQ(high, dvec3(22, 84, 248));
}

TEST_F(ConventionOfFilesTest, TheUserKnowsBetter) {
  const fs::path file = store("a.dae", collada_block(R"(<unit name="u" meter="0.01"/><up_axis>Y_UP</up_axis>)"));
  const Model model = read_as(file, {true, true, {0.5, {0, 0, 1}}});
  EXPECT_EQ(size(model), dvec3(5, 10, 15));
  EXPECT_EQ(model.notes.file, (Convention{0.5, {0, 0, 1}}));
}

TEST_F(ConventionOfFilesTest, WhatCannotBeConvertedIsRefused) {
  const fs::path silent = store("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1e30 0\nf 1 2 3\n");
  EXPECT_EQ(failure(silent, {.to_z_up = true}), ": does not say which axis is up: name it, --up y");
  EXPECT_EQ(failure(silent, {.to_metres = true}), ": does not say what its unit is: name it, --unit cm");
  EXPECT_EQ(failure(silent, {.to_metres = true, .file = {1000, dvec3(0)}}),
            ": in metres, y is out of range (neither 0 nor of magnitude 2^-100 to 2^100)");
  const fs::path small = store("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1e-30 0\nf 1 2 3\n");
  EXPECT_EQ(read_as(small, {.to_metres = true, .file = {0.01, dvec3(0)}}).notes.tiny_numbers, 1U);
  EXPECT_EQ(failure(small, {.to_metres = true, .file = {1e-12, dvec3(0)}}), "no error");
  EXPECT_EQ(
      failure(store("c.obj", "v 0 0 0\nv 1e-6 0 0\nv 0 1e-20 0\nf 1 2 3\n"), {.to_metres = true, .file = {1e-11, dvec3(0)}}),
      ": coordinates are nearer to 0 than 2^-100, and none reaches 2^-47: give them in another unit");
  const culler::Culler culler(read_model(small).soup, {});
  OutputFile out(folder_ / "a.store");
  write_store(out, culler);
  out.commit();
  EXPECT_EQ(failure(folder_ / "a.store", {.to_z_up = true}), ": does not say which axis is up: name it, --up y");
  EXPECT_EQ(read_as(folder_ / "a.store", {.to_z_up = true, .file = {0, {0, 1, 0}}}).soup.vertices[2], dvec3(0, 0, 1e-30));
}

/// What single precision costs is said: a part at map coordinates.
TEST_F(ConventionOfFilesTest, TheRoundingOfTheLibraryIsKnown) {
  std::string far = collada_block("<up_axis>Z_UP</up_axis>");
  far.insert(far.find("<instance_geometry"), "<translate>308456.37 6215873.91 42.5</translate>");
  const Model model = read_model(store("a.dae", far));
  double worst = 0;
  for (const dvec3& v : model.soup.vertices) {
    const dvec3 from = v - dvec3(308456.37, 6215873.91, 42.5);
    for (const auto& [c, whole] : {std::pair(from.x, 10.0), std::pair(from.y, 20.0), std::pair(from.z, 30.0)})
      worst = std::max(worst, std::min(std::fabs(c), std::fabs(c - whole)));
  }
  EXPECT_GT(worst, 0.01);
  EXPECT_LE(worst, model.notes.rounding);
  EXPECT_LE(model.notes.rounding, 1);
  ASSERT_EQ(model.notes.warnings.size(), 1U);
  EXPECT_EQ(model.notes.warnings[0], "the import library has single precision: coordinates may be off by 0.7");
  EXPECT_TRUE(read_model(store("a.dae", collada_block(""))).notes.warnings.empty());
  EXPECT_EQ(read_model(fs::path(OCCLUDE_MODELS) / "far_joint.glb").notes.rounding, 0);
}

}  // namespace convention_test
}  // namespace occlude::render
