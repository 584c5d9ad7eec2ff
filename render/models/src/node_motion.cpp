// SPDX-License-Identifier: MIT
#include "node_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "gltf_transform.h"
#include "occlude/render/errors.h"
#include "path_readers.h"

namespace occlude::render {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

dvec3 mix(const dvec3& a, const dvec3& b, double t) { return (1 - t) * a + t * b; }

/// Along the shorter arc.
dvec4 mix(const dvec4& a, const dvec4& from, double t) {
  double cosine = glm::dot(a, from) / std::sqrt(glm::dot(a, a) * glm::dot(from, from));
  const dvec4 b = cosine < 0 ? -from : from;
  cosine = std::min(std::fabs(cosine), 1.0);
  const double angle = std::acos(cosine);
  // The sine of less than this is the angle, to the last bit; the chord is then the arc.
  if (!(angle > 0x1p-26)) return (1 - t) * a + t * b;
  return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

template <class V>
V at(const Track<V>& track, double time, const V& otherwise) {
  if (track.empty()) return otherwise;
  const bool is_cubic = track.between == Between::cubic;
  const auto value = [&](std::size_t i) { return is_cubic ? track.values[3 * i + 1] : track.values[i]; };
  const auto next = static_cast<std::size_t>(std::ranges::upper_bound(track.times, time) - track.times.begin());
  if (next == 0) return value(0);
  if (next == track.times.size() || track.between == Between::step) return value(next - 1);
  const double length = track.times[next] - track.times[next - 1], t = (time - track.times[next - 1]) / length;
  if (!is_cubic) return mix(value(next - 1), value(next), t);
  const V &out = track.values[3 * next - 1], &in = track.values[3 * next];
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * value(next - 1) + length * (t3 - 2 * t2 + t) * out + (3 * t2 - 2 * t3) * value(next) +
         length * (t3 - t2) * in;
}

dmat4 local_at(const MovingNode& node, double time) {
  if (!node.moves()) return node.rest;
  return gltf::placement(at(node.translations, time, node.translation), at(node.rotations, time, node.rotation),
                         at(node.scales, time, node.scale));
}

/// The time of what moves these nodes.
struct Times {
  double first = std::numeric_limits<double>::infinity(), last = -first;

  void add(const std::vector<double>& times) {
    if (times.empty()) return;
    first = std::min(first, times.front());
    last = std::max(last, times.back());
  }
};

}  // namespace

std::vector<std::size_t> line_of(const std::vector<MovingNode>& nodes, std::size_t node) {
  std::vector<std::size_t> line{node};
  while (nodes[line.back()].parent) {
    if (line.size() == nodes.size()) throw InputError(fmt::format("node {}: it is below itself", node));
    line.push_back(*nodes[line.back()].parent);
  }
  return line;
}

std::vector<dmat4> poses_of(const std::vector<MovingNode>& nodes, std::size_t node) {
  const std::vector<std::size_t> line = line_of(nodes, node);
  Times times;
  for (const std::size_t i : line) {
    times.add(nodes[i].translations.times);
    times.add(nodes[i].rotations.times);
    times.add(nodes[i].scales.times);
  }
  constexpr double kFramesASecond = 30;
  const double steps = times.last > times.first ? std::ceil((times.last - times.first) * kFramesASecond) : 0;
  if (steps >= static_cast<double>(kMostFrames)) {
    throw InputError(fmt::format("its animation takes more than {} frames", kMostFrames));
  }
  std::vector<dmat4> poses;
  for (double step = 0; step <= steps; ++step) {
    const double time = steps > 0 ? times.first + (times.last - times.first) * (step / steps) : times.first;
    dmat4 pose(1);
    for (const std::size_t i : line) pose = local_at(nodes[i], time) * pose;
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace occlude::render
