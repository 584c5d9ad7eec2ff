// SPDX-License-Identifier: MIT
#include "tables.h"

#include <fmt/format.h>

#include <cmath>
#include <thread>

#include "occlude/render/machine.h"
#include "occlude/render/page.h"

namespace occlude::experiments {
namespace {

using render::grouped;

std::string one(double value) { return fmt::format("{:.1f}", value); }
/// With two decimals, and 0 without a sign.
std::string two(double value) { return fmt::format("{:.2f}", std::round(100 * value) / 100 + 0.0); }
std::string percent(double share) { return one(100 * share); }

template <class Format>
std::string if_known(const std::optional<double>& value, Format&& format) {
  return value ? format(*value) : "-";
}

/// Adds a note on the gain of a mix over area-angle alone, the paper's choice, at the paper's number of occluders.
void note_gain(const Figure4& figure, const char* mix, const char* about, Table& table) {
  const auto plain = share_at(figure, "area_angle", 8), mixed = share_at(figure, mix, 8);
  if (!plain || !mixed) return;
  table.notes.push_back(
      fmt::format("With 8 occluders {}: {:+.1f} percentage points over area-angle alone.", about, 100 * (*mixed - *plain)));
}

Table sweep_table(const std::string& title, const std::string& varied, const std::vector<SweepPoint>& points,
                  std::string (*name)(const SweepPoint&)) {
  Table table{
      title,
      {varied, "culled, %", "listed per frame", "entries", "preprocess, s", "cull, ms", "cull, ratio to the default"},
      {},
      {}};
  for (const SweepPoint& p : points) {
    table.rows.push_back({name(p), percent(p.culled_share), grouped(p.listed), grouped(static_cast<double>(p.entries)),
                          two(p.preprocess_s), two(p.cull_ms), two(p.cull_ratio)});
  }
  return table;
}

Table joined_table(const std::string& title, const std::string& varied, const std::vector<JoinedPoint>& points,
                   std::string (*name)(const JoinedPoint&)) {
  Table table{title, {varied, "culled, %", "drawn", "cull, ms"}, {}, {}};
  for (const JoinedPoint& p : points) {
    table.rows.push_back({name(p), percent(p.culled_share), grouped(p.drawn), two(p.cull_ms)});
  }
  return table;
}

}  // namespace

Table methods_table(const render::Methods& methods) {
  Table table{"Table 2 by every method, averages per frame",
              {"method", "polygons drawn", "of the hidden culled, %", "cull, ms", "worst cull, ms", "frame, ms",
               "frame, ratio to visible polygons only"},
              {},
              {}};
  const std::optional<double> least = methods.back().frame_ms;
  for (const render::MethodRow& m : methods) {
    const bool is_culled = m.worst_cull_ms > 0;
    table.rows.push_back({m.method, grouped(m.drawn), if_known(m.hidden_culled, percent), is_culled ? two(m.cull_ms) : "-",
                          is_culled ? two(m.worst_cull_ms) : "-", if_known(m.frame_ms, one),
                          m.frame_ms ? two(*m.frame_ms / *least) : "-"});
  }
  return table;
}

Table figure4_table(const Figure4& figure) {
  Table table{"Figure 4, % of the polygons in view culled, against the number of occluders", {"chosen by"}, {}, {}};
  for (const std::size_t n : kOccluders) table.head.push_back(std::to_string(n));
  table.head.emplace_back("knee");
  for (const Curve& curve : figure.curves) {
    table.rows.push_back({curve.about});
    for (const double share : curve.share) table.rows.back().push_back(percent(share));
    table.rows.back().push_back(std::to_string(curve.knee));
  }
  table.notes.emplace_back("Knee: the smallest number of occluders that culls 90 % of what 64 cull. The paper: about 8.");
  note_gain(figure, "area_angle_coherence", "area-angle and coherence (the default)", table);
  note_gain(figure, "all_three", "all three criteria", table);
  std::string lists = fmt::format("Lists of {} regions", grouped(static_cast<double>(figure.regions)));
  if (figure.sampling_s)
    lists += fmt::format("; depth complexity was sampled in a preprocess of {:.1f} s", *figure.sampling_s);
  table.notes.push_back(lists + ".");
  return table;
}

Table regions_table(const Sweeps& sweeps) {
  return sweep_table("Number of regions", "regions", sweeps.regions,
                     [](const SweepPoint& p) { return grouped(p.lists.regions); });
}

Table threshold_table(const Sweeps& sweeps) {
  return sweep_table("Threshold of the lists", "steradians", sweeps.threshold,
                     [](const SweepPoint& p) { return fmt::format("{:g}", p.lists.threshold); });
}

Table sort_table(const Sorting& sorting) {
  Table table{
      "Sort from the previous frame's order, per frame",
      {"threshold", "candidates", "arrivals", "moves", "moves/candidate", "comparisons/candidate", "from scratch/candidate"},
      {},
      {}};
  for (const SortPoint& p : sorting.points) {
    const auto each = [&](double total) { return p.candidates == 0 ? "-" : two(total / p.candidates); };
    table.rows.push_back({fmt::format("{:g}", p.threshold), one(p.candidates), one(p.arrivals), one(p.moves), each(p.moves),
                          each(p.comparisons), each(p.comparisons_anew)});
  }
  table.notes.push_back(
      fmt::format("Growth with the number of candidates, exponents: moves {}, comparisons {}, comparisons of sorting from "
                  "scratch {}; 1 is linear.",
                  if_known(sorting.moves_exponent, two), if_known(sorting.comparisons_exponent, two),
                  if_known(sorting.anew_exponent, two)));
  return table;
}

Table pictures_table(const Joined& joined) {
  return joined_table("Joined shadows, size of the coarse picture", "pixels", joined.pictures,
                      [](const JoinedPoint& p) { return fmt::format("{}x{}", p.width, p.height); });
}

Table leaves_table(const Joined& joined) {
  return joined_table("Joined shadows, size of the leaves", "polygons", joined.leaves,
                      [](const JoinedPoint& p) { return std::to_string(p.leaf); });
}

Table budgets_table(const Joined& joined) {
  return joined_table("Joined shadows, triangles drawn into the picture per frame, at most", "triangles", joined.budgets,
                      [](const JoinedPoint& p) { return std::to_string(p.triangles); });
}

Table threads_table(const std::vector<ThreadsPoint>& points) {
  Table table{"One cull by frusta on several threads",
              {"threads", "cull, ms by the clock", "times as fast as one", "that many culls at once", "empty call, us"},
              {},
              {}};
  for (const ThreadsPoint& p : points) {
    table.rows.push_back(
        {std::to_string(p.threads), fmt::format("{:.3f}", p.cull_ms), two(p.speedup), two(p.most_speedup), two(p.call_us)});
  }
  table.notes.emplace_back(
      "That many culls at once: each of a view of its own; how many times as fast as one after another. It is about the "
      "most that the processors allow. An empty call gives the threads nothing to do.");
  return table;
}

Table growth_table(const Growth& growth) {
  Table table{"Growth with the number of polygons, a city repeated",
              {"polygons", "in view", "drawn", "build, s", "cull, ms", "near view", "cull of it, ms", "peak bytes/polygon",
               "held bytes/polygon"},
              {},
              {}};
  for (const GrowthPoint& p : growth.points) {
    table.rows.push_back({grouped(static_cast<double>(p.polygons)), grouped(p.in_view), grouped(p.drawn), two(p.build_s),
                          two(p.cull_ms), grouped(p.near_in_view), two(p.near_cull_ms), if_known(p.peak_bytes, grouped),
                          if_known(p.held_bytes, grouped)});
  }
  table.notes.push_back(fmt::format("Exponents: build {}, cull {}, cull of the near view {}; 1 is linear.",
                                    if_known(growth.build_exponent, two), if_known(growth.cull_exponent, two),
                                    if_known(growth.near_cull_exponent, two)));
  table.notes.push_back(fmt::format("Near view: polygons in views that end {} from the eye.", kNearSight));
  table.notes.emplace_back(
      "Memory: resident, beyond the model itself; the peak of the build, and what the culler holds afterwards.");
  return table;
}

std::string conditions(const Options& options) {
  return fmt::format(
      "Times are medians of {} rounds, each of which measured everything once: builds on all threads by the clock, culling "
      "in processor time. Those of table 2 are means over the frames by the clock, with both methods on every frame in "
      "alternating order. {}, {} threads, {}.",
      options.repetitions, render::processor_name(), std::thread::hardware_concurrency(), render::compiler_name());
}

}  // namespace occlude::experiments
