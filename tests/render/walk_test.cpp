// SPDX-License-Identifier: MIT
// The comparison of pictures in a walk: it must find a planted error, and distinguish the renderer's rounding from one.
#include "occlude/render/walk.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison.h"
#include "frame/culler_access.h"
#include "occlude/render/methods.h"
#include "occlude/render/model_text.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/paper_report.h"
#include "occlude/render/scene_renderer.h"
#include "occlude/render/summary.h"
#include "occlude/render/walk_page.h"

namespace walk_test {

using namespace occlude;
using namespace occlude::render;

void add_wall(culler::PolygonSoup& soup, double x, double y0, double y1) {
  std::vector<std::uint32_t> loop;
  for (const glm::dvec3& v : {glm::dvec3{x, y0, -1}, glm::dvec3{x, y1, -1}, glm::dvec3{x, y1, 1}, glm::dvec3{x, y0, 1}}) {
    loop.push_back(soup.add_vertex(v));
  }
  soup.add_polygon(loop);
}

/// A wall, a square behind it and a square beside it, the same squares of glass, which are drawn last, and glass before the
/// wall, each in a leaf of its own; seen from the origin along +x.
class Judge : public testing::Test {
 protected:
  static culler::Culler make_culler() {
    culler::PolygonSoup soup;
    add_wall(soup, 4, -1, 1);
    add_wall(soup, 6, -0.5, 0.5);
    add_wall(soup, 6, 2, 3);
    add_wall(soup, 6, -0.5, 0.5);
    add_wall(soup, 6, 2, 3);
    add_wall(soup, 3, -0.5, 0.5);
    soup.see_through_from(3);
    culler::BuildConfig config;
    config.hierarchy.leaf_size = 1;
    return culler::Culler(soup, config);
  }

  Picture draw(std::span<const PolygonRange> ranges) {
    renderer_.draw(camera_, ranges);
    return {renderer_.image(), renderer_.item_buffer(camera_, ranges)};
  }

  Picture draw_all() {
    const PolygonRange all = culler_.hierarchy().soup().all();
    return draw(std::span(&all, 1));
  }

  /// The verdict on culling the polygon with this number in the input, by the wall's shadow.
  FrameRecord judge_cull_of(std::uint32_t original) {
    const auto& hierarchy = culler_.hierarchy();
    culler::CullOptions options{.method = culler::Method::frusta};
    options.occluders = 1;
    culler::CullResult frame = culler_.cull(camera_, options);
    EXPECT_EQ(hierarchy.original(occluders_of(culler_).parts(frame.occluders.at(0).index)[0]), 0U);
    frame.culled.clear();
    frame.drawn.clear();
    for (std::uint32_t n = 0; n < hierarchy.nodes().size(); ++n) {
      const auto& node = hierarchy.nodes()[n];
      if (!node.is_leaf()) continue;
      if (hierarchy.original(node.first) == original) {
        frame.culled.push_back({n, culler::Culled::By::shadow, 0});
      } else {
        frame.drawn.push_back({node.first, node.count});
      }
    }
    FrameRecord record;
    compare(draw_all(), draw(frame.drawn), culler_, camera_, frame, record);
    return record;
  }

  culler::Camera camera_;
  culler::Culler culler_ = make_culler();
  std::unique_ptr<OffscreenContext> context_ = make_offscreen_context();
  SceneRenderer renderer_{culler_.hierarchy().soup(), 320, 180};
};

TEST_F(Judge, AcceptsWhatIsHidden) {
  const FrameRecord record = judge_cull_of(1);
  EXPECT_EQ(record.false_culls, 0U);
  EXPECT_EQ(record.wrong_pixels, 0U);
  EXPECT_EQ(record.visible_polygons, 3U);
}

TEST_F(Judge, AcceptsHiddenGlass) {
  const FrameRecord record = judge_cull_of(3);
  EXPECT_EQ(record.false_culls, 0U);
  EXPECT_EQ(record.wrong_pixels, 0U);
}

TEST_F(Judge, FindsVisibleGlassCulled) {
  const FrameRecord record = judge_cull_of(5);
  EXPECT_EQ(record.false_culls, 1U);
  EXPECT_GT(record.wrong_pixels, 100U);
  EXPECT_EQ(record.snapped_pixels, 0U);
}

TEST_F(Judge, FindsAVisiblePolygonCulled) {
  const FrameRecord record = judge_cull_of(2);
  EXPECT_EQ(record.false_culls, 1U);
  EXPECT_GT(record.wrong_pixels, 100U);
  EXPECT_EQ(record.snapped_pixels, 0U);
}

TEST_F(Judge, FindsTheOccluderItselfCulled) {
  const FrameRecord record = judge_cull_of(0);
  EXPECT_EQ(record.false_culls, 1U);
  // Only on the wall's own outline could rounding be the reason.
  EXPECT_LT(record.snapped_pixels * 10, record.wrong_pixels);
}

WalkResult one_frame(const FrameRecord& record) {
  WalkResult result;
  result.polygons = 3;
  result.frames = {record};
  return result;
}

TEST(Summary, PassesOnlyWhenEveryPixelIsExplained) {
  FrameRecord record;
  EXPECT_TRUE(passed(one_frame(record)));
  record.wrong_pixels = record.snapped_pixels = 2;
  EXPECT_TRUE(passed(one_frame(record)));
  record.wrong_pixels = 3;
  EXPECT_FALSE(passed(one_frame(record)));
  record.wrong_pixels = 2;
  record.false_culls = 1;
  EXPECT_FALSE(passed(one_frame(record)));
}

FrameRecord some_frame() {
  FrameRecord record;
  record.view_frustum_polygons = 100;
  record.rendered_polygons = 40;
  record.visible_polygons = 20;
  record.frame_ms = 5;
  record.view_frustum_frame_ms = 10;
  return record;
}

TEST(Summary, HasTheMembersOfTheContract) {
  const auto json = json_of(summarise(one_frame(some_frame()), {}, "model.ply"));
  EXPECT_EQ(json["polygons"], 3);
  EXPECT_EQ(json["frames"], 1);
  EXPECT_EQ(json["mean"]["view_frustum_polygons"], 100);
  EXPECT_EQ(json["mean"]["rendered_polygons"], 40);
  EXPECT_EQ(json["mean"]["hidden_polygons"], 80);
  EXPECT_EQ(json["speedup"], 2);
  EXPECT_EQ(json["speedup_limit"]["polygons"], 2.5);
  EXPECT_EQ(json["speedup_limit"]["visible"], 5);
  EXPECT_NEAR(json["culled_share"].get<double>(), 0.6, 1e-12);
  for (const char* name : {"wrong_pixels", "false_culls", "operations", "machine"}) EXPECT_TRUE(json.contains(name)) << name;
}

/// The page of a model of two walls.
std::string page_of(const Summary& summary, const WalkResult& result) {
  culler::PolygonSoup soup;
  add_wall(soup, 4, -1, 1);
  add_wall(soup, 6, -1, 1);
  const culler::Culler culler(soup);
  WalkRecording recording(culler);
  const culler::CullResult culled = culler.cull(culler::Camera{});
  recording.add_frame({result.frames[0], culler::Camera{}, culled, {}, nullptr, nullptr});
  return walk_page(summary, {{{{&summary.options, &result}, &recording}}, {}, "occlude walk 'a<b.ply'", "{}"});
}

TEST(Summary, TextAndPageShowItsFigures) {
  const WalkResult result = one_frame(some_frame());
  const Summary summary = summarise(result, {}, "model.ply");
  EXPECT_NE(text_of(summary).find("+100 %"), std::string::npos) << text_of(summary);
  const std::string page = page_of(summary, result);
  EXPECT_NE(page.find("<b>60.0 %</b>"), std::string::npos) << page;
  EXPECT_NE(page.find("<b>2.00 &times;</b>"), std::string::npos) << page;
  EXPECT_NE(page.find("<td>75.0 %</td>"), std::string::npos) << page;  // of the hidden polygons, culled
  EXPECT_NE(page.find("occlude walk 'a&lt;b.ply'"), std::string::npos) << page;
  EXPECT_NE(page.find("The model is simplified here: the 2 largest of its 3 polygons."), std::string::npos) << page;
}

/// Two walks of the same frames: 40 of 100 polygons drawn, and 25.
Summary two_methods(const WalkResult& frusta, const WalkResult& cover) {
  WalkOptions options, beside;
  options.cull.method = culler::Method::frusta;
  beside.cull.method = culler::Method::cover;
  Summary summary = summarise(frusta, options, "model.ply");
  summary.methods = methods_of({{&options, &frusta}, {&beside, &cover}}, true);
  return summary;
}

TEST(Methods, StandSideBySide) {
  const WalkResult frusta = one_frame(some_frame());
  WalkResult cover = frusta;
  FrameRecord& frame = cover.frames[0];
  frame.rendered_polygons = 25;
  frame.frame_ms = 2.5;
  frame.cull_ms = 1.5;
  frame.wrong_pixels = 5;
  frame.snapped_pixels = 3;
  frame.false_culls = 7;
  const Summary summary = two_methods(frusta, cover);
  const auto json = json_of(summary)["methods"];
  ASSERT_EQ(json.size(), 4U);
  const auto column = [&](const char* member) {
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    for (const auto& row : json) values.push_back(row[member]);
    return values.dump();
  };
  EXPECT_EQ(column("method"), R"(["view frustum alone","shadow frusta","joined shadows","visible polygons only"])");
  EXPECT_EQ(column("drawn"), "[100.0,40.0,25.0,20.0]");
  EXPECT_EQ(column("culled_share"), "[0.0,0.6,0.75,0.8]");
  EXPECT_EQ(column("hidden_culled"), "[0.0,0.75,0.9375,1.0]");
  EXPECT_EQ(column("frame_ms_view_frustum_only"), "[10.0,10.0,10.0,10.0]");
  EXPECT_EQ(column("speedup"), "[1.0,2.0,4.0,null]");
  EXPECT_EQ(column("wrong_pixels"), "[null,0,2,null]") << "those that rounding does not explain";
  EXPECT_EQ(column("false_culls"), "[null,0,7,null]");
  // The rest stays that of the first.
  EXPECT_EQ(json_of(summary)["method"], "frusta");
  EXPECT_EQ(json_of(summary)["mean"]["rendered_polygons"], 40);
  for (const std::string& text : {text_of(summary), page_of(summary, frusta)}) {
    for (const char* part : {"shadow frusta", "joined shadows", "75.0 %", "93.8 %"}) {
      EXPECT_NE(text.find(part), std::string::npos) << part << " is not in " << text;
    }
  }
  EXPECT_NE(page_of(summary, frusta).find("<div class=\"fact bad\"><b>7</b>visible polygons culled"), std::string::npos);
  EXPECT_NE(text_of(summary).find("by joined shadows: false culls 7, unexplained wrong pixels 2\n"), std::string::npos);
  EXPECT_EQ(text_of(two_methods(frusta, frusta)).find("unexplained"), std::string::npos);
}

TEST(Methods, ASingleOneStandsBesideTheViewFrustum) {
  const auto json = json_of(summarise(one_frame(some_frame()), {}, "model.ply"))["methods"];
  ASSERT_EQ(json.size(), 3U);
  EXPECT_EQ(json[1]["method"], "automatic");
  WalkOptions undrawn;
  undrawn.render = false;
  const auto rows = json_of(summarise(one_frame(some_frame()), undrawn, "model.ply"))["methods"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_TRUE(rows[1]["speedup"].is_null() && rows[1]["false_culls"].is_null() && rows[1]["hidden_culled"].is_null());
}

TEST(Methods, BesideAWalkThatHoldsIsTheSameCulledInEachFrame) {
  WalkOptions held;
  held.hold = 2;
  held.cull.method = culler::Method::cover;
  ASSERT_EQ(options_beside(held).size(), 1U);
  const WalkOptions beside = options_beside(held).front();
  EXPECT_EQ(beside.hold, 0);
  EXPECT_EQ(beside.cull.method, culler::Method::cover);
  EXPECT_EQ(method_text(held), "joined shadows, held");
  EXPECT_EQ(method_text(beside), "joined shadows");
  // A fault of the walk beside is told, though it is by the same method.
  const WalkResult right = one_frame(some_frame());
  WalkResult wrong = right;
  wrong.frames[0].false_culls = 3;
  Summary summary = summarise(right, held, "model.ply");
  summary.methods = methods_of({{&held, &right}, {&beside, &wrong}}, true);
  EXPECT_NE(text_of(summary).find("by joined shadows: false culls 3"), std::string::npos) << text_of(summary);
}

TEST(Summary, TellsOfRegionsThatHold) {
  WalkResult result;
  result.regions = {{10, 8, {}, {}}, {13, 4, {}, {}}};
  // Frame 12 is not counted; 14 is held by the second region, 16 by none.
  const std::vector<std::pair<std::size_t, std::size_t>> frames{{10, 1}, {14, 2}, {16, 0}};
  for (const auto& [number, region] : frames) {
    FrameRecord frame = some_frame();
    frame.frame = number;
    frame.region = region;
    frame.cull_ms = static_cast<double>(number);
    result.frames.push_back(frame);
  }
  WalkOptions options;
  EXPECT_FALSE(json_of(summarise(result, options, "model.ply")).contains("held"));
  options.hold = 2.5;
  const Summary summary = summarise(result, options, "model.ply");
  const auto json = json_of(summary);
  EXPECT_EQ(json["options"]["hold"], 2.5);
  EXPECT_EQ(json["held"]["regions"], 2);
  EXPECT_EQ(json["held"]["frames_by_point"], 1);
  EXPECT_EQ(json["held"]["region_ms"], 6);
  EXPECT_EQ(json["held"]["between_ms"], 14);
  EXPECT_EQ(json["held"]["frames_a_region"], 3.5);
  EXPECT_NE(text_of(summary).find("held: 2 regions that reach 2.5 ahead, one for 3.5 frames; a region takes 6.00 ms, "
                                  "a frame between 14.00 ms; 1 of 3 frames by point"),
            std::string::npos)
      << text_of(summary);
  const std::string csv = frames_csv(result);
  EXPECT_NE(csv.find(",region,cull_processor_ms,frame_processor_ms,view_frustum_frame_processor_ms\n"), std::string::npos);
  EXPECT_NE(csv.find(",2,0.0000,0.0000,0.0000\n"), std::string::npos);
}

TEST(Summary, SaysThatTheMachineWasBusy) {
  FrameRecord record = some_frame();
  record.cull_ms = 2.1;
  record.cull_processor_ms = 2;
  WalkResult result = one_frame(record);
  result.load = 0.5;
  const auto busy = [&] {
    const Summary summary = summarise(result, {}, "model.ply");
    const auto note = json_of(summary)["busy"];
    EXPECT_EQ(note.is_null(), text_of(summary).find("busy") == std::string::npos) << text_of(summary);
    EXPECT_EQ(note.is_null(), page_of(summary, result).find("The machine was busy") == std::string::npos);
    return note.is_null() ? std::string() : note.get<std::string>();
  };
  EXPECT_EQ(busy(), "");
  result.frames[0].cull_ms = 3;
  EXPECT_EQ(
      busy(),
      "The machine was busy: culls by automatic took 1.50 times their processor time. Times by the clock are too long; "
      "those of the processor are nearer to the truth.");
  result.frames[0].cull_ms = 2;
  result.load = 1e6;
  EXPECT_TRUE(busy().starts_with("The machine was busy: 1000000.0 processes wanted to run on its ")) << busy();
  EXPECT_EQ(json_of(summarise(result, {}, "model.ply"))["mean"]["cull_processor_ms"], 2);
}

TEST(Methods, TheOthersHaveLeavesOfTheirOwn) {
  using culler::Method;
  WalkOptions options;
  for (const Method method : {Method::automatic, Method::frusta, Method::cover}) {
    options.cull.method = method;
    options.build.hierarchy.leaf_size = culler::leaf_size_for(method);
    const std::vector<WalkOptions> others = options_beside(options);
    ASSERT_EQ(others.size(), 2U);
    EXPECT_NE(others[0].cull.method, others[1].cull.method);
    for (const WalkOptions& other : others) {
      EXPECT_NE(other.cull.method, method);
      EXPECT_EQ(other.build.hierarchy.leaf_size, culler::leaf_size_for(other.cull.method));
    }
  }
  options.build.hierarchy.leaf_size = 7;
  for (const WalkOptions& other : options_beside(options)) EXPECT_EQ(other.build.hierarchy.leaf_size, 7U);
}

TEST(ModelText, SaysWhatWasRead) {
  culler::PolygonSoup soup;
  add_wall(soup, 4, -1, 1);
  add_wall(soup, 6, -1, 1);
  EXPECT_EQ(text_of_model("walls.ply", culler::Hierarchy::build(soup, {}), {}),
            "walls.ply: 2 polygons; 2 x 2 x 2 units, +z taken as up\n");
  const auto a = soup.add_vertex({0, 0, 0}), b = soup.add_vertex({0.125, 0, 0}), c = soup.add_vertex({0.375, 0, 0});
  soup.add_polygon(std::array{a, a, b, c});
  soup.add_polygon(std::array{a, a, a});
  const auto d = soup.add_vertex({1, 0, 0}), e = soup.add_vertex({0, 1, 0}), f = soup.add_vertex({0.125, 0.125, 0});
  soup.add_face(std::array{d, a, e, f});
  soup.see_through_from(0);
  EXPECT_EQ(text_of_model("walls.ply", culler::Hierarchy::build(soup, {}), {0.01, {0, 1, 0}}),
            "walls.ply: 5 polygons (1 drawn in pieces, 2 without area, 6 see-through); 6 x 2 x 2 centimetres, +y up\n");
}

TEST(Summary, CountsWhyHiddenPolygonsAreDrawn) {
  WalkResult result = one_frame(some_frame());
  EXPECT_TRUE(json_of(summarise(result, {}, "model.ply"))["missed"].is_null());
  culler::MissedReasons::Counts counts{.missed = 20};
  counts.reasons[static_cast<std::size_t>(culler::Missed::coarse_node)] = 5;
  counts.reasons[static_cast<std::size_t>(culler::Missed::not_chosen)] = 12;
  result.missed = {counts, counts};
  WalkOptions options;
  options.cull.method = culler::Method::frusta;
  const auto missed = json_of(summarise(result, options, "model.ply"))["missed"];
  EXPECT_EQ(missed["frames"], 2);
  EXPECT_EQ(missed["polygons"], 40);
  EXPECT_EQ(missed["asked"], 34);
  EXPECT_EQ(missed["coarse_node"], 10);
  EXPECT_EQ(missed["not_chosen"], 24);
  EXPECT_EQ(missed["straddling_box"], 0);
  EXPECT_FALSE(missed.contains("open_pixel")) << "a reason of frames by cover";
}

TEST(Summary, HasTheSpreadOverTheFrames) {
  WalkResult result = one_frame(some_frame());
  for (const std::size_t frame : {5U, 6U}) {
    result.frames.push_back(some_frame());
    result.frames.back().frame = frame;
    result.frames.back().frame_ms = 2.0 * static_cast<double>(frame);
    result.frames.back().cull_ms = 7 - static_cast<double>(frame);
  }
  const Summary summary = summarise(result, {}, "model.ply");
  const auto spread = json_of(summary)["spread"];
  EXPECT_EQ(spread["frame_ms"]["median"], 10);
  EXPECT_EQ(spread["frame_ms"]["worst"], 12);
  EXPECT_EQ(spread["frame_ms"]["worst_frame"], 6);
  EXPECT_EQ(spread["cull_ms"]["worst_frame"], 5);
  EXPECT_EQ(spread["speedup"]["median"], 1);
  EXPECT_NEAR(spread["speedup"]["percentile_95"].get<double>(), 1.9, 1e-12);
  EXPECT_NEAR(spread["speedup"]["worst"].get<double>(), 10.0 / 12, 1e-12);
  EXPECT_NE(text_of(summary).find("12.00 (frame 6)"), std::string::npos) << text_of(summary);
  EXPECT_NE(text_of(summary).find("-17 % (frame 6)"), std::string::npos) << text_of(summary);
  EXPECT_NE(page_of(summary, result).find("<td>9.00</td><td>10.00</td>"), std::string::npos) << "mean and median";
  EXPECT_NE(page_of(summary, result).find("<a href=\"#frame=6\">12.00 (frame 6)</a>"), std::string::npos);
}

/// Frames whose limit by polygons is 2.5, with these speedups.
WalkResult frames_of_speedups(const std::vector<double>& speedups) {
  WalkResult result;
  for (const double speedup : speedups) {
    result.frames.push_back(some_frame());
    result.frames.back().view_frustum_frame_ms = speedup * result.frames.back().frame_ms;
  }
  return result;
}

TEST(Summary, ASpeedupAboveItsLimitIsExplained) {
  const auto summary = [](const std::vector<double>& speedups) {
    return summarise(frames_of_speedups(speedups), {}, "model.ply");
  };
  const Summary below = summary({2, 2, 2, 2, 2, 2, 2}), noisy = summary({2, 3, 2, 4, 2, 3, 2}),
                above = summary({3, 3, 3, 4, 3, 3, 3}), few = summary({3, 3});
  EXPECT_EQ(limit_note(below), "");
  EXPECT_TRUE(json_of(below)["speedup_limit"]["exceeded"].is_null());
  EXPECT_NE(limit_note(noisy).find("within the noise"), std::string::npos);
  EXPECT_NE(limit_note(few).find("within the noise"), std::string::npos);
  EXPECT_EQ(json_of(noisy)["speedup_limit"]["exceeded"], "within_noise");
  EXPECT_NE(limit_note(above).find("took longer to draw"), std::string::npos);
  EXPECT_EQ(json_of(above)["speedup_limit"]["exceeded"], "beyond_noise");
  EXPECT_NE(text_of(above).find(limit_note(above)), std::string::npos);
  EXPECT_NE(page_of(above, one_frame(some_frame())).find(limit_note(above)), std::string::npos);
}

TEST(Summary, ThePaperStandsForItsOwnModel) {
  const Summary summary = summarise(one_frame(some_frame()), {}, "sponza.ply");
  EXPECT_NE(text_of(summary).find("the paper, its own model"), std::string::npos) << text_of(summary);
  EXPECT_NE(html_of(table2_of(summary)).find("the paper, its own model"), std::string::npos) << html_of(table2_of(summary));
}

TEST(Summary, APageWithoutPicturesDoesNotSayThatFramesWereDrawn) {
  WalkOptions options;
  const WalkResult result = one_frame(some_frame());
  const std::string drawn = page_of(summarise(result, options, "model.ply"), result);
  EXPECT_NE(drawn.find("Every frame was drawn with both methods"), std::string::npos) << drawn;
  options.render = false;
  const std::string page = page_of(summarise(result, options, "model.ply"), result);
  EXPECT_EQ(page.find("was drawn with"), std::string::npos) << page;
  EXPECT_EQ(page.find("item buffer"), std::string::npos) << page;
  EXPECT_NE(page.find("Nothing was drawn"), std::string::npos) << page;
}

TEST(Summary, WithoutPicturesWhatNeedsThemIsNull) {
  WalkOptions options;
  options.render = false;
  const auto json = json_of(summarise(one_frame({}), options, "model.ply"));
  EXPECT_TRUE(json["mean"]["hidden_polygons"].is_null());
  EXPECT_TRUE(json["speedup"].is_null());
  EXPECT_TRUE(json["spread"]["frame_ms"].is_null());
  EXPECT_TRUE(json["wrong_pixels"].is_null());
  const std::string table = html_of(table2_of(summarise(one_frame({}), options, "model.ply")));
  EXPECT_NE(table.find("<td>With occlusion culling</td><td>0</td><td>&ndash;</td>"), std::string::npos) << table;
}

}  // namespace walk_test
