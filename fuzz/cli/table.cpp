// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <string>

#include "results.h"

namespace occlude::cli {
namespace {

using fuzz::Tally;

/// A share in per cent. Empty when nothing was asked.
std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "";
  const double share = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (part == 0) return "0";
  return share < 0.005 ? "<.01" : fmt::format("{:.{}f}", share, share < 10 ? 2 : 1);
}

/// Thousands of cases a second on one core.
std::string speed(const fuzz::Report& report) {
  if (report.core_seconds <= 0) return "";
  return fmt::format("{:.0f}", 1e-3 * static_cast<double>(report.tally.cases) / report.core_seconds);
}

constexpr std::string_view kHead =
    "                                        oracle's answer, %    % by |  OURS | cons. |     others wrong, %: culls and "
    "draws "
    "          | 1000/\n"
    "family                            cases inside partial    out exact | wrong | left% |     plain     |    float32    |  "
    "    FMA      |   s\n";

std::string line(const std::string& name, const fuzz::Report& report) {
  const Tally& t = report.tally;
  const std::uint64_t answered = t.cases - t.refused;
  const auto share = [&](std::uint64_t part) { return percent(part, answered); };
  const auto others = [&](const fuzz::WrongAnswers& wrong) {
    return fmt::format("{:>6} {:>6}", percent(wrong.culls, t.others_asked), percent(wrong.draws, t.others_asked));
  };
  return fmt::format("{:<29} {:>9} {:>6} {:>7} {:>6} {:>5} | {:>5} | {:>5} | {} | {} | {} | {:>4}\n", name, t.cases,
                     share(t.relations[0]), share(t.relations[1]), share(t.relations[2]), share(t.stages[1]),
                     t.disagreements, percent(t.undecided, t.planes_asked), others(t.plain), others(t.float32),
                     others(t.fused), speed(report));
}

constexpr std::string_view kLegend = R"(
A case asks whether a box is inside a shadow, partly in it or out of it (occludees: a polytope; view_frustum: in half-spaces; culler:
a polygon is culled by shadow, drawn, or culled by the view). Shares are of the cases that are legal; blank: nobody was asked.
by exact    what the floating-point filter of `certified` left to its exact stage; of culler, polygons of such frames
OURS wrong  cases (of culler, frames) in which we say what the oracle refutes, our two oracles differ, or a case file expects
            something else: 0, or it is a defect
cons. left  of the boxes out, those that the conservative test leaves partial, as it may: it asks planes alone
others      no part of the product: plain, the paper's double arithmetic; float32, the same in single precision; FMA, with fused
            multiply-adds. A wrong cull says inside of what is not: something visible would disappear. Any other wrong answer, a
            wrong draw, costs time
1000/s      thousands of cases a second, of one core
)";

std::string findings(const FuzzResults& results) {
  std::string text;
  for (const FuzzResults::Row& row : results.rows) {
    for (const fuzz::Finding& found : row.report.findings) {
      text += fmt::format("WRONG  {}, {}: {}: {}\n", found.family, found.seed, found.kind, found.what);
    }
  }
  return text.empty() ? text : text + fmt::format("(of a row the first {}, at most)\n", fuzz::kKeptFindings);
}

}  // namespace

std::string table(const FuzzResults& results) {
  std::string text(kHead);
  for (const FuzzResults::Row& row : results.rows) text += line(row.name, row.report);
  const fuzz::Report sum = total(results);
  if (results.rows.size() > 1) text += fmt::format("\n{}{}", kHead, line("all", sum));
  text += kLegend;
  const Tally& all = sum.tally;
  text += fmt::format(
      "\n{}{} cases not legal, refused by us and by the oracle; {} judged by the second oracle as well; {} lines of sight\n",
      results.seed ? fmt::format("seed {}; ", *results.seed) : "", all.refused, all.judged_twice, all.lines_of_sight);
  text += findings(results);
  return text + fmt::format("{} wrong in {} cases\n", all.disagreements, all.cases);
}

}  // namespace occlude::cli
