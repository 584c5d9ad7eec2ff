// SPDX-License-Identifier: MIT
#include "frame_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "cases/to_oracle.h"

namespace occlude::cli {
namespace {

using glm::dvec3;
using oracle::HalfSpaceCoefficients;

/// The picture is smaller, and the near plane of what hides nearer, by this share of the depth of the model: far too little
/// to be seen, and more than their numbers round. What is between is not claimed.
constexpr double kSmaller = 0x1p-40;
/// A coordinate of a point on a segment rounds by a few times 2^-53 of the numbers that it is computed of.
constexpr double kRounding = 0x1p-44;

dvec3 vector_of(const oracle::Point& p) { return {p[0], p[1], p[2]}; }

double height(const HalfSpaceCoefficients& h, const dvec3& p) { return h[0] * p.x + h[1] * p.y + h[2] * p.z + h[3]; }

std::vector<dvec3> clipped(const std::vector<dvec3>& polygon, const HalfSpaceCoefficients& half_space) {
  std::vector<dvec3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = height(half_space, p), b = height(half_space, q);
    if (a >= 0) result.push_back(p);
    if ((a < 0) != (b < 0)) result.push_back(p + a / (a - b) * (q - p));
  }
  return result;
}

/// Whether the segment meets the box, or passes it by less than `room`.
bool may_meet(const kernel::Aabb& box, const dvec3& from, const dvec3& along, double room) {
  double first = 0, last = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto coordinate = [&](const kernel::Vec3& v) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; };
    const double low = coordinate(box.min) - room - from[axis], high = coordinate(box.max) + room - from[axis];
    if (along[axis] == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    const double a = low / along[axis], b = high / along[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first <= last;
}

double largest_coordinate(const kernel::Aabb& box) {
  double largest = 0;
  for (const kernel::Vec3& v : {box.min, box.max})
    largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return largest;
}

}  // namespace

FrameRays::FrameRays(const culler::Hierarchy& hierarchy, const proof::AnyCamera& camera, const std::vector<bool>& culled)
    : hierarchy_(hierarchy), culled_(culled), view_(proof::viewpoint_of(camera)) {
  const kernel::Aabb& model = hierarchy.nodes()[0].box;
  const double depth = proof::depth_of(cases::to_oracle(model), camera);
  const oracle::Picture picture = proof::picture_of(camera, -kSmaller * depth);
  picture_ = picture.sides;
  picture_.insert(picture_.end(), picture.depth.begin(), picture.depth.end());
  near_ = proof::picture_of(camera, kSmaller * depth).depth.front();
  rounding_ = kRounding * (largest_coordinate(model) + depth);
}

std::vector<dvec3> FrameRays::in_picture(const oracle::Triangle& triangle) const {
  std::vector<dvec3> part{vector_of(triangle[0]), vector_of(triangle[1]), vector_of(triangle[2])};
  for (const HalfSpaceCoefficients& half_space : picture_) part = clipped(part, half_space);
  return part;
}

FrameRays::Segment FrameRays::segment_to(const dvec3& point) const {
  const dvec3 view = vector_of(view_.value);
  const double end = height(near_, point);
  if (view_.at_infinity) {
    const dvec3 along = end / (near_[0] * view.x + near_[1] * view.y + near_[2] * view.z) * view;
    return {point - along, along, 0};
  }
  const double begin = height(near_, view);
  return {view, point - view, begin < 0 ? begin / (begin - end) : 0};
}

/// The segment, as long as it takes to meet the triangle: no farther along it than the farthest corner.
FrameRays::Segment FrameRays::reaching(const Segment& segment, const oracle::Triangle& triangle) {
  double farthest = 0;
  for (const oracle::Point& corner : triangle) {
    farthest = std::max(farthest, glm::dot(vector_of(corner) - segment.from, segment.along));
  }
  return {segment.from, (1 + kRounding) * farthest / glm::dot(segment.along, segment.along) * segment.along, segment.first};
}

template <class Visit>
bool FrameRays::any_of(const Segment& segment, const Visit& visit) const {
  const auto nodes = hierarchy_.nodes();
  const culler::SoupView& soup = hierarchy_.soup();
  std::array<std::uint32_t, culler::kMostLevels + 1> waiting;
  std::size_t count = 0;
  for (std::uint32_t i = 0;;) {
    const culler::HierarchyNode& node = nodes[i];
    const bool is_met = may_meet(node.box, segment.from, segment.along, rounding_);
    if (is_met && !node.is_leaf()) {
      waiting[count++] = node.right;
      ++i;
      continue;
    }
    for (std::uint32_t p = node.first; is_met && p < node.first + node.count; ++p) {
      if (soup.is_opaque(p) && visit(p)) return true;
    }
    if (count == 0) return false;
    i = waiting[--count];
  }
}

/// As Möller and Trumbore do it.
double FrameRays::meeting(const dvec3& from, const dvec3& along, double first, std::uint32_t polygon) const {
  double nearest = std::numeric_limits<double>::quiet_NaN();
  for_each_triangle(hierarchy_.soup(), polygon, [&](const oracle::Triangle& triangle) {
    const dvec3 a = vector_of(triangle[0]), e = vector_of(triangle[1]) - a, f = vector_of(triangle[2]) - a;
    const dvec3 across = glm::cross(along, f), to = from - a, turned = glm::cross(to, e);
    const double determinant = glm::dot(e, across);
    const double u = glm::dot(to, across) / determinant, v = glm::dot(along, turned) / determinant,
                 t = glm::dot(f, turned) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && t >= first && !(t >= nearest)) nearest = t;
  });
  return nearest;
}

std::optional<dvec3> FrameRays::where(const dvec3& from, const dvec3& along, std::uint32_t polygon) const {
  const double share = meeting(from, along, 0, polygon);
  return std::isnan(share) ? std::nullopt : std::optional(from + share * along);
}

bool FrameRays::seems_clear(const dvec3& point, std::uint32_t polygon, std::uint32_t& hider) const {
  const Segment segment = segment_to(point);
  const auto hides = [&](std::uint32_t p) {
    return p != polygon && meeting(segment.from, segment.along, segment.first, p) < 1;
  };
  if (hierarchy_.soup().is_opaque(hider) && hides(hider)) return false;
  return !any_of(segment, [&](std::uint32_t p) {
    if (!hides(p)) return false;
    hider = p;
    return true;
  });
}

bool FrameRays::shows(const dvec3& point, std::uint32_t polygon) const {
  const oracle::Ray ray(view_, {point.x, point.y, point.z});
  const Segment segment = segment_to(point);
  bool is_seen = false;
  for_each_triangle(hierarchy_.soup(), polygon, [&](const oracle::Triangle& triangle) {
    if (is_seen || !ray.enters(triangle, picture_)) return;
    is_seen = !any_of(reaching(segment, triangle), [&](std::uint32_t p) {
      bool hides = false;
      for_each_triangle(hierarchy_.soup(), p, [&](const oracle::Triangle& other) {
        if (hides) return;
        const oracle::Ray::Order order = ray.order(triangle, other, near_);
        hides = order == oracle::Ray::Order::nearer || (order == oracle::Ray::Order::same && !culled_[p]);
      });
      return hides;
    });
  });
  return is_seen;
}

}  // namespace occlude::cli
