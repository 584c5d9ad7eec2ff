// SPDX-License-Identifier: MIT
#include "free_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <vector>

#include "occlude/kernel/orientation.h"

namespace occlude::render {
namespace {

using glm::dvec3;

kernel::Vec3 to_kernel(const dvec3& v) { return {v.x, v.y, v.z}; }

struct Segment {
  dvec3 p, q;  ///< which may be equal
};

struct Triangle {
  std::array<dvec3, 3> corners;
};

struct Box {
  dvec3 low, high;

  [[nodiscard]] bool meets(const Box& other) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (low[axis] > other.high[axis] || high[axis] < other.low[axis]) return false;
    }
    return true;
  }
};

/// Whether the segment and the triangle, both closed, share a point. Exact where they do not lie in one plane; where they
/// do, false: then the segment goes through a corner or an edge or lies within, and the distances below are 0 up to
/// rounding.
bool pierces(const Segment& segment, const Triangle& triangle) {
  const kernel::Vec3 p = to_kernel(segment.p), q = to_kernel(segment.q), a = to_kernel(triangle.corners[0]),
                     b = to_kernel(triangle.corners[1]), c = to_kernel(triangle.corners[2]);
  const int side_p = kernel::orientation(a, b, c, p), side_q = kernel::orientation(a, b, c, q);
  if (side_p == side_q) return false;  // not across the plane, or both within it
  const int ab = kernel::orientation(p, q, a, b), bc = kernel::orientation(p, q, b, c), ca = kernel::orientation(p, q, c, a);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// The squared distance of two segments (Ericson, Real-Time Collision Detection, 5.1.9).
double squared_distance(const Segment& one, const Segment& other) {
  const dvec3 d = one.q - one.p, e = other.q - other.p, r = one.p - other.p;
  const double dd = glm::dot(d, d), ee = glm::dot(e, e), er = glm::dot(e, r), dr = glm::dot(d, r), de = glm::dot(d, e);
  const double denominator = dd * ee - de * de;
  const auto ratio = [](double numerator, double divisor) {
    return divisor > 0 ? std::clamp(numerator / divisor, 0.0, 1.0) : 0.0;
  };
  double s = ratio(de * er - dr * ee, denominator);
  const double t = ratio(de * s + er, ee);
  s = ratio(de * t - dr, dd);
  const dvec3 gap = r + s * d - t * e;
  return glm::dot(gap, gap);
}

/// Whether the point lies over the triangle and its squared distance is no more than this.
bool is_over(const dvec3& p, const Triangle& triangle, double squared) {
  const auto& [a, b, c] = triangle.corners;
  const dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::dot(normal, normal);
  if (!(length > 0)) return false;
  const double height = glm::dot(normal, p - a);
  if (height * height > squared * length) return false;
  const auto inside = [&](const dvec3& from, const dvec3& to) {
    return glm::dot(glm::cross(to - from, p - from), normal) >= 0;
  };
  return inside(a, b) && inside(b, c) && inside(c, a);
}

bool is_clear(const Segment& segment, const Triangle& triangle, double clearance) {
  const double squared = clearance * clearance;
  for (std::size_t i = 0; i < 3; ++i) {
    if (squared_distance(segment, {triangle.corners[i], triangle.corners[(i + 1) % 3]}) < squared) return false;
  }
  return !is_over(segment.p, triangle, squared) && !is_over(segment.q, triangle, squared) && !pierces(segment, triangle);
}

/// A tree over the segments of the way, in order. It is small, however large the model is: triangles go down in it.
class WayTree {
 public:
  WayTree(std::span<const CameraPath::Keyframe> way, double clearance) : way_(way), clearance_(clearance) {
    segments_ = std::max<std::size_t>(1, way.size() - 1);
    boxes_.resize(4 * segments_);
    build(1, 0, segments_);
  }

  [[nodiscard]] bool is_clear_of(const Triangle& triangle) const {
    const auto& [a, b, c] = triangle.corners;
    return is_clear_of(triangle, {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))}, 1, 0, segments_);
  }

 private:
  [[nodiscard]] Segment segment(std::size_t i) const { return {way_[i].eye, way_[std::min(i + 1, way_.size() - 1)].eye}; }

  void build(std::size_t node, std::size_t begin, std::size_t end) {
    if (end - begin == 1) {
      // Half as much again as the clearance makes up for rounding.
      const auto [p, q] = segment(begin);
      boxes_[node] = {glm::min(p, q) - 1.5 * clearance_, glm::max(p, q) + 1.5 * clearance_};
      return;
    }
    const std::size_t middle = (begin + end) / 2;
    build(2 * node, begin, middle);
    build(2 * node + 1, middle, end);
    boxes_[node] = {glm::min(boxes_[2 * node].low, boxes_[2 * node + 1].low),
                    glm::max(boxes_[2 * node].high, boxes_[2 * node + 1].high)};
  }

  [[nodiscard]] bool is_clear_of(const Triangle& triangle, const Box& box, std::size_t node, std::size_t begin,
                                 std::size_t end) const {
    if (!boxes_[node].meets(box)) return true;
    if (end - begin == 1) return is_clear(segment(begin), triangle, clearance_);
    const std::size_t middle = (begin + end) / 2;
    return is_clear_of(triangle, box, 2 * node, begin, middle) && is_clear_of(triangle, box, 2 * node + 1, middle, end);
  }

  std::span<const CameraPath::Keyframe> way_;
  double clearance_;
  std::size_t segments_ = 0;
  std::vector<Box> boxes_;
};

}  // namespace

bool is_free_way(culler::SoupView model, std::span<const CameraPath::Keyframe> way, double clearance) {
  // Where coordinates are so large that distances of this size are rounded away, nothing is sure.
  constexpr double kSure = 0x1p-40;
  for (const CameraPath::Keyframe& key : way) {
    if (std::max({std::fabs(key.eye.x), std::fabs(key.eye.y), std::fabs(key.eye.z)}) * kSure > clearance) return false;
  }
  const WayTree tree(way, clearance);
  for (std::size_t p = 0; p < model.size(); ++p) {
    const std::span<const std::uint32_t> loop = model.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Triangle triangle{{model.vertices[loop[0]], model.vertices[loop[i]], model.vertices[loop[i + 1]]}};
      if (!tree.is_clear_of(triangle)) return false;
    }
  }
  return true;
}

}  // namespace occlude::render
