// SPDX-License-Identifier: MIT
#include "table1.h"

#include <algorithm>
#include <array>

#include "occlude/kernel/overlap.h"

namespace occlude::bench {
namespace {

using kernel::Operations;

constexpr std::array kKinds{&Operations::dot, &Operations::scalar, &Operations::vector, &Operations::cross};

void widen(Cost& cost, const Operations& counted) {
  for (const auto kind : kKinds) {
    cost.worst.*kind = std::max(cost.worst.*kind, counted.*kind);
    cost.best.*kind = std::min(cost.best.*kind, counted.*kind);
  }
}

template <class Count>
Cost search(std::string test, std::span<const Workload> workloads, Count&& count) {
  const Operations first = count(workloads.front().frustum, workloads.front().boxes.front());
  Cost cost{std::move(test), first, first};
  for (const Workload& workload : workloads) {
    for (const kernel::Aabb& box : workload.boxes) widen(cost, count(workload.frustum, box));
  }
  return cost;
}

}  // namespace

std::vector<Cost> paper_costs() {
  return {
      {"naive_far_plane", {.dot = 270, .scalar = 216, .vector = 1080, .cross = 432}, {.dot = 8}},
      {"naive_no_far_plane", {.dot = 216, .scalar = 168, .vector = 600, .cross = 336}, {.dot = 8}},
      {"specialised_far_plane", {.dot = 294, .scalar = 144, .vector = 144}, {.dot = 4}},
      {"specialised_no_far_plane", {.dot = 240, .scalar = 144, .vector = 132}, {.dot = 4}},
  };
}

std::vector<Cost> measured_costs(std::span<const Workload> workloads) {
  const auto measured = [&](const char* name, kernel::Arithmetic arithmetic, kernel::Test test) {
    return search(name, workloads, [&](const auto& frustum, const auto& box) {
      return kernel::count_operations(frustum, box, arithmetic, test);
    });
  };
  using kernel::Arithmetic;
  using kernel::Test;
  return {measured("overlap_plain", Arithmetic::plain, Test::overlap),
          measured("overlap_certified", Arithmetic::certified, Test::overlap),
          measured("conservative_plain", Arithmetic::plain, Test::conservative),
          measured("conservative_certified", Arithmetic::certified, Test::conservative)};
}

}  // namespace occlude::bench
