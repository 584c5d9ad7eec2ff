// SPDX-License-Identifier: MIT
#include "tables.h"

#include <fmt/format.h>

#include <limits>

#include "occlude/render/machine.h"

namespace occlude::experiments {
namespace {

using render::grouped;
using render::if_known;
using render::percent;
using render::rounded;
using render::short_of;

std::string exponent(const std::optional<double>& value) { return value ? rounded(*value, 2) : "-"; }

/// Adds a note on the gain of a mix over area-angle alone, the paper's choice, at the paper's number of occluders.
void note_gain(const Figure4& figure, const char* mix, const char* about, Table& table) {
  const auto plain = share_at(figure, "area_angle", 8), mixed = share_at(figure, mix, 8);
  if (!plain || !mixed) return;
  table.notes.push_back(
      fmt::format("With 8 occluders {}: {:+.1f} percentage points over area-angle alone.", about, 100 * (*mixed - *plain)));
}

/// For people the first two columns are what varies.
Table sweep_table(const std::string& title, const char* regions, const char* threshold,
                  const std::vector<SweepPoint>& points) {
  Table table{title,
              {{regions, "regions"},
               {threshold, "threshold", short_of},
               {"culled", "culled_share", percent},
               {"listed per frame", "listed"},
               {"entries", "entries"},
               {"preprocess, s", "preprocess_s", rounded<2>},
               {"cull, ms", "cull_ms", rounded<2>},
               {"cull, ratio to the default", "cull_ratio", rounded<2>}},
              {}};
  for (const SweepPoint& p : points) {
    table.rows.push_back(
        {p.lists.regions, p.lists.threshold, p.culled_share, p.listed, p.entries, p.preprocess_s, p.cull_ms, p.cull_ratio});
  }
  return table;
}

/// For people the first three columns are what varies.
Table joined_table(const std::string& title, const char* size, const char* leaf, const char* budget,
                   const std::vector<JoinedPoint>& points) {
  Table table{title,
              {{size, "cover_size"},
               {leaf, "leaf"},
               {budget, "budget_ms", short_of},
               {"culled", "culled_share", percent},
               {"drawn", "drawn"},
               {"cull, ms", "cull_ms", rounded<2>}},
              {}};
  for (const JoinedPoint& p : points) {
    const bool is_limited = p.budget_ms < std::numeric_limits<double>::infinity();
    table.rows.push_back(
        {{p.width, p.height}, p.leaf, is_limited ? render::Cell(p.budget_ms) : nullptr, p.culled_share, p.drawn, p.cull_ms});
  }
  return table;
}

}  // namespace

Table figure4_table(const Figure4& figure) {
  Table table{"Figure 4, of the polygons in view culled, against the number of occluders", {{"chosen by"}}, {}};
  for (const std::size_t n : kOccluders) table.columns.push_back({std::to_string(n), "", percent});
  table.columns.push_back({"knee"});
  for (const Curve& curve : figure.curves) {
    table.rows.push_back({curve.about});
    for (const double share : curve.share) table.rows.back().push_back(share);
    table.rows.back().push_back(curve.knee);
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

Table regions_table(const Sweeps& sweeps) { return sweep_table("Number of regions", "regions", "", sweeps.regions); }

Table threshold_table(const Sweeps& sweeps) {
  return sweep_table("Threshold of the lists", "", "steradians", sweeps.threshold);
}

Table sort_table(const Sorting& sorting) {
  Table table{"Sort from the previous frame's order, per frame",
              {{"threshold", "threshold", short_of},
               {"candidates", "candidates", rounded<1>},
               {"arrivals", "arrivals", rounded<1>},
               {"moves", "moves", rounded<1>},
               {"", "comparisons"},
               {"", "comparisons_anew"},
               {"moves/candidate", "", rounded<2>},
               {"comparisons/candidate", "", rounded<2>},
               {"from scratch/candidate", "", rounded<2>}},
              {}};
  for (const SortPoint& p : sorting.points) {
    const auto each = [&](double total) {
      return p.candidates == 0 ? render::Cell(nullptr) : render::Cell(total / p.candidates);
    };
    table.rows.push_back({p.threshold, p.candidates, p.arrivals, p.moves, p.comparisons, p.comparisons_anew, each(p.moves),
                          each(p.comparisons), each(p.comparisons_anew)});
  }
  table.notes.push_back(fmt::format(
      "Growth with the number of candidates, exponents: moves {}, comparisons {}, comparisons of sorting from "
      "scratch {}; 1 is linear.",
      exponent(sorting.moves_exponent), exponent(sorting.comparisons_exponent), exponent(sorting.anew_exponent)));
  return table;
}

Table pictures_table(const Joined& joined) {
  return joined_table("Joined shadows, size of the coarse picture", "pixels", "", "", joined.pictures);
}

Table leaves_table(const Joined& joined) {
  return joined_table("Joined shadows, size of the leaves", "", "polygons", "", joined.leaves);
}

Table budgets_table(const Joined& joined) {
  return joined_table("Joined shadows, budget of a frame", "", "", "milliseconds", joined.budgets);
}

Table occluders_table(const Occluders& occluders) {
  Table table{"Simplified occluders, in a scene",
              {{"what hides", "chosen"},
               {"triangles", "triangles"},
               {"hidden", "hidden_share", percent},
               {"drawn into the picture", "cover_triangles"},
               {"cull, ms", "cull_ms", rounded<2>},
               {"cull, ratio to the first", "cull_ratio", rounded<2>}},
              {}};
  for (const OccludersPoint& p : occluders.points) {
    table.rows.push_back({p.chosen, p.triangles, p.hidden_share, p.cover_triangles, p.cull_ms, p.cull_ratio});
  }
  table.notes.push_back(
      fmt::format("Objects are {} leaves of a tree of the model. Hidden: of those in view. Triangles are chosen by how "
                  "large they look along "
                  "the path. Boxes are inside of closed parts, and hide nothing wrongly as long as no eye is in one.",
                  grouped(static_cast<double>(occluders.objects))));
  return table;
}

Table threads_table(const std::vector<ThreadsPoint>& points) {
  Table table{"One cull by frusta on several threads",
              {{"threads", "threads"},
               {"cull, ms by the clock", "cull_ms", rounded<3>},
               {"times as fast as one", "speedup", rounded<2>},
               {"that many culls at once", "most_speedup", rounded<2>},
               {"empty call, us", "call_us", rounded<2>}},
              {}};
  for (const ThreadsPoint& p : points) table.rows.push_back({p.threads, p.cull_ms, p.speedup, p.most_speedup, p.call_us});
  table.notes.emplace_back(
      "That many culls at once: each of a view of its own; how many times as fast as one after another. It is about the "
      "most that the processors allow. An empty call gives the threads nothing to do.");
  return table;
}

Table growth_table(const Growth& growth) {
  Table table{"Growth with the number of polygons, a city repeated",
              {{"polygons", "polygons"},
               {"in view", "in_view"},
               {"drawn", "drawn"},
               {"build, s", "build_s", rounded<2>},
               {"cull, ms", "cull_ms", rounded<2>},
               {"near view", "near_in_view"},
               {"cull of it, ms", "near_cull_ms", rounded<2>},
               {"peak bytes/polygon", "peak_bytes_per_polygon"},
               {"held bytes/polygon", "held_bytes_per_polygon"}},
              {}};
  for (const GrowthPoint& p : growth.points) {
    table.rows.push_back({p.polygons, p.in_view, p.drawn, p.build_s, p.cull_ms, p.near_in_view, p.near_cull_ms,
                          if_known(p.peak_bytes), if_known(p.held_bytes)});
  }
  table.notes.push_back(fmt::format("Exponents: build {}, cull {}, cull of the near view {}; 1 is linear.",
                                    exponent(growth.build_exponent), exponent(growth.cull_exponent),
                                    exponent(growth.near_cull_exponent)));
  table.notes.push_back(fmt::format("Near view: polygons in views that end {} from the eye.", kNearSight));
  table.notes.emplace_back(
      "Memory: resident, beyond the model itself; the peak of the build, and what the culler holds afterwards.");
  return table;
}

std::string conditions(const Options& options) {
  return fmt::format(
      "Times are medians of {} rounds, each of which measured everything once: builds on all threads by the clock, culling "
      "in processor time. Those of table 2 are means over the frames by the clock, with both methods on every frame in "
      "alternating order. {}.",
      options.repetitions, text_of(render::this_machine()));
}

}  // namespace occlude::experiments
