// SPDX-License-Identifier: MIT
#include "occlude/render/chart.h"

#include <gtest/gtest.h>

namespace chart_test {

using namespace occlude::render;

TEST(Chart, PlacesPowersAtEqualDistances) {
  const std::string svg =
      line_chart({"n", Scale::logarithmic}, {"ms", Scale::logarithmic}, {1, 10, 100}, {{"a", "red", {2, 20, 200}}});
  // 830 wide from 86; the middle of both axes is the middle of the drawing.
  EXPECT_NE(svg.find(R"(<circle cx="501.0")"), std::string::npos) << svg;
  EXPECT_NE(svg.find(">100</text>"), std::string::npos);
}

TEST(Chart, LabelsDoNotMeet) {
  const std::string svg = line_chart({"n", Scale::logarithmic}, {"ms", Scale::logarithmic}, {1000, 10'000'000, 11'000'000},
                                     {{"a", "red", {2, 3, 4}}});
  EXPECT_NE(svg.find(">10,000,000</text>"), std::string::npos);
  EXPECT_EQ(svg.find(">11,000,000</text>"), std::string::npos) << "no room";
}

TEST(Chart, LinearAxisBeginsAtZero) {
  const std::string svg = line_chart({"frame"}, {"polygons"}, {0, 1, 2}, {{"a", "red", {4000, 5000, 6000}}});
  EXPECT_NE(svg.find(">0</text>"), std::string::npos);
  EXPECT_NE(svg.find(">6,000</text>"), std::string::npos) << svg;
  EXPECT_EQ(svg.find("<circle"), std::string::npos);
}

TEST(Chart, LegendTakesAsManyRowsAsItNeeds) {
  const std::vector<Series> few(2, {"a name", "red", {1, 2}}), many(12, {"a rather long name of a series", "red", {1, 2}});
  const auto height = [](const std::string& svg) { return std::stod(svg.substr(svg.find("0 0 960 ") + 8)); };
  EXPECT_GT(height(line_chart({"x"}, {"y"}, {0, 1}, many)), height(line_chart({"x"}, {"y"}, {0, 1}, few)));
}

}  // namespace chart_test
