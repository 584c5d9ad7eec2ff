// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>

#include "experiments.h"
#include "occlude/render/chart.h"
#include "occlude/render/page.h"
#include "occlude/render/paper_report.h"
#include "occlude/render/summary.h"
#include "tables.h"

namespace occlude::experiments {
namespace {

using render::html_of;
using render::line_chart;
using render::Scale;
using render::section;
using render::Series;

/// Colours that the colour-blind can distinguish (Okabe and Ito 2008); they also differ in lightness.
constexpr std::array kColours{"currentColor", "#e69f00", "#56b4e9", "#009e73", "#d55e00", "#0072b2", "#cc79a7", "#8a94a3"};
constexpr const char *kMain = "#1565c0", *kOther = "#d9822b", *kThird = "#5f6b7a";

std::string figure(const std::string& chart) { return "<figure>" + chart + "</figure>"; }

std::string table2_section(const Result& result, const Options& options) {
  return section("Averages (the paper's table 2)", html_of(table2_of(*result.table2))) +
         section("By every method", html_of(table_of(result.table2->methods))) +
         render::figures_html(result.walked, options.walk.render);
}

std::string figure4_section(const Figure4& figure4) {
  std::vector<double> x(kOccluders.begin(), kOccluders.end());
  std::vector<Series> curves;
  for (const Curve& curve : figure4.curves) {
    curves.push_back({curve.about, kColours[curves.size()], {}});
    for (const double share : curve.share) curves.back().y.push_back(100 * share);
  }
  return section(
      "Polygons culled against the number of occluders (the paper's figure 4)",
      figure(line_chart({"occluders", Scale::logarithmic}, {"% of the polygons in view culled"}, x, curves, 400)) +
          html_of(figure4_table(figure4)));
}

/// The values of a member of the points.
template <class Point, class Member>
std::vector<double> values(const std::vector<Point>& points, Member&& member) {
  std::vector<double> result;
  for (const Point& point : points) result.push_back(static_cast<double>(member(point)));
  return result;
}

std::string sweep_figures(const std::string& varied, const std::vector<double>& x, const std::vector<SweepPoint>& points) {
  const auto culled = values(points, [](const SweepPoint& p) { return 100 * p.culled_share; });
  const auto cull_ms = values(points, [](const SweepPoint& p) { return p.cull_ms; });
  const auto preprocess_s = values(points, [](const SweepPoint& p) { return p.preprocess_s; });
  const render::Axis along{varied, Scale::logarithmic};
  return figure(line_chart(along, {"% of the polygons in view"}, x, {{"culled", kMain, culled}})) +
         figure(line_chart(along, {"milliseconds; seconds"}, x,
                           {{"culling a frame, ms", kMain, cull_ms}, {"preprocess, s", kOther, preprocess_s}}));
}

std::string sweeps_section(const Sweeps& sweeps) {
  const auto regions = values(sweeps.regions, [](const SweepPoint& p) { return p.lists.regions; });
  const auto thresholds = values(sweeps.threshold, [](const SweepPoint& p) { return p.lists.threshold; });
  const Table by_regions = regions_table(sweeps), by_threshold = threshold_table(sweeps);
  return section(by_regions.title, sweep_figures("regions", regions, sweeps.regions) + html_of(by_regions)) +
         section(by_threshold.title, sweep_figures("steradians", thresholds, sweeps.threshold) + html_of(by_threshold));
}

std::string joined_figures(const render::Axis& along, const std::vector<double>& x, const std::vector<JoinedPoint>& points) {
  const auto culled = values(points, [](const JoinedPoint& p) { return 100 * p.culled_share; });
  const auto cull_ms = values(points, [](const JoinedPoint& p) { return p.cull_ms; });
  return figure(line_chart(along, {"% of the polygons in view"}, x, {{"culled", kMain, culled}})) +
         figure(line_chart(along, {"milliseconds"}, x, {{"culling a frame", kMain, cull_ms}}));
}

std::string joined_section(const Joined& joined) {
  const auto widths = values(joined.pictures, [](const JoinedPoint& p) { return p.width; });
  const auto leaves = values(joined.leaves, [](const JoinedPoint& p) { return p.leaf; });
  const auto budgets = values(joined.budgets, [](const JoinedPoint& p) { return p.budget_ms; });
  const Table by_picture = pictures_table(joined), by_leaf = leaves_table(joined), by_budget = budgets_table(joined);
  return section(by_picture.title,
                 joined_figures({"pixels across", Scale::logarithmic}, widths, joined.pictures) + html_of(by_picture)) +
         section(by_leaf.title,
                 joined_figures({"polygons a leaf", Scale::logarithmic}, leaves, joined.leaves) + html_of(by_leaf)) +
         section(by_budget.title,
                 joined_figures({"milliseconds", Scale::logarithmic}, budgets, joined.budgets) + html_of(by_budget));
}

std::string sort_section(const Sorting& sorting) { return section(sort_table(sorting)); }

std::string growth_section(const Growth& growth) {
  const auto polygons = values(growth.points, [](const GrowthPoint& p) { return p.polygons; });
  const auto build_ms = values(growth.points, [](const GrowthPoint& p) { return 1000 * p.build_s; });
  const auto cull_ms = values(growth.points, [](const GrowthPoint& p) { return p.cull_ms; });
  const auto near_ms = values(growth.points, [](const GrowthPoint& p) { return p.near_cull_ms; });
  const Table table = growth_table(growth);
  return section(
      table.title,
      figure(line_chart(
          {"polygons", Scale::logarithmic}, {"milliseconds", Scale::logarithmic}, polygons,
          {{"build", kOther, build_ms}, {"cull a frame", kMain, cull_ms}, {"cull a near view", kThird, near_ms}})) +
          html_of(table));
}

}  // namespace

std::string report_sections(const Result& result, const Options& options) {
  std::string html;
  if (result.table2) html += table2_section(result, options);
  if (result.figure4) html += figure4_section(*result.figure4);
  if (result.sweeps) html += sweeps_section(*result.sweeps);
  if (result.sort) html += sort_section(*result.sort);
  if (result.joined) html += joined_section(*result.joined);
  if (result.occluders) html += section(occluders_table(*result.occluders));
  if (!result.threads.empty()) html += section(threads_table(result.threads));
  if (result.growth) html += growth_section(*result.growth);
  return html + section("Conditions", R"(<p class="soft">)" + render::escaped(conditions(options)) + "</p>");
}

std::string report_html(const Result& result, const Options& options) {
  const std::string model = render::escaped(result.model);
  const std::string title = fmt::format(
      R"(<h1>The culler on {}</h1><p class="lead">{} polygons, {} frames, {} to {}; after Hudson et al. 1997, section 6.3.</p>)",
      model, render::grouped(static_cast<double>(result.polygons)), result.frames, result.first_frame, result.last_frame);
  return render::page("occlude: the culler on " + model, title + report_sections(result, options));
}

}  // namespace occlude::experiments
