// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "results.h"

namespace occlude::cli {
namespace {

using fuzz::Tally;

/// A share in per cent, three digits that matter; "-" for none at all.
std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (part == 0 || whole == 0) return "-";
  const double share = 100 * static_cast<double>(part) / static_cast<double>(whole);
  return share >= 10     ? fmt::format("{:.1f}", share)
         : share >= 0.01 ? fmt::format("{:.2f}", share)
                         : fmt::format("{:.0e}", share);
}

constexpr std::string_view kHead =
    "                                        the right answer, %   by |       | con- |   plain     |   float32   |    FMA   "
    "   | 1000\n"
    "family                            cases inside partial  out exact | wrong | serv.| culls draws | culls draws | culls "
    "draws |  /s\n";

/// Thousands of cases a second and core.
std::string speed(const fuzz::Report& report) {
  if (report.core_seconds <= 0) return "-";
  return fmt::format("{:.0f}", 1e-3 * static_cast<double>(report.tally.cases) / report.core_seconds);
}

std::string line(const std::string& name, const fuzz::Report& report) {
  const Tally& t = report.tally;
  const std::uint64_t answered = t.cases - t.refused;
  const auto share = [&](std::uint64_t part) { return percent(part, answered); };
  return fmt::format(
      "{:<29} {:>9} {:>6} {:>7} {:>5} {:>5} | {:>5} | {:>4} | {:>5} {:>5} | {:>5} {:>5} | {:>5} {:>5} | {:>4}\n", name,
      t.cases, share(t.relations[0]), share(t.relations[1]), share(t.relations[2]), share(t.stages[1]), t.disagreements,
      percent(t.undecided, t.relations[2]), share(t.plain.culls), share(t.plain.draws), share(t.float32.culls),
      share(t.float32.draws), share(t.fused.culls), share(t.fused.draws), speed(report));
}

constexpr std::string_view kLegend = R"(
A case asks whether a box is inside a shadow, partly in it or out of it; the exact oracle knows. All but cases, wrong and 1000/s
is in per cent of the answered cases, "-" is none.
by exact  the share that needed certified's exact stage; the floating-point filter decided the rest
wrong     cases on which certified, conservative, a batch or the culler is not what the oracle proves: 0, or a defect of ours
conserv.  of the boxes outside, the share that the conservative test leaves partial, as it may
plain     the paper's double arithmetic; float32: the same in single precision; FMA: with fused multiply-adds
culls     it says "inside" of what is not: something visible would disappear; draws: any other wrong answer: time lost
1000/s    thousands of cases a second, of one core
)";

std::string findings(const FuzzResults& results) {
  std::string text;
  for (const FuzzResults::Row& row : results.rows) {
    for (const fuzz::Finding& found : row.report.findings) {
      text += fmt::format("{}, seed {}: {}\n", found.family, found.seed, found.what);
    }
  }
  return text;
}

}  // namespace

std::string table(const FuzzResults& results) {
  std::string text(kHead);
  for (const FuzzResults::Row& row : results.rows) text += line(row.name, row.report);
  const fuzz::Report sum = total(results);
  const Tally& all = sum.tally;
  text += line("all", sum);
  text += kLegend;
  text += findings(results);
  text += fmt::format("\n{} cases, {} refused by both sides, {} judged by the second oracle as well; {} wrong\n", all.cases,
                      all.refused, all.judged_twice, all.disagreements);
  text += fmt::format("seed {}\n", results.seed);
  return text;
}

}  // namespace occlude::cli
