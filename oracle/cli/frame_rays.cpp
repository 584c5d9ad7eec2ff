// SPDX-License-Identifier: MIT
#include "frame_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cases/to_oracle.h"

namespace occlude::cli {
namespace {

using glm::dvec3;
using oracle::HalfSpaceCoefficients;

/// The picture is smaller, and the near plane of what hides nearer, by this share of the depth of the model: far too little
/// to be seen, and more than their numbers round. What is between is not claimed.
constexpr double kSmaller = 0x1p-40;

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

}  // namespace

FrameRays::FrameRays(const culler::Hierarchy& hierarchy, const proof::AnyCamera& camera, const std::vector<bool>& culled)
    : hierarchy_(hierarchy), rays_(hierarchy), culled_(culled), view_(proof::viewpoint_of(camera)) {
  const kernel::Aabb& model = hierarchy.nodes()[0].box;
  const double depth = proof::depth_of(cases::to_oracle(model), camera);
  const oracle::Picture picture = proof::picture_of(camera, -kSmaller * depth);
  picture_ = picture.sides;
  picture_.insert(picture_.end(), picture.depth.begin(), picture.depth.end());
  near_ = proof::picture_of(camera, kSmaller * depth).depth.front();
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

/// The share of the segment at which it meets the triangle, or more: that of the farthest corner.
double FrameRays::end_at(const Segment& segment, const oracle::Triangle& triangle) {
  constexpr double kRounded = 1 + 0x1p-44;  // the products round by a few times 2^-53
  double farthest = 0;
  for (const oracle::Point& corner : triangle) {
    farthest = std::max(farthest, glm::dot(vector_of(corner) - segment.from, segment.along));
  }
  return kRounded * farthest / glm::dot(segment.along, segment.along);
}

std::optional<dvec3> FrameRays::where(const dvec3& from, const dvec3& along, std::uint32_t polygon) const {
  const double share = rays_.meeting(from, along, 0, polygon);
  return std::isnan(share) ? std::nullopt : std::optional(from + share * along);
}

bool FrameRays::seems_clear(const dvec3& point, std::uint32_t polygon, std::uint32_t& hider) const {
  const Segment segment = segment_to(point);
  const auto hides = [&](std::uint32_t p) {
    return p != polygon && rays_.meeting(segment.from, segment.along, segment.first, p) < 1;
  };
  if (hierarchy_.soup().is_opaque(hider) && hides(hider)) return false;
  return !rays_.any_of(segment.from, segment.along, 1, [&](std::uint32_t p) { return hides(p) && (hider = p, true); });
}

bool FrameRays::shows(const dvec3& point, std::uint32_t polygon) const {
  const oracle::Ray ray(view_, {point.x, point.y, point.z});
  const Segment segment = segment_to(point);
  bool is_seen = false;
  proof::for_each_triangle(hierarchy_.soup(), polygon, [&](const oracle::Triangle& triangle) {
    if (is_seen || !ray.enters(triangle, picture_)) return;
    is_seen = !rays_.any_of(segment.from, segment.along, end_at(segment, triangle), [&](std::uint32_t p) {
      bool hides = false;
      proof::for_each_triangle(hierarchy_.soup(), p, [&](const oracle::Triangle& other) {
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
