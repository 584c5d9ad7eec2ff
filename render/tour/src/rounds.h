// SPDX-License-Identifier: MIT
// Ways through a graph of places: the shortest, and rounds that see as much as they can.
//
// A Graph has size(), kMostCost, and for_each_next(place, visit), which calls visit(next, cost) with 0 < cost <= kMostCost.
// Costs are the same in both directions. Whole numbers make the ways the same on every machine.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "occlude/culler/executor.h"

namespace occlude::render {

inline constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();

/// The places of a graph of distances in tenths that may be used, each with a weight. A step between two costs its length
/// times the sum of theirs.
template <class Graph>
class Weighted {
 public:
  static constexpr std::uint32_t kCheapest = 2, kDearest = 16;
  static constexpr std::uint32_t kMostCost = Graph::kMostCost * 2 * kDearest;
  static constexpr double kCostOfWhole = 10 * 2 * kCheapest;  ///< of ten tenths, at the cheapest

  /// None may be used. The graph must outlive the object.
  explicit Weighted(const Graph& graph) : graph_(graph), weight_(graph.size()) {}

  /// Lets the place be used. It is from 0 to 1 dear.
  void allow(std::uint32_t place, double dear) {
    weight_[place] = static_cast<std::uint8_t>(kCheapest + std::lround((kDearest - kCheapest) * dear));
  }

  [[nodiscard]] std::size_t size() const { return weight_.size(); }
  [[nodiscard]] bool has(std::uint32_t place) const { return weight_[place] != 0; }

  template <class Visit>
  void for_each_next(std::uint32_t place, Visit&& visit) const {
    graph_.for_each_next(place, [&](std::uint32_t next, std::uint32_t tenths) {
      if (has(next)) visit(next, tenths * (weight_[place] + weight_[next]));
    });
  }

 private:
  const Graph& graph_;
  std::vector<std::uint8_t> weight_;  ///< 0 of places that may not be used
};

/// The least cost from any of `from` to each place, by Dial's algorithm; kUnreached where there is no way.
template <class Graph>
std::vector<std::uint32_t> costs(const Graph& graph, std::span<const std::uint32_t> from,
                                 const culler::Checkpoint& checkpoint) {
  std::vector<std::uint32_t> cost(graph.size(), kUnreached);
  // Places with cost c wait in bucket c modulo kMostCost + 1; no two costs of those that wait differ by more.
  std::array<std::vector<std::uint32_t>, Graph::kMostCost + 1> waiting;
  for (const std::uint32_t place : from) cost[place] = 0;
  waiting[0].assign(from.begin(), from.end());
  std::size_t left = from.size();
  for (std::uint32_t now = 0; left > 0; ++now) {
    std::vector<std::uint32_t>& bucket = waiting[now % waiting.size()];
    checkpoint.at(now);
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      const std::uint32_t place = bucket[i];
      if (cost[place] != now) continue;
      graph.for_each_next(place, [&](std::uint32_t next, std::uint32_t step) {
        if (now + step >= cost[next]) return;
        cost[next] = now + step;
        waiting[cost[next] % waiting.size()].push_back(next);
        ++left;
      });
    }
    left -= bucket.size();
    bucket.clear();
  }
  return cost;
}

/// The cheapest way to `to` from where `cost` is 0, both included. REQUIRES: `to` is reached.
template <class Graph>
std::vector<std::uint32_t> way(const Graph& graph, const std::vector<std::uint32_t>& cost, std::uint32_t to) {
  std::vector<std::uint32_t> places{to};
  while (cost[to] > 0) {
    std::uint32_t before = to;
    graph.for_each_next(to, [&](std::uint32_t next, std::uint32_t step) {
      if (cost[next] != kUnreached && cost[next] + step == cost[to] && before == to) before = next;
    });
    places.push_back(to = before);
  }
  std::reverse(places.begin(), places.end());
  return places;
}

/// A way that grows by stops: first the ends that are given, then always the place that is farthest from all stops, in
/// proportion to how interesting it is, inserted where that costs least.
template <class Graph>
class Rounds {
 public:
  /// Begins at `start`, and may grow at both ends. With `is_closed` it comes back there.
  Rounds(const Graph& graph, std::uint32_t start, bool is_closed, const culler::Checkpoint& checkpoint)
      : graph_(graph), checkpoint_(checkpoint), is_closed_(is_closed) {
    insert(start, 0, 0);
    if (is_closed) order_.push_back(0);
  }

  /// Adds stops among the candidates, up to `stops` in all, while the way costs no more than `budget` and each is at least
  /// `apart` from the others. interest(place) is from 0 to 1.
  template <class Interest>
  void grow(std::span<const std::uint32_t> candidates, Interest&& interest, std::size_t stops, std::uint64_t budget,
            std::uint32_t apart) {
    while (stops_.size() < stops) {
      double best_value = 0;
      std::uint32_t best = 0;
      Insertion best_insertion;
      for (const std::uint32_t place : candidates) {
        const std::uint32_t far = distance(place);
        if (far == kUnreached || far < apart) continue;
        const double value = far * interest(place);
        if (value <= best_value) continue;
        const Insertion insertion = cheapest(place);
        if (total_ + insertion.cost > budget) continue;
        best_value = value;
        best = place;
        best_insertion = insertion;
      }
      if (best_value == 0) return;
      insert(best, best_insertion.at, best_insertion.cost);
    }
  }

  [[nodiscard]] std::size_t stops() const { return stops_.size(); }

  /// All places on the way.
  [[nodiscard]] std::vector<std::uint32_t> places() const {
    std::vector<std::uint32_t> result{stops_[order_[0]].place};
    for (std::size_t i = 0; i + 1 < order_.size(); ++i) {
      const std::vector<std::uint32_t> leg = way(graph_, stops_[order_[i]].cost, stops_[order_[i + 1]].place);
      result.insert(result.end(), leg.begin() + 1, leg.end());
    }
    return result;
  }

 private:
  struct Stop {
    std::uint32_t place;
    std::vector<std::uint32_t> cost;
  };
  struct Insertion {
    std::size_t at = 0;
    std::uint64_t cost = std::numeric_limits<std::uint64_t>::max();
  };

  [[nodiscard]] std::uint32_t distance(std::uint32_t place) const {
    std::uint32_t least = kUnreached;
    for (const Stop& stop : stops_) least = std::min(least, stop.cost[place]);
    return least;
  }

  [[nodiscard]] Insertion cheapest(std::uint32_t place) const {
    Insertion best;
    const auto consider = [&](std::size_t at, std::uint64_t cost) {
      if (cost < best.cost) best = {at, cost};
    };
    const auto cost = [&](std::size_t i) { return std::uint64_t{stops_[order_[i]].cost[place]}; };
    for (std::size_t i = 0; i + 1 < order_.size(); ++i) {
      consider(i + 1, cost(i) + cost(i + 1) - stops_[order_[i]].cost[stops_[order_[i + 1]].place]);
    }
    if (!is_closed_) {
      consider(0, cost(0));
      consider(order_.size(), cost(order_.size() - 1));
    }
    return best;
  }

  void insert(std::uint32_t place, std::size_t at, std::uint64_t cost) {
    order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(at), stops_.size());
    stops_.push_back({place, costs(graph_, std::array{place}, checkpoint_)});
    total_ += cost;
  }

  const Graph& graph_;
  const culler::Checkpoint& checkpoint_;
  bool is_closed_;
  std::vector<Stop> stops_;
  std::vector<std::size_t> order_;
  std::uint64_t total_ = 0;
};

}  // namespace occlude::render
