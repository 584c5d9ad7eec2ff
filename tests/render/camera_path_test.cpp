// SPDX-License-Identifier: MIT
#include "occlude/render/camera_path.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace camera_path_test {

namespace fs = std::filesystem;
using nlohmann::json;

void save(const fs::path& file, const CameraPath& path) {
  OutputFile output(file);
  write_camera_path(output, path);
  output.commit();
}

class CameraPathTest : public testing::Test {
 protected:
  CameraPathTest() { fs::create_directories(folder_); }
  ~CameraPathTest() override { fs::remove_all(folder_); }

  [[nodiscard]] CameraPath read(const std::string& text) const {
    std::ofstream(file_) << text;
    return read_camera_path(file_);
  }
  /// The message after the name of the file.
  [[nodiscard]] std::string failure(const std::string& text) const {
    try {
      static_cast<void>(read(text));
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.rfind(file_.string(), 0), 0U) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      return what.substr(std::min(file_.string().size(), what.size()));
    }
    return "no error";
  }
  /// The failure of a good path with `member` set to `value`.
  [[nodiscard]] std::string failure_with(const std::string& member, const json& value) const {
    json path = good();
    path[member] = value;
    return failure(path.dump());
  }
  [[nodiscard]] static json good() {
    return json::parse(R"({"frames": 5, "keyframes": [{"eye": [0, 0, 0], "target": [1, 0, 0]},
        {"eye": [10, 0, 0], "target": [11, 0, 0]}, {"eye": [10, 20, 0], "target": [11, 20, 0]}]})");
  }
  [[nodiscard]] std::string content() const {
    std::ostringstream out;
    out << std::ifstream(file_, std::ios::binary).rdbuf();
    return out.str();
  }

  fs::path folder_ = fs::temp_directory_path() / ("occlude_camera_path_" + std::to_string(getpid()));
  fs::path file_ = folder_ / "path.json";
};

TEST_F(CameraPathTest, DefaultsAreTheContracts) {
  const CameraPath path = read(good().dump());
  EXPECT_EQ(path.frames, 5U);
  EXPECT_EQ(path.keyframes.size(), 3U);
  EXPECT_EQ(path.fov_y_deg, 60);
  EXPECT_EQ(path.near, 0.1);
  EXPECT_TRUE(std::isinf(path.far));
  EXPECT_EQ(path.up, glm::dvec3(0, 0, 1));
  EXPECT_EQ(path.interpolation, CameraPath::Interpolation::linear);
  EXPECT_EQ(path.projection, culler::Projection::perspective);
}

TEST_F(CameraPathTest, UnknownMembersAreIgnored) {
  EXPECT_EQ(failure_with("name", "a"), "no error");
  EXPECT_EQ(failure_with("model", json::array()), "no error");
}

TEST_F(CameraPathTest, LinearFramesLieOnTheKeyframes) {
  const CameraPath path = read(good().dump());
  EXPECT_EQ(path.camera(0, 2).eye, glm::dvec3(0, 0, 0));
  EXPECT_EQ(path.camera(1, 2).eye, glm::dvec3(5, 0, 0));
  EXPECT_EQ(path.camera(2, 2).eye, glm::dvec3(10, 0, 0));
  EXPECT_EQ(path.camera(3, 2).target, glm::dvec3(11, 10, 0));
  EXPECT_EQ(path.camera(4, 2).eye, glm::dvec3(10, 20, 0));
  EXPECT_EQ(path.camera(4, 2).aspect, 2);
}

TEST_F(CameraPathTest, ViewpointsAreThoseOfSomeFrames) {
  CameraPath path = read(good().dump());
  ASSERT_EQ(path.views(1.5).size(), path.frames);
  EXPECT_EQ(path.views(1.5)[1], path.camera(1, 1.5));
  path.frames = 1'000'000;
  ASSERT_EQ(path.views(1).size(), 100U);
  EXPECT_EQ(path.views(1).front().eye, path.keyframes.front().eye);
  EXPECT_EQ(path.views(1).back().eye, path.keyframes.back().eye);
}

TEST_F(CameraPathTest, KeyframesAreHitExactlyWhateverTheirNumbers) {
  CameraPath path;
  // Coordinates so far apart that a + (b - a) is not b.
  for (int i = 0; i < 8; ++i)
    path.keyframes.push_back({{i % 2 == 0 ? 1e17 : 0.1, 1e5 / 3 + i, -0.7}, {0.3 * i, i % 2 == 0 ? 1e17 : 0.7, 1.0 / 3}});
  path.frames = 7 * 13 + 1;
  for (const auto interpolation : {CameraPath::Interpolation::linear, CameraPath::Interpolation::smooth}) {
    path.interpolation = interpolation;
    for (std::size_t i = 0; i < path.keyframes.size(); ++i) {
      EXPECT_EQ(path.camera(13 * i, 1).eye, path.keyframes[i].eye);
      EXPECT_EQ(path.camera(13 * i, 1).target, path.keyframes[i].target);
    }
  }
}

TEST_F(CameraPathTest, SmoothRoundsTheCorner) {
  json smooth = good();
  smooth["interpolation"] = "smooth";
  // Catmull-Rom at the middle of the first segment, mirrored before the first keyframe: (-a + 9b + 9c - d) / 16.
  const glm::dvec3 eye = read(smooth.dump()).camera(1, 1).eye;
  EXPECT_NEAR(eye.x, (10 + 0 + 90 - 10) / 16.0, 1e-12);
  EXPECT_NEAR(eye.y, -20 / 16.0, 1e-12);
}

TEST_F(CameraPathTest, WritingAndReadingKeepsEveryBit) {
  CameraPath path;
  path.frames = 77;
  path.keyframes = {{{0.1, -1.0 / 3, 1e20}, {4e6 + 1e-9, 0x1p-100, 5}},
                    {{-0.1, 2, 3}, {1.2345678901234567e30, -0x1p100, 8}}};
  path.interpolation = CameraPath::Interpolation::smooth;
  path.projection = culler::Projection::orthographic;
  path.height = 12.3;
  path.near = 0.7;
  path.far = 1234.5678901234567;
  path.up = {0.1, 0.2, 0.9};
  save(file_, path);
  const std::string text = content();
  const CameraPath back = read_camera_path(file_);
  EXPECT_EQ(back.frames, path.frames);
  EXPECT_EQ(back.interpolation, path.interpolation);
  EXPECT_EQ(back.projection, path.projection);
  EXPECT_EQ(back.height, path.height);
  EXPECT_EQ(back.near, path.near);
  EXPECT_EQ(back.far, path.far);
  EXPECT_EQ(back.up, path.up);
  ASSERT_EQ(back.keyframes.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.keyframes[i].eye, path.keyframes[i].eye);
    EXPECT_EQ(back.keyframes[i].target, path.keyframes[i].target);
  }
  save(file_, back);
  EXPECT_EQ(content(), text);
}

TEST_F(CameraPathTest, TheWrittenTextIsFixed) {
  CameraPath path;
  path.frames = 2;
  path.keyframes = {{{0, 0.1, -2}, {1, 0, 0}}, {{1e-7, 0, 0}, {1, 0, 0.25}}};
  save(file_, path);
  EXPECT_EQ(content(),
            "{\"frames\": 2,\n"
            " \"interpolation\": \"linear\", \"projection\": \"perspective\", \"fov_y_deg\": 60.0, \"near\": 0.1,"
            " \"up\": [0.0, 0.0, 1.0],\n \"keyframes\": [\n"
            "  {\"eye\": [0.0, 0.1, -2.0], \"target\": [1.0, 0.0, 0.0]},\n"
            "  {\"eye\": [1e-07, 0.0, 0.0], \"target\": [1.0, 0.0, 0.25]}\n]}\n");
}

TEST_F(CameraPathTest, SyntaxErrorsNameTheLine) {
  const std::string message = failure("{\"frames\": 3,\n\"keyframes\": [}\n");
  EXPECT_EQ(message.rfind(":2: ", 0), 0U) << message;
  EXPECT_EQ(failure("").rfind(":1: ", 0), 0U) << failure("");
  EXPECT_EQ(failure("1"), ": expected a JSON object");
  // The message about a number that is too large does not repeat its digits.
  EXPECT_EQ(failure("{\"frames\": 1e999}"), ": frames: expected a whole number from 2 to 1000000");
  json path = good();
  path["near"] = 7;
  std::string text = path.dump();
  text.replace(text.find("\"near\":7") + 7, 1, std::string(1'000'000, '9'));
  EXPECT_EQ(failure(text), ": near: must be finite and greater than 0");
  EXPECT_EQ(failure("{\n\"frames\": \x1b[2J" + std::string(1'000'000, 'x')), ":2: not JSON, near column 11");
  EXPECT_EQ(failure(std::string(1'000'000, '[')), ":1: nested too deeply, near column 33");
  EXPECT_EQ(failure("{\"frames\": 1,\n \"frames\": 5}"), ":2: repeated key in an object, near column 2");
  EXPECT_EQ(failure(R"({"a": [{"b": "c", "c": {"b": 1e999}}, {"\u0062": 1, "b" : 2}]})"),
            ":1: repeated key in an object, near column 53");
}

TEST_F(CameraPathTest, FaultsNameTheMember) {
  json path = good();
  path.erase("frames");
  EXPECT_EQ(failure(path.dump()), ": frames: missing");
  path = good();
  path.erase("keyframes");
  EXPECT_EQ(failure(path.dump()), ": keyframes: missing");
  path = good();
  path["keyframes"][1].erase("target");
  EXPECT_EQ(failure(path.dump()), ": keyframes[1].target: missing");
  path = good();
  path["keyframes"][2]["eye"] = {1, 2};
  EXPECT_EQ(failure(path.dump()), ": keyframes[2].eye: expected three numbers [x, y, z]");
  path["keyframes"][2]["eye"] = {1, 2, "3"};
  EXPECT_EQ(failure(path.dump()), ": keyframes[2].eye: expected a number");
  path["keyframes"][2]["eye"] = {1, 2, 1e200};
  EXPECT_EQ(failure(path.dump()).rfind(": keyframes[2].eye: z is out of range", 0), 0U);
  path["keyframes"][2]["eye"] = path["keyframes"][2]["target"];
  EXPECT_EQ(failure(path.dump()), ": keyframes[2]: eye and target are the same point");
  path["keyframes"][2] = 5;
  EXPECT_EQ(failure(path.dump()).rfind(": keyframes[2]: expected", 0), 0U);
}

TEST_F(CameraPathTest, ValuesOutsideTheirRangeAreRefused) {
  for (const json& frames : {json(1), json(-3), json(2.5), json("9"), json(1000001)})
    EXPECT_EQ(failure_with("frames", frames), ": frames: expected a whole number from 2 to 1000000");
  EXPECT_EQ(failure_with("keyframes", json::array()), ": keyframes: expected an array of at least two");
  EXPECT_EQ(failure_with("near", 0), ": near: must be finite and greater than 0");
  EXPECT_EQ(failure_with("far", 0.1), ": far: must be greater than near");
  EXPECT_EQ(failure_with("far", nullptr), ": far: expected a number");
  EXPECT_EQ(failure_with("fov_y_deg", 180), ": fov_y_deg: must be from 0.001 to 179");
  EXPECT_EQ(failure_with("fov_y_deg", -1), ": fov_y_deg: must be finite and greater than 0");
  EXPECT_EQ(failure_with("interpolation", "cubic"), ": interpolation: expected \"linear\" or \"smooth\"");
  EXPECT_EQ(failure_with("projection", 3), ": projection: expected \"perspective\" or \"orthographic\"");
  EXPECT_EQ(failure_with("projection", "orthographic"), ": height: missing");
  EXPECT_EQ(failure_with("up", {0, 0, 0}), ": up: must not be zero");
  EXPECT_EQ(failure_with("up", {2, 0, 0}),
            ": keyframes: in frame 0 eye and target meet, or up lies along the line of sight");
}

TEST_F(CameraPathTest, AFrameWithoutLineOfSightIsRefused) {
  // Between the keyframes the target passes through the eye.
  EXPECT_EQ(failure(R"({"frames": 3, "keyframes": [{"eye": [0, 0, 0], "target": [1, 0, 0]},
                        {"eye": [0, 0, 0], "target": [-1, 0, 0]}]})"),
            ": keyframes: in frame 1 eye and target meet, or up lies along the line of sight");
}

TEST_F(CameraPathTest, UpIsThatOfTheModelWhereThePathSaysNone) {
  std::ofstream(file_) << good().dump();
  EXPECT_EQ(read_camera_path(file_, {.up = {0, 1, 0}, .order = {}}).up, glm::dvec3(0, 1, 0));
  json own = good();
  own["up"] = {0, 2, 5};
  std::ofstream(file_) << own.dump();
  EXPECT_EQ(read_camera_path(file_, {.up = {0, 1, 0}, .order = {}}).up, glm::dvec3(0, 2, 5));
}

TEST_F(CameraPathTest, AViewAlongUpNamesTheMemberToWrite) {
  json down = good();
  down["keyframes"][0]["target"] = {0, 0, -1};
  EXPECT_EQ(failure(down.dump()),
            ": keyframes: in frame 0 eye and target meet, or up lies along the line of sight: write \"up\": [x, y, z]");
  down["up"] = {0, 1, 0};
  EXPECT_EQ(failure(down.dump()), "no error");
}

TEST_F(CameraPathTest, RoundingNoiseIsZero) {
  json noisy = good();
  noisy["keyframes"][1]["eye"] = {10, 1e-40, -1e-300};
  noisy["up"] = {1e-33, 0, 1};
  const CameraPath path = read(noisy.dump());
  EXPECT_EQ(path.keyframes[1].eye, glm::dvec3(10, 0, 0));
  EXPECT_EQ(path.up, glm::dvec3(0, 0, 1));
  EXPECT_EQ(path.noise, 3U);
  // Beside numbers that are as little, it is no noise.
  noisy["keyframes"][1] = {{"eye", {1e-40, 0, 0}}, {"target", {1e-20, 0, 0}}};
  EXPECT_EQ(failure(noisy.dump()).rfind(": keyframes[1].eye: x is out of range", 0), 0U) << failure(noisy.dump());
}

TEST_F(CameraPathTest, RoundingNoiseBetweenKeyframesIsZero) {
  // An eighth of the least legal number, beside large ones.
  const CameraPath path = read(R"({"frames": 9, "keyframes": [{"eye": [0, 0, 0], "target": [1, 0, 0]},
                                   {"eye": [0, 7.888609052210118e-31, 0], "target": [1, 0, 0]}]})");
  EXPECT_EQ(path.camera(1, 1).eye, glm::dvec3(0, 0, 0));
  EXPECT_EQ(path.camera(8, 1).eye, glm::dvec3(0, 0x1p-100, 0));
}

TEST_F(CameraPathTest, ATiltedKeyframeHasItsOwnUp) {
  json tilted = good();
  tilted["keyframes"][1]["up"] = {0, 1, 0};
  const CameraPath path = read(tilted.dump());
  EXPECT_EQ(path.camera(0, 1).up, glm::dvec3(0, 0, 1));
  EXPECT_EQ(path.camera(1, 1).up, glm::dvec3(0, 0.5, 0.5));
  EXPECT_EQ(path.camera(2, 1).up, glm::dvec3(0, 1, 0));
  save(file_, path);
  EXPECT_EQ(read_camera_path(file_).camera(2, 1).up, glm::dvec3(0, 1, 0));
  tilted["keyframes"][1]["up"] = {0, 0, 0};
  EXPECT_EQ(failure(tilted.dump()), ": keyframes[1].up: must not be zero");
}

TEST_F(CameraPathTest, TheModelIsWritten) {
  CameraPath path = read(good().dump());
  path.model = "a \"model\".ply";
  save(file_, path);
  EXPECT_EQ(read_camera_path(file_).model, path.model);
}

TEST_F(CameraPathTest, AMissingFileIsNamed) {
  EXPECT_THROW(static_cast<void>(read_camera_path(folder_ / "none.json")), InputError);
  EXPECT_THROW(static_cast<void>(read_camera_path(folder_)), InputError);
}

}  // namespace camera_path_test
}  // namespace occlude::render
