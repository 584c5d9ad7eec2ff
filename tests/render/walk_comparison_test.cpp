// SPDX-License-Identifier: MIT
#include "occlude/render/walk_comparison.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "occlude/render/comparison_report.h"
#include "occlude/render/errors.h"
#include "occlude/render/summary.h"

namespace occlude::render {
namespace walk_comparison_test {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What is read is kept for an input until the process ends. Removed before, it would lend its number to another test's
/// file.
struct SummaryFile {
  ~SummaryFile() { fs::remove(path); }
  const fs::path path = fs::temp_directory_path() / ("occlude_walk_comparison_" + std::to_string(getpid()) + ".json");
};

const SummaryFile file;

/// What read_walk() says of the summary.
std::string failure(const Json& summary) {
  std::ofstream(file.path) << summary;
  try {
    static_cast<void>(read_walk(file.path));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A summary that has all members.
Json whole_summary() {
  Summary summary;
  summary.options.cull.cover.work = 7;
  summary.options.cull.cover.ms = 2.5;
  summary.options.preprocess = "some.pre";
  summary.machine.renderer = "some renderer";
  summary.mean.visible_polygons = summary.mean.hidden_polygons = 1;
  summary.mean.frame_ms = summary.mean.frame_ms_view_frustum_only = summary.mean.frame_ms_visible_only = 1;
  summary.mean.frame_processor_ms = summary.mean.frame_processor_ms_view_frustum_only = 1;
  summary.load = 1e6;  // so that it says that the machine was busy
  summary.culled_share_of_hidden = summary.speedup = summary.limit_by_polygons = summary.limit_by_visible = 1;
  summary.wrong_pixels = summary.snapped_pixels = summary.false_culls = 0;
  summary.options.hold = 2;
  summary.held = {.regions = 3, .frames_by_point = 0, .region_ms = 5, .frame_ms = 1, .frames_a_region = 20};
  return json_of(summary);
}

/// What is not compared.
bool is_read(std::string_view name) {
  constexpr std::array<std::string_view, 5> kOthers{"/spread/", "/methods", "/missed", "/reference_frames",
                                                    "/speedup_limit/exceeded"};
  for (const std::string_view other : kOthers) {
    if (name.starts_with(other)) return false;
  }
  return true;
}

/// "mean.cull_ms" of "/mean/cull_ms", and "options.size" of "/options/size/0".
std::string dotted(std::string name) {
  if (std::isdigit(static_cast<unsigned char>(name.back())) != 0) name.resize(name.rfind('/'));
  for (char& c : name) c = c == '/' ? '.' : c;
  return name.substr(1);
}

TEST(WalkComparison, RefusesAValueOfAnotherType) {
  const Json summary = whole_summary();
  EXPECT_EQ(failure(summary), "no error");
  std::size_t members = 0;
  const Json flat = summary.flatten();
  for (const auto& [name, value] : flat.items()) {
    if (!is_read(name)) continue;
    ++members;
    // No member is any of these.
    for (const Json& wrong : {Json(Json::object()), Json(-1), Json(-0.5), Json{1, "2"}, Json("inf")}) {
      if (value.is_string() && wrong.is_string()) continue;
      Json forged = summary;
      forged[Json::json_pointer(name)] = wrong;
      const std::string text = failure(forged);
      EXPECT_TRUE(
          text.starts_with(file.path.string() + ": not a summary of `occlude walk`: " + dotted(name) + ": expected "))
          << name << " " << wrong << ": " << text;
    }
  }
  EXPECT_GT(members, 50U);
}

/// Two walks of which B took so many times as long as A to draw the view frustum alone, to cull, and in all; and so many
/// times as much of the processor for the first and the second.
WalkComparison compared(double control, double culling, double frames, double processor_control = 1, double processor = 1) {
  Summary summary;
  const auto reading = [&](const char* label, double without, double cull_ms, double frame_ms, double without_processor_ms,
                           double cull_processor_ms) {
    summary.mean.frame_processor_ms_view_frustum_only = without_processor_ms;
    summary.mean.cull_processor_ms = cull_processor_ms;
    summary.mean.frame_ms_view_frustum_only = without;
    summary.mean.cull_ms = cull_ms;
    summary.mean.frame_ms = frame_ms;
    summary.speedup = without / frame_ms;
    std::string csv = "frame,view_frustum_frame_ms,cull_ms,frame_ms,view_frustum_frame_processor_ms,cull_processor_ms\n";
    for (int i = 0; i < 20; ++i)
      csv += fmt::format("{},{},{},{},{},{}\n", i, without, cull_ms, frame_ms, without_processor_ms, cull_processor_ms);
    std::ofstream(file.path) << csv;
    return WalkReading{label, label, json_of(summary), {}, FrameTable(file.path)};
  };
  const WalkReading a = reading("a", 10, 2, 8, 10, 2);
  return compare_walks(a, reading("b", 10 * control, 2 * culling, 8 * frames, 10 * processor_control, 2 * processor));
}

TEST(WalkComparison, TimesOfAMachineOfAnotherPaceAreNotJudged) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(compared(1.09, 1.5, 1).worse(), (Names{"mean.cull_ms"}));
  for (const double control : {1.11, 0.9}) {
    const WalkComparison comparison = compared(control, 1.5, control);
    EXPECT_FALSE(is_same_pace(comparison.control));
    EXPECT_NEAR(comparison.control.value_or(0), control, 1e-12);
    EXPECT_EQ(comparison.worse(), Names{}) << control;
    EXPECT_NE(text_of(comparison).find("warning: Times by the clock cannot be compared"), std::string::npos);
    EXPECT_EQ(json_of(comparison)["warnings"].size(), 1U);
  }
  // Those of the processor have a control of their own.
  EXPECT_EQ(compared(1.2, 1.5, 1.2, 1.05, 1.5).worse(), (Names{"mean.cull_processor_ms"}));
  EXPECT_EQ(compared(1, 1.5, 1, 1.2, 1.5).worse(), (Names{"mean.cull_ms"}));
  EXPECT_NE(text_of(compared(1, 1, 1, 1.2)).find("took 1.20 times as much in B"), std::string::npos);
  // The speedup is a ratio of times of one walk.
  EXPECT_EQ(compared(1.2, 1, 1.5).worse(), (Names{"speedup"}));
  EXPECT_EQ(text_of(compared(1, 1, 1)).find("warning"), std::string::npos);
}

TEST(WalkComparison, TakesAWalkThatDoesNotHold) {
  Json summary = whole_summary();
  summary.erase("held");
  EXPECT_EQ(failure(summary), "no error");
}

TEST(WalkComparison, RefusesANumberOutOfRange) {
  Json summary = whole_summary();
  summary["culled_share"] = 1.5;
  EXPECT_TRUE(failure(summary).ends_with("culled_share: expected a number from 0 to 1"));
  summary["culled_share"] = 1;
  summary["frames"] = 2.5;
  EXPECT_TRUE(failure(summary).ends_with("frames: expected a whole number"));
  summary["frames"] = 2;
  EXPECT_EQ(failure(summary), "no error");
}

TEST(WalkComparison, RefusesMembersOfWhatIsNoObject) {
  for (const char* name : {"mean", "options", "machine", "operations", "speedup_limit"}) {
    for (const Json& wrong : {Json(7), Json("text"), Json::array(), Json()}) {
      Json summary = whole_summary();
      summary[name] = wrong;
      EXPECT_TRUE(failure(summary).ends_with(std::string(name) + ": expected an object")) << name << " " << wrong;
    }
  }
}

}  // namespace walk_comparison_test
}  // namespace occlude::render
