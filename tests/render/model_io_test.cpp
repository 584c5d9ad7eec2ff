// SPDX-License-Identifier: MIT
#include "occlude/render/model_io.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/input_limits.h"

namespace occlude::render {
namespace model_io_test {

namespace fs = std::filesystem;
using culler::PolygonSoup;
using culler::SoupView;
using glm::dvec3;

/// The bytes of `value` in the order of a big-endian or little-endian file.
template <class T>
std::string bytes_of(T value, std::endian order) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  std::string text(raw.begin(), raw.end());
  if (order != std::endian::native) text.assign(text.rbegin(), text.rend());
  return text;
}

void save(const fs::path& file, SoupView soup, const std::string& comment) {
  OutputFile output(file);
  write_ply(output, soup, comment);
  output.commit();
}

class ModelIoTest : public testing::Test {
 protected:
  ModelIoTest() { fs::create_directories(folder_); }
  ~ModelIoTest() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path store(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  [[nodiscard]] PolygonSoup read(const std::string& name, const std::string& bytes) const {
    return read_model(store(name, bytes)).soup;
  }
  [[nodiscard]] std::string failure(const fs::path& file) const {
    try {
      static_cast<void>(read_model(file));
    } catch (const InputError& error) {
      std::string what = error.what();
      EXPECT_EQ(what.rfind(file.string(), 0), 0U) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      return what.substr(std::min(what.size(), file.string().size()));
    }
    return "no error";
  }
  /// The message, without the name of the file, for a file of these bytes.
  [[nodiscard]] std::string failure(const std::string& name, const std::string& bytes) const {
    return failure(store(name, bytes));
  }

  static PolygonSoup sample() {
    PolygonSoup soup;
    for (const dvec3& v : {dvec3(0.1, -1.0 / 3, 4e6 + 1e-9), dvec3(1, 0, 0), dvec3(1, 1, 0), dvec3(0, 1, 0x1p-100)})
      static_cast<void>(soup.add_vertex(v));
    soup.add_polygon(std::array<std::uint32_t, 4>{0, 1, 2, 3});
    soup.add_polygon(std::array<std::uint32_t, 3>{2, 2, 3});  // repeated index: legal
    return soup;
  }
  static void expect_equal(const PolygonSoup& a, const PolygonSoup& b) {
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.indices, b.indices);
    EXPECT_EQ(a.first, b.first);
  }
  /// A text PLY with one triangle, `vertices` and `faces` as given.
  static std::string text_ply(const std::string& vertices, const std::string& faces = "3 0 1 2\n") {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
           "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
           vertices + faces;
  }
  static constexpr const char* kCorners = "0 0 0\n1 0 0\n0 1 0\n";

  static std::string binary_ply(std::endian order) {
    std::string out =
        std::string("ply\nformat binary_") + (order == std::endian::big ? "big" : "little") +
        "_endian 1.0\ncomment x\nelement vertex 3\nproperty uchar red\nproperty float z\nproperty double x\n"
        "property list ushort short extra\nproperty short y\nelement edge 1\nproperty int from\n"
        "element face 1\nproperty list uint8 uint32 other\nproperty list int ushort vertex_index\nend_header\n";
    for (const int i : {1, 2, 3}) {
      out += '\x7f' + bytes_of(0.5F * static_cast<float>(i), order) + bytes_of(0.1 * i, order) +
             bytes_of(std::uint16_t{2}, order) + bytes_of(std::int16_t{9}, order) + bytes_of(std::int16_t{9}, order) +
             bytes_of(static_cast<std::int16_t>(-i), order);
    }
    out += bytes_of(std::int32_t{7}, order);
    out += '\1' + bytes_of(std::uint32_t{5}, order) + bytes_of(std::int32_t{3}, order);
    for (const std::uint16_t index : {std::uint16_t{2}, std::uint16_t{0}, std::uint16_t{1}}) out += bytes_of(index, order);
    return out;
  }

  fs::path folder_ = fs::temp_directory_path() / ("occlude_model_io_" + std::to_string(getpid()));
};

TEST_F(ModelIoTest, PlyRoundTripKeepsEveryBit) {
  const PolygonSoup soup = sample();
  save(folder_ / "a.ply", soup, "first\nsecond");
  expect_equal(read_model(folder_ / "a.ply").soup, soup);
}

TEST_F(ModelIoTest, WrittenPlyHasCommentsAndFixedBytes) {
  save(folder_ / "a.ply", sample(), "first\nsecond");
  std::ostringstream bytes;
  bytes << std::ifstream(folder_ / "a.ply", std::ios::binary).rdbuf();
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment first\ncomment second\nelement vertex 4\nproperty double x\n"
      "property double y\nproperty double z\nelement face 2\nproperty list uchar uint vertex_indices\nend_header\n";
  EXPECT_EQ(bytes.str().substr(0, header.size()), header);
  EXPECT_EQ(bytes.str().size(), header.size() + 4 * 24 + (1 + 4 * 4) + (1 + 3 * 4));
}

TEST_F(ModelIoTest, PolygonsOfMoreThan255VerticesSurvive) {
  PolygonSoup soup;
  std::vector<std::uint32_t> loop;
  for (int i = 0; i < 300; ++i) loop.push_back(soup.add_vertex({i, i * i, 0}));
  soup.add_polygon(loop);
  save(folder_ / "a.ply", soup, "");
  expect_equal(read_model(folder_ / "a.ply").soup, soup);
  std::string obj, face = "f";
  for (int i = 0; i < 300; ++i) {
    obj += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  expect_equal(read("a.obj", obj + face + "\n"), soup);
}

TEST_F(ModelIoTest, BinaryPlyOfEitherEndianAnyOrderAndWithExtras) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const PolygonSoup soup = read("a.ply", binary_ply(order));
    EXPECT_EQ(soup.vertices, (std::vector<dvec3>{{0.1, -1, 0.5}, {0.2, -2, 1}, {0.1 * 3, -3, 1.5}}));
    EXPECT_EQ(soup.indices, (std::vector<std::uint32_t>{2, 0, 1}));
  }
}

TEST_F(ModelIoTest, TextPlyKeepsDoublesAndTakesAnyBlanks) {
  const PolygonSoup soup = read("A.PLY", text_ply("0.30000000000000004 +1 -2.5e-3\r\n\n 1\t0 0   0 1 0\n", "3 0 1 2"));
  EXPECT_EQ(soup.vertices[0], dvec3(0.1 + 0.2, 1, -2.5e-3));
  EXPECT_EQ(soup.size(), 1U);
}

TEST_F(ModelIoTest, FacesMayComeBeforeVertices) {
  EXPECT_EQ(read("a.ply",
                 "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex 3\n"
                 "property float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n")
                .size(),
            1U);
}

TEST_F(ModelIoTest, TruncationAtEveryByteIsAnError) {
  for (const std::string& whole : {binary_ply(std::endian::little), binary_ply(std::endian::big)}) {
    for (std::size_t length = 0; length < whole.size(); ++length) {
      EXPECT_NE(failure("a.ply", whole.substr(0, length)), "no error") << length;
    }
  }
  const std::string text = text_ply(kCorners);
  // The last byte is a line end, which may be missing.
  for (std::size_t length = 0; length + 1 < text.size(); ++length) {
    EXPECT_NE(failure("a.ply", text.substr(0, length)), "no error") << length;
  }
}

TEST_F(ModelIoTest, AnyByteChangedNeverCrashes) {
  const std::string whole = binary_ply(std::endian::little);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char value : {'\0', '\x7f', '\xff', '9', '\n'}) {
      std::string changed = whole;
      changed[at] = value;
      static_cast<void>(failure("a.ply", changed));
    }
  }
}

TEST_F(ModelIoTest, FilesThatAreNoPly) {
  EXPECT_EQ(failure("a.ply", ""), ": the file is empty");
  EXPECT_EQ(failure("a.ply", "Dear diary,\nnothing happened today.\n"), ": not a PLY file");
  EXPECT_EQ(failure("a.ply", "plywood"), ": not a PLY file");
  EXPECT_EQ(failure("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"), ":4: the header ends without end_header");
}

TEST_F(ModelIoTest, FilesThatCannotBeRead) {
  for (const char* const name : {"none.ply", "none.obj", "none.stl", "none"}) {
    EXPECT_EQ(failure(folder_ / name), ": cannot read: No such file or directory") << name;
    fs::create_directory(folder_ / "folder");
    fs::rename(folder_ / "folder", folder_ / name);
    EXPECT_EQ(failure(folder_ / name), ": cannot read: it is a directory") << name;
  }
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const fs::path file = store("a.ply", text_ply(kCorners));
  fs::permissions(file, fs::perms::none);
  EXPECT_EQ(failure(file), ": cannot read: Permission denied");
}

TEST_F(ModelIoTest, HeaderFaultsNameTheLine) {
  EXPECT_EQ(failure("a.ply", "ply\nformat ebcdic 1.0\nend_header\n").rfind(":2: unknown format", 0), 0U);
  EXPECT_EQ(failure("a.ply", "ply\nformat ascii 2.0\nend_header\n").rfind(":2: expected \"format", 0), 0U);
  const std::string start = "ply\nformat ascii 1.0\n";
  EXPECT_EQ(failure("a.ply", start + "element vertex many\n"),
            ":3: expected the number of elements, an integer of at most 64 bits");
  EXPECT_EQ(failure("a.ply", start + "element vertex -3\n"),
            ":3: expected the number of elements, an integer of at most 64 bits");
  EXPECT_EQ(failure("a.ply", start + "property float x\n"), ":3: a property before the first element");
  EXPECT_EQ(failure("a.ply", start + "element vertex 3\nproperty quad x\n").rfind(":4: unknown type", 0), 0U);
  EXPECT_EQ(failure("a.ply", start + "element vertex 3\nproperty float x\nproperty int x\n"),
            ":5: the property was declared before");
  EXPECT_EQ(failure("a.ply", start + "element vertex 3\nelement vertex 3\n"), ":4: the element was declared before");
  EXPECT_EQ(failure("a.ply", start + "element face 3\nproperty list float int vertex_indices\n"),
            ":4: the length of a list must be of an integer type");
  EXPECT_EQ(failure("a.ply", start + "elephant\n"), ":3: expected element, property, comment or end_header");
  EXPECT_EQ(failure("a.ply", start + "end_header\n"), ": no element vertex");
}

TEST_F(ModelIoTest, DataFaultsNameThePlace) {
  EXPECT_EQ(failure("a.ply", text_ply("0 0 0\n1 zero 0\n0 1 0\n")), ":11: expected a number");
  EXPECT_EQ(failure("a.ply", text_ply("0 0 0\n1 nan 0\n0 1 0\n")), ":11: vertex 1: y is not finite");
  EXPECT_EQ(failure("a.ply", text_ply("0 0 0\n1 0 -inf\n0 1 0\n")), ":11: vertex 1: z is not finite");
  const std::string range = " is out of range (neither 0 nor of magnitude 2^-100 to 2^100)";
  EXPECT_EQ(failure("a.ply", text_ply("1e31 0 0\n1 0 0\n0 1 0\n")), ":10: vertex 0: x" + range);
  EXPECT_EQ(failure("a.ply", text_ply("1e999 0 0\n1 0 0\n0 1 0\n")), ":10: vertex 0: x" + range);
  EXPECT_EQ(failure("a.ply", text_ply(kCorners, "3 0 1 3\n")), ":13: face 0: vertex index 3 is out of range (3 vertices)");
  EXPECT_EQ(failure("a.ply", text_ply(kCorners, "3 0 1 -1\n")), ":13: face 0: vertex index -1 is out of range (3 vertices)");
  EXPECT_EQ(failure("a.ply", text_ply(kCorners, "-3 0 1 2\n")), ":13: face 0: the list has a negative length");
  EXPECT_EQ(failure("a.ply", text_ply(kCorners, "3 0 1 2.5\n")), ":13: expected an integer of at most 64 bits");
  EXPECT_EQ(failure("a.ply", text_ply(kCorners, "3 0 1 9223372036854775808\n")),
            ":13: expected an integer of at most 64 bits");
  EXPECT_EQ(failure("a.ply", text_ply(kCorners, "4 0 1 2\n")), ":14: face 0: the file ends here");
  std::string binary = binary_ply(std::endian::little);
  binary.back() = '\3';  // the high byte of the last index
  EXPECT_EQ(failure("a.ply", binary), ": face 0: vertex index 769 is out of range (3 vertices)");
}

TEST_F(ModelIoTest, HugeCountsAreRefusedBeforeAnythingIsAllocated) {
  const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  const std::string rest =
      "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uint int "
      "vertex_indices\nend_header\n";
  for (const char* const count : {"1000000000000", "18446744073709551615"}) {
    const std::string message = failure("a.ply", head + count + rest + std::string(100, '\0'));
    EXPECT_NE(message.find("but the file is too short"), std::string::npos) << message;
  }
  EXPECT_EQ(failure("a.ply", head + "18446744073709551616" + rest),
            ":3: expected the number of elements, an integer of at most 64 bits");
  // A face that declares 2^32 - 1 indices.
  EXPECT_EQ(failure("a.ply", head + "1" + rest + std::string(12, '\0') + std::string(4, '\xff') + std::string(8, '\0')),
            ": face 0: the file ends here");
  // Elements without properties take no bytes, however many.
  EXPECT_EQ(failure("a.ply",
                    "ply\nformat ascii 1.0\nelement void 18446744073709551615\nelement vertex 0\nproperty int x\n"
                    "property int y\nproperty int z\nelement face 0\nproperty list int int vertex_indices\nend_header\n"),
            ": no polygons");
}

TEST_F(ModelIoTest, APlyIsItsElementsAndNothingElse) {
  EXPECT_EQ(failure("a.ply", text_ply("0 +-5 0\n1 0 0\n0 1 0\n")), ":10: expected a number");
  EXPECT_EQ(failure("a.ply", text_ply(kCorners) + " \r\n\n"), "no error");
  EXPECT_EQ(failure("a.ply", text_ply(kCorners) + "0 1 0\n"), ":14: 6 bytes follow the last element");
  EXPECT_EQ(failure("a.ply", binary_ply(std::endian::little) + "\n"), ": 1 bytes follow the last element");
}

TEST_F(ModelIoTest, PlyWithoutPolygons) {
  EXPECT_EQ(failure("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\n"
                    "end_header\n1 2 3\n"),
            ": no polygons");
  EXPECT_EQ(failure("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int z\nend_header\n1 2\n"),
            ": element vertex has no number y");
}

TEST_F(ModelIoTest, ObjKeepsQuadsAndDoubles) {
  const PolygonSoup soup =
      read("a.obj",
           "# a comment\nmtllib none.mtl\no thing\nv 0.1 0.30000000000000004 4000000.000000001\nv 1 0 0 # c\n"
           "vt 0 0\nvn 0 0 1\nv 1 1 0 1.0\nv 0 1 0\r\nusemtl none\ng a b\nf 1/1/1 2/1/1 \\\n 3//1 4\n"
           "f -4 -3 -2\nl 1 2\np 1\nf 1 2 5 # comes later\nv 2 2 2\n");
  ASSERT_EQ(soup.size(), 3U);
  EXPECT_EQ(soup.vertices[0], dvec3(0.1, 0.1 + 0.2, 4000000.000000001));
  EXPECT_EQ(soup.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 0, 1, 2, 0, 1, 4}));
  EXPECT_EQ(soup.first, (std::vector<std::uint32_t>{0, 4, 7, 10}));
}

TEST_F(ModelIoTest, ObjLosesNoVertexToMarksAndLineEnds) {
  const std::string text = "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";
  const PolygonSoup soup = read("a.obj", text);
  expect_equal(read("a.obj", "\xef\xbb\xbf" + text), soup);
  for (const char* const end : {"\r", "\r\n"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    expect_equal(read("a.obj", other), soup);
    EXPECT_EQ(failure("a.obj", other + "v" + end + "v 1 2"), ":5: expected a number");
  }
  std::string wide;
  for (const char c : text) wide += std::string{c, '\0'};
  EXPECT_EQ(failure("a.obj", wide), ":1: zero byte: this is not a text file");
}

TEST_F(ModelIoTest, ObjFaultsNameTheLine) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(failure("a.obj", ""), ": no polygons");
  EXPECT_EQ(failure("a.obj", corners), ": no polygons");
  EXPECT_EQ(failure("a.obj", "v 1 2\n"), ":1: expected a number");
  EXPECT_EQ(failure("a.obj", "\nv 1 x 2\n"), ":2: expected a number");
  EXPECT_EQ(failure("a.obj", corners + "v 1 nan 2\nf 1 2 4\n"), ":4: y is not finite");
  EXPECT_EQ(failure("a.obj", corners + "f 1 2 4\n"), ":4: vertex index 4 is out of range (3 vertices)");
  EXPECT_EQ(failure("a.obj", corners + "f 1 2 99999999999\n"), ":4: vertex index 99999999999 is out of range (3 vertices)");
  EXPECT_EQ(failure("a.obj", corners + "f 1 2 0\n"), ":4: vertex index 0 is out of range (3 vertices so far)");
  EXPECT_EQ(failure("a.obj", corners + "f 1 2 -4\n"), ":4: vertex index -4 is out of range (3 vertices so far)");
  EXPECT_EQ(failure("a.obj", corners + "f 1 two 3\n"), ":4: expected a vertex index, an integer of at most 64 bits");
  for (const char* const index : {"9223372036854775808", "-9223372036854775809"}) {
    EXPECT_EQ(failure("a.obj", corners + "f 1 2 " + index + "\n"),
              ":4: expected a vertex index, an integer of at most 64 bits");
  }
  EXPECT_EQ(failure("a.obj", corners + "f 1 2\n"), ": no polygons");
  EXPECT_EQ(failure("a.obj", corners + "f\n"), ": no polygons");
}

TEST_F(ModelIoTest, StlThroughAssimp) {
  const PolygonSoup soup =
      read("a.stl",
           "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1.5 0\nendloop\n"
           "endfacet\nendsolid a\n");
  ASSERT_EQ(soup.size(), 1U);
  EXPECT_EQ(soup.vertices[soup.loop(0)[2]], dvec3(0, 1.5, 0));
}

/// A COLLADA scene with one quadrilateral, placed twice.
std::string collada(const std::string& third_index) {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 1 1 0 0 1 0</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4</vcount><p>0 1 )" +
         third_index + R"( 3</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">
<node><translate>10 0 0</translate><node><translate>0 0 5</translate><instance_geometry url="#g"/></node></node>
<node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST_F(ModelIoTest, ColladaKeepsQuadsTransformsAndUp) {
  const PolygonSoup soup = read("a.dae", collada("2"));
  ASSERT_EQ(soup.size(), 2U);
  ASSERT_EQ(soup.loop(0).size(), 4U);
  EXPECT_EQ(soup.vertices[soup.loop(0)[2]], dvec3(11, 1, 5));
  EXPECT_EQ(soup.vertices[soup.loop(1)[2]], dvec3(1, 1, 0));
}

TEST_F(ModelIoTest, WhatAssimpRefusesIsOneLine) {
  EXPECT_EQ(failure("a.dae", "no XML").rfind(": cannot import: ", 0), 0U);
  EXPECT_EQ(failure("a.dae", collada("9")).rfind(": ", 0), 0U);
  EXPECT_EQ(failure("a.xyz", "1 2 3").rfind(": cannot import: ", 0), 0U);
  EXPECT_EQ(failure("a", "").rfind(": cannot import: ", 0), 0U);
  EXPECT_NE(
      failure("a.stl",
              "solid a\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
              "endsolid a\n"),
      "no error");
}

TEST_F(ModelIoTest, WhatAssimpCrashesOnIsRefused) {
  // Assimp 5.2.5 reads forty indices where the file has none.
  EXPECT_EQ(failure("a.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n40\n0 1 0\n4 0 1 2 3\n")
                .rfind(": cannot import: the import library ", 0),
            0U);
}

TEST_F(ModelIoTest, WhatIsTooLargeIsNotRead) {
  for (const char* const name : {"a.ply", "a.obj", "a.stl"}) {
    const fs::path file = store(name, "");
    fs::resize_file(file, kMostBytes + 1);  // a sparse file takes no space
    EXPECT_EQ(failure(file), ": cannot read: it is larger than 4096 MiB") << name;
  }
}

/// A file that is a hole, or blank, is not worth the memory to hold it.
TEST_F(ModelIoTest, WhatHasNoContentIsNotImported) {
  const std::string refused = ": cannot import: the import library ";
  for (const char* const head : {"", "solid"}) {
    const fs::path file = store("a.stl", head);
    fs::resize_file(file, 300U << 20U);  // takes no space
    EXPECT_EQ(failure(file).substr(0, refused.size()), refused) << head;
  }
  const std::string mixed = std::string(3 << 20U, ' ') + "a\t\n\v\f\r b" + std::string(9, '\0') + "\x01\xff";
  EXPECT_EQ(content_of(store("mixed", mixed)), 4U);
}

TEST_F(ModelIoTest, VerticesThatNoPolygonHasAreNotImported) {
  const PolygonSoup soup = read("a.off", "OFF\n4 1 0\n0 0 0\n9 9 9\n1 0 0\n1 1 0\n3 0 2 3\n");
  EXPECT_EQ(soup.vertices, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
}

TEST_F(ModelIoTest, WritingNowhereNamesTheFile) { EXPECT_THROW(save(folder_ / "none" / "a.ply", sample(), ""), InputError); }

}  // namespace model_io_test
}  // namespace occlude::render
