// SPDX-License-Identifier: MIT
// Cameras of models, and the animations that move them.
#include "occlude/render/model_cameras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "folder_test.h"

namespace occlude::render {
namespace model_cameras_test {

using glm::dvec3;
using nlohmann::json;

/// Of a model that is not converted.
ModelNotes notes_of(const Convention& convention) {
  ModelNotes notes;
  notes.file = notes.convention = convention;
  return notes;
}

class ModelCameras : public FolderTest {
 protected:
  [[nodiscard]] CameraPath read(const std::string& file, const std::string& camera) const {
    return read_model_camera(folder_ / file, camera, notes_of({1, {0, 1, 0}}));
  }
  /// The message after the folder.
  [[nodiscard]] std::string failure(const std::string& file, const std::string& camera) const {
    return failure_after(folder_ / "", [&] { return read(file, camera); });
  }
};

/// A scene of a node "arm" at (0, 0, 5) with a camera "eye" a unit above it, and another camera.
json scene() {
  return json::parse(R"({"asset": {"version": "2.0"},
    "nodes": [{"name": "arm", "translation": [0, 0, 5], "children": [1]},
              {"name": "eye", "translation": [0, 1, 0], "camera": 0},
              {"camera": 1, "matrix": [0, 0, -1, 0,  0, 1, 0, 0,  1, 0, 0, 0,  7, 8, 9, 1]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.5}},
                {"name": "flat", "type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2, "znear": 0, "zfar": 64}}]})");
}

/// Adds floats as an accessor, and returns its index.
std::size_t add_floats(json& root, std::string& bytes, const std::vector<float>& numbers, unsigned width) {
  root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", 4 * numbers.size()}});
  root["accessors"].push_back({{"bufferView", root["bufferViews"].size() - 1},
                               {"componentType", 5126},
                               {"count", numbers.size() / width},
                               {"type", width == 1   ? "SCALAR"
                                        : width == 3 ? "VEC3"
                                                     : "VEC4"}});
  bytes.append(reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size());
  return root["accessors"].size() - 1;
}

struct Move {
  std::size_t node;
  const char* path;
  const char* manner;
  std::vector<float> times, values;
};

/// The scene with an animation, and the bytes of its buffer.
std::pair<json, std::string> moved(const std::vector<Move>& moves) {
  json root = scene(), animation = {{"channels", json::array()}, {"samplers", json::array()}};
  std::string bytes;
  for (const Move& move : moves) {
    const std::size_t input = add_floats(root, bytes, move.times, 1),
                      output = add_floats(root, bytes, move.values, move.path == std::string("rotation") ? 4 : 3);
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", move.node}, {"path", move.path}}}});
    animation["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", move.manner}});
  }
  root["animations"] = {animation};
  root["buffers"] = {{{"byteLength", bytes.size()}, {"uri", "moves.bin"}}};
  return {root, bytes};
}

TEST_F(ModelCameras, AreConvertedAsTheModelIs) {
  save("a.gltf", scene().dump());
  ModelNotes notes = notes_of({0.5, {0, 1, 0}});
  notes.convention = {1, {0, 0, 1}};
  const CameraPath path = read_model_camera(folder_ / "a.gltf", "eye", notes);
  EXPECT_EQ(path.up, dvec3(0, 0, 1));
  EXPECT_EQ(path.camera(0, 1).eye, dvec3(0, -2.5, 0.5)) << "(0, 1, 5), turned and halved";
  EXPECT_LT(glm::distance(path.camera(0, 1).axes().forward, dvec3(0, 1, 0)), 1e-12);
  EXPECT_EQ(path.near, 0.25);
  notes.convention = {0.5, {0, 0, 1}};
  EXPECT_EQ(read_model_camera(folder_ / "a.gltf", "eye", notes).camera(0, 1).eye, dvec3(0, -5, 1)) << "turned alone";
}

TEST_F(ModelCameras, OneAtRestStandsStill) {
  save("a.gltf", scene().dump());
  const CameraPath path = read("a.gltf", "eye");
  EXPECT_EQ(path.frames, 2U);
  for (const std::size_t frame : {0U, 1U}) {
    const culler::Camera camera = path.camera(frame, 1);
    EXPECT_EQ(camera.eye, dvec3(0, 1, 5));
    EXPECT_EQ(camera.axes().forward, dvec3(0, 0, -1));
    EXPECT_EQ(camera.up, dvec3(0, 1, 0));
  }
  EXPECT_FALSE(path.keyframes[0].up) << "it is level";
  EXPECT_NEAR(path.fov_y_deg, 180 / std::numbers::pi, 1e-12);
  EXPECT_EQ(path.near, 0.5);
  EXPECT_TRUE(std::isinf(path.far));
}

TEST_F(ModelCameras, OneMayBeOrthographicAndPlacedByAMatrix) {
  save("a.gltf", scene().dump());
  const CameraPath path = read("a.gltf", "flat");
  EXPECT_EQ(path.projection, culler::Projection::orthographic);
  EXPECT_EQ(path.height, 4);
  EXPECT_EQ(path.far, 64);
  EXPECT_EQ(path.near, 64 * 0x1p-20);
  EXPECT_EQ(path.camera(0, 1).eye, dvec3(7, 8, 9));
  EXPECT_EQ(path.camera(0, 1).axes().forward, dvec3(-1, 0, 0));
}

TEST_F(ModelCameras, AnAnimationOfWhatIsAboveMovesIt) {
  // The arm turns by a right angle about y within a second, on the shorter way, and its camera with it, which meanwhile
  // jumps.
  const float h = std::sqrt(0.5F);
  const auto [root, bytes] = moved({{0, "rotation", "LINEAR", {2, 3}, {0, 0, 0, 1, 0, -h, 0, -h}},
                                    {1, "translation", "STEP", {2, 2.5}, {0, 1, 0, 0, 1, -4}}});
  save("a.gltf", root.dump());
  save("moves.bin", bytes);
  const CameraPath path = read("a.gltf", "eye");
  ASSERT_EQ(path.frames, 31U);
  const auto expect = [&](std::size_t frame, const dvec3& eye, const dvec3& forward) {
    EXPECT_LT(glm::distance(path.camera(frame, 1).eye, eye), 1e-6) << "frame " << frame;
    EXPECT_LT(glm::distance(path.camera(frame, 1).axes().forward, forward), 1e-6) << "frame " << frame;
  };
  expect(0, {0, 1, 5}, {0, 0, -1});
  expect(10, {0, 1, 5}, {-0.5, 0, -std::sqrt(0.75)});
  expect(14, {0, 1, 5}, {-std::sin(14 * std::numbers::pi / 60), 0, -std::cos(14 * std::numbers::pi / 60)});
  const double turn = std::numbers::pi / 3;
  expect(20, {-4 * std::sin(turn), 1, 5 - 4 * std::cos(turn)}, {-std::sin(turn), 0, -std::cos(turn)});
  expect(30, {-4, 1, 5}, {-1, 0, 0});
}

TEST_F(ModelCameras, CubicTracksHaveTangents) {
  // From (0, 0, 0) to (2, 0, 0) in two seconds, with tangents of 1 a second: evenly; and of 3 and 0 upwards.
  const auto [root, bytes] =
      moved({{0, "translation", "CUBICSPLINE", {0, 2}, {9, 9, 9, 0, 0, 0, 1, 3, 0, 1, 0, 0, 2, 0, 0, 9, 9, 9}}});
  save("a.gltf", root.dump());
  save("moves.bin", bytes);
  const CameraPath path = read("a.gltf", "eye");
  ASSERT_EQ(path.frames, 61U);
  EXPECT_LT(glm::distance(path.camera(0, 1).eye, dvec3(0, 1, 0)), 1e-12);
  // At the middle a tangent of 3 has raised it by 2 s * 3 / 8.
  EXPECT_LT(glm::distance(path.camera(30, 1).eye, dvec3(1, 1.75, 0)), 1e-12);
  EXPECT_LT(glm::distance(path.camera(15, 1).eye, dvec3(0.5, 1 + 2 * 3 * 0.140625, 0)), 1e-12);
  EXPECT_LT(glm::distance(path.camera(60, 1).eye, dvec3(2, 1, 0)), 1e-12);
}

TEST_F(ModelCameras, NormalizedIntegersAndBinaryChunksAreRead) {
  auto [root, bytes] = moved({{0, "translation", "LINEAR", {0, 1}, {0, 0, 0, 3, 0, 0}}});
  const std::size_t turns = bytes.size();
  for (const std::int16_t number : std::array<std::int16_t, 8>{0, 0, 0, 32767, 0, 32767, 0, 0})
    bytes.append(reinterpret_cast<const char*>(&number), 2);
  root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 8}, {"byteLength", bytes.size() - 8}});
  root["accessors"].push_back({{"bufferView", 2},
                               {"byteOffset", turns - 8},
                               {"componentType", 5122},
                               {"normalized", true},
                               {"count", 2},
                               {"type", "VEC4"}});
  root["animations"][0]["samplers"].push_back({{"input", 0}, {"output", 2}});
  root["animations"][0]["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "rotation"}}}});
  root["buffers"][0] = {{"byteLength", bytes.size()}};
  std::string text = root.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::uint32_t n) { return std::string(reinterpret_cast<const char*>(&n), 4); };
  const auto size = [](const std::string& s) { return static_cast<std::uint32_t>(s.size()); };
  save("a.glb", "glTF" + number(2) + number(28 + size(text) + size(bytes)) + number(size(text)) + "JSON" + text +
                    number(size(bytes)) + std::string("BIN\0", 4) + bytes);
  const CameraPath path = read("a.glb", "eye");
  EXPECT_LT(glm::distance(path.camera(30, 1).eye, dvec3(3, 1, 0)), 1e-12);
  EXPECT_LT(glm::distance(path.camera(30, 1).axes().forward, dvec3(0, 0, 1)), 1e-12) << "turned by half a circle";
}

TEST_F(ModelCameras, TheFirstAnimationThatMovesItIsTaken) {
  auto [root, bytes] = moved({{2, "translation", "LINEAR", {0, 9}, {0, 0, 0, 1, 0, 0}},
                              {0, "translation", "LINEAR", {0, 1}, {0, 0, 0, 3, 0, 0}},
                              {1, "translation", "LINEAR", {0, 2}, {0, 0, 0, 5, 0, 0}}});
  const json animation = root["animations"][0];
  root["animations"].clear();
  for (const json& channel : animation["channels"]) {
    root["animations"].push_back({{"samplers", animation["samplers"]}, {"channels", {channel}}});
  }
  save("a.gltf", root.dump());
  save("moves.bin", bytes);
  const CameraPath path = read("a.gltf", "eye");
  ASSERT_EQ(path.frames, 31U);
  EXPECT_LT(glm::distance(path.camera(30, 1).eye, dvec3(3, 1, 0)), 1e-12);
}

TEST_F(ModelCameras, NamesAreListed) {
  json root = scene();
  save("a.gltf", root.dump());
  EXPECT_EQ(failure("a.gltf", ""), "a.gltf: its cameras are camera:eye, camera:flat");
  save("A.GLTF", root.dump());
  EXPECT_EQ(failure("A.GLTF", ""), "A.GLTF: its cameras are camera:eye, camera:flat") << "by the same reader";
  EXPECT_EQ(failure("a.gltf", "ear"), "a.gltf: it has no camera \"ear\", but camera:eye, camera:flat");
  root["nodes"][0]["camera"] = 1;
  root["nodes"][0]["name"] = "eye";
  root["cameras"][1].erase("name");
  save("a.gltf", root.dump());
  EXPECT_EQ(failure("a.gltf", ""), "a.gltf: its cameras are camera:eye, camera:eye #1, camera:1");
  EXPECT_EQ(read("a.gltf", "eye #1").camera(0, 1).eye, dvec3(0, 1, 5));
  for (json& node : root["nodes"]) node.erase("camera");
  save("a.gltf", root.dump());
  EXPECT_EQ(failure("a.gltf", "eye"), "a.gltf: there is no camera in it");
  save("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(failure("a.obj", "eye"), "a.obj: there is no camera in it");
  EXPECT_EQ(failure("none.gltf", "eye").rfind("none.gltf: cannot", 0), 0U) << failure("none.gltf", "eye");
}

TEST_F(ModelCameras, FaultsAreNamed) {
  const Move good{0, "translation", "LINEAR", {0, 1}, {0, 0, 0, 3, 0, 0}};
  const auto fault = [&](const std::vector<Move>& moves, const std::function<void(json&)>& spoil) {
    auto [root, bytes] = moved(moves);
    spoil(root);
    save("a.gltf", root.dump());
    save("moves.bin", bytes);
    return failure("a.gltf", "eye");
  };
  const auto none = [](json&) {};
  Move back = good, few = good, endless = good;
  back.times = {1, 1};
  few.values.resize(3);
  endless.times = {0, 1e6F};
  EXPECT_EQ(fault({good}, none), "no error");
  EXPECT_EQ(fault({back}, none), "a.gltf: animation 0: sampler: the times do not ascend");
  EXPECT_EQ(fault({few}, none), "a.gltf: animation 0: sampler: times and values differ in number");
  EXPECT_EQ(fault({endless}, none), "a.gltf: its animation takes more than 1000000 frames");
  EXPECT_EQ(fault({good}, [](json& root) { root["nodes"][1]["children"] = {0}; }), "a.gltf: node 1: it is below itself");
  EXPECT_EQ(fault({good}, [](json& root) { root["nodes"][1]["children"] = {7}; }),
            "a.gltf: node 1 \"eye\": children: there is no such node");
  EXPECT_EQ(
      fault({good}, [](json& root) { root["accessors"][1]["count"] = 9007199254740991; }),
      "a.gltf: animation 0: accessor 1: 9007199254740991 elements, 12 bytes apart from byte 0 on, do not fit in 24 bytes");
  EXPECT_EQ(fault({good}, [](json& root) { root["bufferViews"][1]["byteOffset"] = 1000; }),
            "a.gltf: animation 0: accessor 1: bufferView 1: bytes 1000 to 1000 + 24 of a buffer of 32");
  EXPECT_EQ(fault({good}, [](json& root) { root["bufferViews"][1]["byteStride"] = 100; }),
            "a.gltf: animation 0: accessor 1: 2 elements, 100 bytes apart from byte 0 on, do not fit in 24 bytes");
  EXPECT_EQ(fault({good}, [](json& root) { root["accessors"][1]["type"] = "VEC4"; }),
            "a.gltf: animation 0: accessor 1: type: 4 instead of 3 components");
  EXPECT_EQ(fault({good}, [](json& root) { root["animations"][0]["channels"][0]["sampler"] = 3; }),
            "a.gltf: animation 0: sampler 3: there is none");
  EXPECT_EQ(
      fault({good}, [](json& root) { root["buffers"][0]["uri"] = "../moves.bin"; }),
      "a.gltf: animation 0: accessor 0: bufferView 0: buffer 0: \"../moves.bin\": cannot read: No such file or directory");
  EXPECT_EQ(fault({good}, [](json& root) { root["nodes"][1]["camera"] = 5; }), "a.gltf: camera 5: there are 2");
  EXPECT_EQ(fault({good},
                  [](json& root) {
                    root["nodes"][1]["scale"] = {1, 0, 1};
                  }),
            "a.gltf: camera \"eye\": the second and third column are no axes of a camera");
  EXPECT_EQ(fault({good}, [](json& root) { root["cameras"][0]["perspective"]["znear"] = -1; }),
            "a.gltf: camera \"eye\": in frame 0 the near plane must be before the eye and in range");
  save("a.gltf", R"({"asset": {"version": "1.0"}})");
  EXPECT_EQ(failure("a.gltf", "eye"), "a.gltf: cannot import: the import library does not say why") << "it is of glTF 1";
}

TEST_F(ModelCameras, ColladaHasThemToo) {
  save("a.dae", R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
    <asset><up_axis>Z_UP</up_axis></asset>
    <library_cameras><camera id="c" name="c"><optics><technique_common><perspective><xfov>60</xfov><aspect_ratio>1.5</aspect_ratio>
      <znear>0.25</znear><zfar>50</zfar></perspective></technique_common></optics></camera></library_cameras>
    <library_animations><animation id="m"><source id="t"><float_array id="ta" count="2">0 2</float_array><technique_common>
      <accessor source="#ta" count="2" stride="1"><param name="TIME" type="float"/></accessor></technique_common></source>
      <source id="v"><float_array id="va" count="6">1 2 3 5 2 3</float_array><technique_common>
      <accessor source="#va" count="2" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
      <param name="Z" type="float"/></accessor></technique_common></source>
      <source id="i"><Name_array id="ia" count="2">LINEAR LINEAR</Name_array><technique_common>
      <accessor source="#ia" count="2" stride="1"><param name="INTERPOLATION" type="name"/></accessor></technique_common></source>
      <sampler id="s"><input semantic="INPUT" source="#t"/><input semantic="OUTPUT" source="#v"/>
      <input semantic="INTERPOLATION" source="#i"/></sampler><channel source="#s" target="eye/place"/></animation></library_animations>
    <library_visual_scenes><visual_scene id="scene"><node id="eye" name="eye"><translate sid="place">1 2 3</translate>
      <rotate sid="r">1 0 0 90</rotate><instance_camera url="#c"/></node></visual_scene></library_visual_scenes>
    <scene><instance_visual_scene url="#scene"/></scene></COLLADA>)");
  const CameraPath path = read_model_camera(folder_ / "a.dae", "eye", notes_of({1, {0, 0, 1}}));
  ASSERT_EQ(path.frames, 61U);
  EXPECT_LT(glm::distance(path.camera(0, 1).eye, dvec3(1, 2, 3)), 1e-6);
  EXPECT_LT(glm::distance(path.camera(30, 1).eye, dvec3(3, 2, 3)), 1e-6);
  EXPECT_LT(glm::distance(path.camera(60, 1).eye, dvec3(5, 2, 3)), 1e-6);
  EXPECT_LT(glm::distance(path.camera(0, 1).axes().forward, dvec3(0, 1, 0)), 1e-6);
  EXPECT_FALSE(path.keyframes[0].up) << "it is level";
  EXPECT_NEAR(path.fov_y_deg, 360 / std::numbers::pi * std::atan(std::tan(std::numbers::pi / 6) / 1.5), 1e-4);
  EXPECT_EQ(path.near, 0.25);
  EXPECT_EQ(path.far, 50);
  EXPECT_EQ(failure("a.dae", "").rfind("a.dae: its cameras are camera:eye", 0), 0U) << failure("a.dae", "");
}

}  // namespace model_cameras_test
}  // namespace occlude::render
