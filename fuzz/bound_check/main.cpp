// SPDX-License-Identifier: MIT
// Checks that the error bounds of the kernel and the culler hold: recomputes their constants by following roundings, and
// measures the true errors of their values against exact numbers. Usage: bound_check [CASES], where CASES is the number of
// cases per family for the kernel, and per bound for the culler.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "measure.h"
#include "measure_culler.h"
#include "ranges.h"
#include "recompute.h"

namespace {

using namespace occlude::bound_check;

constexpr int kCases = 2000;
constexpr std::uint64_t kSeed = 20263;

template <class Number>
bool read_positive(const char* text, Number& number) {
  const char* const end = text + std::strlen(text);
  const auto [next, error] = std::from_chars(text, end, number);
  return error == std::errc() && next == end && number > 0;
}

bool report_constants(const std::vector<Constant>& constants) {
  bool all_hold = true;
  std::printf("%-29s %-42s %-7s %10s %10s %10s\n", "constant", "needed by", "unit", "recomputed", "stated", "ratio");
  for (const auto& [name, where, needed, stated, degree, bits] : constants) {
    const bool holds = needed <= stated;
    const std::string unit = "2^-" + std::to_string(degree * bits);
    const Exact size(std::ldexp(1.0, -degree * bits));
    const auto in_units = [&](const Exact& x) { return CGAL::to_double(Exact(x / size)); };
    std::printf("%-29s %-42s %-7s %10.6f %10.6f %10.2f%s\n", name.c_str(), where.c_str(), unit.c_str(), in_units(needed),
                in_units(stated), CGAL::to_double(Exact(stated / needed)), holds ? "" : "  TOO SMALL");
    all_hold = all_hold && holds;
  }
  std::printf("\n");
  return all_hold;
}

bool report_ranges() {
  bool all_safe = true;
  std::printf("exponents of two  %-32s %12s %12s %12s\n", "", "multiples of", "at most", "errors from");
  for (const auto& [name, extent] : ranges()) {
    std::printf("%-50s %12.1f %12.1f %12.1f%s\n", name.c_str(), extent.unit, extent.top, extent.error,
                extent.is_safe() ? "" : "  OUT OF RANGE");
    all_safe = all_safe && extent.is_safe();
  }
  return all_safe;
}

/// Most of the `cases` must be legal, because cases that are not measured prove nothing.
bool report_shares(const std::string& name, const Shares& shares, int cases) {
  std::printf("%-30s %7d", name.c_str(), shares.legal_cases);
  for (const double share : shares.largest) std::printf(" %9.3f", share);
  const bool all_hold = std::all_of(shares.largest.begin(), shares.largest.end(), [](double share) { return share <= 1; });
  const bool are_most = shares.legal_cases > cases / 2;
  std::printf("%s%s\n", all_hold ? "" : "  BEYOND ITS BOUND", are_most ? "" : "  MOSTLY NOT LEGAL");
  return all_hold && are_most;
}

bool report_errors(int cases, std::uint64_t seed) {
  std::printf("\n|value - true value| / bound, the largest of %d cases a family, seed %llu\n", cases,
              static_cast<unsigned long long>(seed));
  std::printf("%-30s %7s", "family", "legal");
  for (const auto name : kKindNames) std::printf(" %9s", std::string(name).c_str());
  std::printf("\n");
  Shares all;
  bool all_hold = true;
  for (const auto family : occlude::fuzz::families()) {
    const Shares shares = measure(family, cases, seed);
    all_hold = report_shares(std::string(occlude::fuzz::name(family)), shares, cases) && all_hold;
    all.include(shares);
  }
  report_shares("all", all, cases);
  return all_hold;
}

/// No share may be above 1, and nothing may be left unmeasured.
bool report_measured(const std::vector<Measured>& all) {
  bool all_hold = true;
  for (const auto& [bound, where, largest, cases] : all) {
    const bool holds = largest <= 1, is_measured = cases > 0;
    std::printf("%-45s %-18s %9.3f %9d%s%s\n", bound.c_str(), where.c_str(), largest, cases,
                holds ? "" : "  BEYOND ITS BOUND", is_measured ? "" : "  NOT MEASURED");
    all_hold = all_hold && holds && is_measured;
  }
  return all_hold;
}

bool report_culler(int cases, std::uint64_t seed) {
  std::printf("\n%-45s %-18s %9s %9s\n", "bound", "stands in", "share", "cases");
  bool all_hold = true;
  for (const auto& measure : {measure_picture, measure_edges, measure_boxes, measure_cameras, measure_margins}) {
    all_hold = report_measured(measure(cases, seed)) && all_hold;
  }
  return all_hold;
}

}  // namespace

int main(int argc, char** argv) {
  int cases = kCases;
  std::uint64_t seed = kSeed;
  const char* const requested = std::getenv("OCCLUDE_SEED");
  if (argc > 2 || (argc > 1 && !read_positive(argv[1], cases)) || (requested && !read_positive(requested, seed))) {
    std::fprintf(stderr, "usage: [OCCLUDE_SEED=N] bound_check [CASES]: whole numbers above 0\n");
    return 2;
  }
  const bool constants_hold = report_constants(recomputed_constants()), ranges_hold = report_ranges(),
             culler_constants_hold = report_constants(recomputed_culler_constants());
  const bool culler_holds = report_culler(cases, seed), errors_hold = report_errors(cases, seed);
  return constants_hold && culler_constants_hold && ranges_hold && culler_holds && errors_hold ? EXIT_SUCCESS : EXIT_FAILURE;
}
