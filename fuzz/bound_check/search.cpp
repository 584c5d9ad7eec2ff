// SPDX-License-Identifier: MIT
#include "search.h"

#include <algorithm>

namespace occlude::bound_check {
namespace {

/// Each random case is changed so often. Many beginnings find more than long searches do.
constexpr int kSteps = 60;

/// Makes one choice anew, or moves it a little.
void change(std::vector<double>& chosen, fuzz::Random& random) {
  double& x = chosen[random.index(chosen.size())];
  if (random.chance(0.5)) {
    x = random.real(0, 1);
  } else {
    x = std::clamp(x + (random.chance(0.5) ? 1 : -1) * std::exp2(random.real(-50, -1)), 0.0, std::nextafter(1.0, 0.0));
  }
}

}  // namespace

Measured search(const std::string& bound, const std::string& where, int cases, std::uint64_t seed, const Measure& measure) {
  Measured found{bound, where};
  fuzz::Random random(seed);
  std::vector<double> best;
  double most = 0;
  for (int i = 0; i < cases; ++i) {
    if (i % kSteps == 0) best.clear();
    std::vector<double> tried = best;
    if (!tried.empty()) change(tried, random);
    Choices choices(tried, random);
    const std::optional<double> share = measure(choices);
    if (!share) continue;
    ++found.cases;
    found.largest = std::max(found.largest, *share);
    if (best.empty() || *share >= most) {
      best = tried;
      most = *share;
    }
  }
  return found;
}

}  // namespace occlude::bound_check
