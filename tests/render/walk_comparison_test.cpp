// SPDX-License-Identifier: MIT
#include "occlude/render/walk_comparison.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

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
