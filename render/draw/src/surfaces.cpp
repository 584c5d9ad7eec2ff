// SPDX-License-Identifier: MIT
#include "surfaces.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

#include "model/bounds.h"

namespace occlude::render {
namespace {

using culler::SoupView;
using glm::dvec3;

// The cosine of the largest bend within a surface: 20 degrees.
constexpr double kSmooth = 0.94;

/// An edge between two places, of a polygon.
struct Edge {
  std::uint32_t low, high, polygon;
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// For each vertex the number of its place.
std::vector<std::uint32_t> places(std::span<const dvec3> vertices) {
  std::vector<std::uint32_t> order(vertices.size()), place(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t v) { return std::tuple(vertices[v].x, vertices[v].y, vertices[v].z); };
  std::ranges::sort(order, {}, key);
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i > 0 && key(order[i - 1]) == key(order[i]) ? place[order[i - 1]] : static_cast<std::uint32_t>(i);
  }
  return place;
}

std::vector<Edge> sorted_edges(SoupView soup) {
  const std::vector<std::uint32_t> place = places(soup.vertices);
  std::vector<Edge> edges;
  edges.reserve(soup.indices.size());
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = place[loop[i]], b = place[loop[(i + 1) % loop.size()]];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), p});
    }
  }
  std::ranges::sort(edges);
  return edges;
}

/// Pairs of neighbours, each both ways, sorted.
std::vector<std::pair<std::uint32_t, std::uint32_t>> smooth_neighbours(SoupView soup, const std::vector<dvec3>& normals) {
  const std::vector<Edge> edges = sorted_edges(soup);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const Edge &a = edges[i - 1], &b = edges[i];
    if (a.low != b.low || a.high != b.high) continue;
    if (std::fabs(glm::dot(normals[a.polygon], normals[b.polygon])) < kSmooth) continue;
    pairs.emplace_back(a.polygon, b.polygon);
    pairs.emplace_back(b.polygon, a.polygon);
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace

std::vector<dvec3> unit_normals(SoupView soup) {
  std::vector<dvec3> normals(soup.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const dvec3 sum = culler::doubled_area(soup, soup.loop(p));
    const double length = glm::length(sum);
    normals[p] = length > 0 && std::isfinite(length) ? sum / length : dvec3(0, 0, 0);
  }
  return normals;
}

std::vector<std::uint32_t> surfaces(SoupView soup, const std::vector<dvec3>& normals) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const auto pairs = smooth_neighbours(soup, normals);
  std::vector<std::uint32_t> surface(soup.size(), kNone), open;
  for (std::uint32_t start = 0; start < soup.size(); ++start) {
    if (surface[start] != kNone) continue;
    surface[start] = start;
    open.push_back(start);
    while (!open.empty()) {
      const std::uint32_t p = open.back();
      open.pop_back();
      const auto first = std::ranges::lower_bound(pairs, p, {}, &std::pair<std::uint32_t, std::uint32_t>::first);
      for (auto pair = first; pair != pairs.end() && pair->first == p; ++pair) {
        if (surface[pair->second] != kNone) continue;
        surface[pair->second] = start;
        open.push_back(pair->second);
      }
    }
  }
  return surface;
}

}  // namespace occlude::render
