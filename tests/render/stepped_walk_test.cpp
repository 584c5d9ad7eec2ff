// SPDX-License-Identifier: MIT
// A walk with a step culls each frame after the same frames as one without. What is told of it afterwards is about those
// culls.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "occlude/render/city.h"
#include "occlude/render/walk.h"
#include "occlude/render/why.h"
#include "occlude/render/witness.h"

namespace occlude::render {
namespace stepped_walk_test {

class Record : public WalkOutput {
 public:
  void add_model(const culler::Culler&) override {}
  void add_frame(const ShownFrame&) override {}
  void add_witness(std::string_view line) override {
    witnesses[nlohmann::json::parse(line)["frame"].get<std::size_t>()].emplace_back(line);
  }
  void add_plate(const Plate& plate, const Image&) override { plates.push_back(plate); }

  std::map<std::size_t, std::vector<std::string>> witnesses;
  std::vector<Plate> plates;
};

class SteppedWalk : public testing::Test {
 protected:
  static constexpr std::size_t kEnd = 28, kStep = 9;

  static WalkOptions options(std::size_t step) {
    WalkOptions options;
    options.cull.method = culler::Method::frusta;
    options.begin = 3;
    options.end = kEnd;
    options.step = step;
    options.witness = "recorded";
    options.render = false;
    return options;
  }

  City city_ = generate_city(20'000, 1);
};

TEST_F(SteppedWalk, WhyTellsOfTheCullsOfTheWalk) {
  const WalkOptions stepped = options(kStep);
  Record every, some;
  static_cast<void>(walk(make_culler(city_.soup, options(1)), city_.path, options(1), "city", every));
  static_cast<void>(walk(make_culler(city_.soup, stepped), city_.path, stepped, "city", some));
  ASSERT_EQ(some.witnesses.size(), 3U);
  const culler::Culler culler = make_culler(city_.soup, stepped);
  for (const std::size_t frame : {3U, 5U, 12U, 20U, 21U, 27U}) {
    const ReplayedFrame replayed(culler, city_.path, stepped, frame);
    std::vector<std::string> lines;
    append_witnesses(lines, frame, replayed.camera(), culler, replayed.result(), stepped.cull, {});
    EXPECT_EQ(lines, every.witnesses[frame]) << frame;
    if ((frame - 3) % kStep == 0) {
      EXPECT_EQ(lines, some.witnesses[frame]) << frame;
    }
  }
}

TEST_F(SteppedWalk, HoldsInTheSameRegions) {
  for (const culler::Method method : {culler::Method::frusta, culler::Method::cover}) {
    WalkOptions every_frame = options(1), stepped = options(kStep);
    for (WalkOptions* const walk : {&every_frame, &stepped}) {
      walk->cull.method = method;
      walk->hold = 4;
    }
    Record every, some;
    const WalkResult all = walk(make_culler(city_.soup, every_frame), city_.path, every_frame, "city", every);
    const WalkResult few = walk(make_culler(city_.soup, stepped), city_.path, stepped, "city", some);
    ASSERT_EQ(some.witnesses.size(), 3U);
    for (const auto& [frame, lines] : some.witnesses) EXPECT_EQ(lines, every.witnesses[frame]) << frame;
    ASSERT_EQ(few.frames.size(), 3U);
    for (const FrameRecord& frame : few.frames) EXPECT_EQ(frame.region, all.frames[frame.frame - 3].region) << frame.frame;
    EXPECT_GT(all.regions.size(), 1U);
    EXPECT_LT(all.regions.size(), all.frames.size() / 2);
  }
}

TEST_F(SteppedWalk, TheMethodsTakeTurnsInGoingFirst) {
  for (const std::size_t step : {1U, 2U}) {
    WalkOptions stepped = options(step);
    stepped.witness.reset();
    Record output;
    const WalkResult result = walk(make_culler(city_.soup, stepped), city_.path, stepped, "city", output);
    for (std::size_t i = 1; i < result.frames.size(); ++i) {
      EXPECT_NE(result.frames[i].is_occlusion_first, result.frames[i - 1].is_occlusion_first) << step;
    }
  }
}

TEST_F(SteppedWalk, PlatesShowTheCullsOfTheWalk) {
  WalkOptions stepped = options(kStep);
  stepped.witness.reset();
  stepped.render = true;
  Record output;
  const WalkResult result = walk(make_culler(city_.soup, stepped), city_.path, stepped, "city", output);
  ASSERT_EQ(result.frames.size(), 3U);
  ASSERT_GE(output.plates.size(), 4U);
  for (std::size_t i = 1; i < output.plates.size(); i += 2) {
    const auto is_its = [&](const FrameRecord& frame) {
      return output.plates[i].file.ends_with(fmt::format("{:06}_outside.png", frame.frame));
    };
    const auto frame = std::ranges::find_if(result.frames, is_its);
    ASSERT_NE(frame, result.frames.end()) << output.plates[i].file;
    const std::string drawn = fmt::format("outside: {} polygons drawn", frame->rendered_polygons);
    EXPECT_NE(output.plates[i].caption.find(drawn), std::string::npos) << output.plates[i].caption;
  }
}

}  // namespace stepped_walk_test
}  // namespace occlude::render
