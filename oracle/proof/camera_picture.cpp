// SPDX-License-Identifier: MIT
#include "camera_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "occlude/oracle/questions.h"

namespace occlude::proof {
namespace {

using glm::dvec3;
using oracle::HalfSpaceCoefficients;
using oracle::Relation;

/// Each term of an offset goes through fewer than eight roundings, of 2^-53 each.
constexpr double kRounded = 0x1p-50;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double sum_of_magnitudes(const dvec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

/// {x : normal . x + offset >= 0}, moved by the distance `outward` and, in the same direction, by more than the offset may
/// be wrong by rounding. `terms` bounds the magnitudes of what it was summed of.
HalfSpaceCoefficients moved(const dvec3& normal, double offset, double terms, double outward) {
  const double distance = outward * glm::length(normal);
  const double rounded = std::copysign(kRounded, outward) * (terms + std::fabs(distance));
  return {normal.x, normal.y, normal.z, offset + distance + rounded};
}

oracle::Picture picture(const culler::Camera& camera, double outward) {
  const auto [right, up, forward] = camera.axes();
  const auto within = [&](const dvec3& normal, double ahead) {
    const double terms = sum_of_magnitudes(normal) * sum_of_magnitudes(camera.eye) + std::fabs(ahead);
    return moved(normal, ahead - glm::dot(normal, camera.eye), terms, outward);
  };
  const bool perspective = camera.projection == culler::Projection::perspective;
  const double y = perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2;
  const double x = y * camera.aspect;

  oracle::Picture picture;
  for (const auto& [half, across] : {std::pair{x, right}, {x, -right}, {y, up}, {y, -up}}) {
    // The rounding of the tangent and of the sum changes each coordinate of the normal by less than 2^-50 (1 + half). At
    // depth 1 a point of the picture is at most 1 + x + y away from the eye. There the rounding changes the height by less
    // than the tilt does.
    const double tilted = std::copysign(kRounded, outward) * (1 + half) * (1 + x + y);
    picture.sides.push_back(perspective ? within((half + tilted) * forward - across, 0) : within(-across, half));
  }
  picture.depth.push_back(within(forward, -camera.near_plane));
  if (std::isfinite(camera.far_plane)) picture.depth.push_back(within(-forward, camera.far_plane));
  return picture;
}

/// Whether the renderer draws the smaller of two depths before the other.
bool is_less_nearer(const culler::MatrixCamera& camera) {
  if (camera.nearer != culler::Nearer::unsaid) return camera.nearer == culler::Nearer::less;
  // The eye, where w is 0, is before the near plane, -w <= z or 0 <= z, unless depth is reversed.
  const dvec3 eye = camera.eye();
  return camera.matrix[0][2] * eye.x + camera.matrix[1][2] * eye.y + camera.matrix[2][2] * eye.z + camera.matrix[3][2] < 0;
}

oracle::Picture picture(const culler::MatrixCamera& camera, double outward) {
  const dvec3 eye = camera.eye();
  const auto add = [&](std::vector<HalfSpaceCoefficients>& half_spaces, int row, double sign, bool with_w) {
    const auto number = [&](int column) {
      return sign * camera.matrix[column][row] + (with_w ? camera.matrix[column][3] : 0);
    };
    dvec3 normal(number(0), number(1), number(2));
    const double length = glm::length(normal), offset = number(3) / length;
    constexpr double kFarthest = 0x1p99;
    if (!(offset < kFarthest)) return;  // it cuts off nothing
    normal /= length;
    // What rotations leave of 0. It is less than what rounds.
    for (int axis = 0; axis < 3; ++axis) normal[axis] = std::fabs(normal[axis]) < 0x1p-60 ? 0 : normal[axis];
    half_spaces.push_back(moved(normal, offset, sum_of_magnitudes(eye) + std::fabs(offset), outward));
  };
  oracle::Picture picture;
  for (const int row : {0, 1}) {
    for (const double sign : {1.0, -1.0}) add(picture.sides, row, sign, true);
  }
  for (const double sign : is_less_nearer(camera) ? std::array{1.0, -1.0} : std::array{-1.0, 1.0}) {
    add(picture.depth, 2, sign, sign < 0 || camera.depth == culler::ClipDepth::minus_w_to_w);
  }
  return picture;
}

dvec3 eye_of(const culler::Camera& camera) { return camera.eye; }
dvec3 eye_of(const culler::MatrixCamera& camera) { return camera.eye(); }

dvec3 eye_of(const AnyCamera& camera) {
  return std::visit([](const auto& c) { return eye_of(c); }, camera);
}

oracle::Point position(const dvec3& v) { return {v.x, v.y, v.z}; }
dvec3 vector(const oracle::Point& p) { return {p[0], p[1], p[2]}; }

/// How far the eyes reach from their middle along a vector, times its length. More than it may be wrong by rounding.
double reach(const oracle::EyeRegion& eyes, const dvec3& along) {
  double sum = 0;
  if (const auto* ball = std::get_if<oracle::Ball>(&eyes)) {
    sum = ball->radius * glm::length(along);
  } else {
    for (const oracle::Point& half_edge : std::get<oracle::Obb>(eyes).half_edges) {
      sum +=
          std::fabs(glm::dot(vector(half_edge), along)) + kRounded * glm::dot(glm::abs(vector(half_edge)), glm::abs(along));
    }
  }
  return (1 + kRounded) * sum;
}

/// The same along an axis.
double reach(const oracle::EyeRegion& eyes, std::size_t axis) {
  dvec3 unit(0);
  unit[static_cast<int>(axis)] = 1;
  return reach(eyes, unit);
}

dvec3 middle_of(const oracle::EyeRegion& eyes) {
  return std::visit([](const auto& kind) { return vector(kind.center); }, eyes);
}

/// Moves half-spaces that belong to one eye, outward to hold those of all eyes, or inward to lie in all of them.
void move(std::vector<HalfSpaceCoefficients>& half_spaces, const dvec3& from, const oracle::EyeRegion& eyes,
          double outward) {
  for (auto& [a, b, c, offset] : half_spaces) {
    const dvec3 normal(a, b, c), middle = middle_of(eyes);
    const double terms = sum_of_magnitudes(normal) * (sum_of_magnitudes(from) + sum_of_magnitudes(middle));
    const double distance = reach(eyes, normal) + kRounded * (terms + std::fabs(offset));
    offset += glm::dot(normal, from - middle) + std::copysign(distance, outward);
  }
}

/// Parallel rays run along the direction that the culler uses, so both take the same exact numbers.
oracle::Viewpoint to_viewpoint(const culler::Camera& camera) {
  if (camera.projection == culler::Projection::perspective) return {position(camera.eye)};
  return {position(camera.axes().forward), true};
}
oracle::Viewpoint to_viewpoint(const culler::MatrixCamera& camera) {
  const kernel::Viewpoint view = camera.viewpoint();
  return {{view.value.x, view.value.y, view.value.z}, !view.is_eye()};
}

}  // namespace

oracle::Viewpoint viewpoint_of(const AnyCamera& camera) {
  return std::visit([](const auto& c) { return to_viewpoint(c); }, camera);
}

Eyes eyes_of(const AnyCamera& camera) {
  const culler::EyeRegion& region = std::visit([](const auto& c) -> const culler::EyeRegion& { return c.eyes; }, camera);
  if (region.is_point()) return std::nullopt;
  const oracle::Point middle = position(eye_of(camera));
  if (region.radius > 0) return oracle::Ball{middle, region.radius};
  const auto& [a, b, c] = region.half_edges;
  return oracle::Obb{middle, {position(a), position(b), position(c)}};
}

oracle::Picture picture_of(const AnyCamera& camera, double outward, const Eyes& eyes) {
  oracle::Picture result = std::visit([&](const auto& c) { return picture(c, outward); }, camera);
  if (const Eyes all = eyes ? eyes : eyes_of(camera)) {
    for (auto* half_spaces : {&result.sides, &result.depth}) move(*half_spaces, eye_of(camera), *all, outward);
  }
  return result;
}

double depth_of(const oracle::Aabb& model, const AnyCamera& camera, const Eyes& eyes) {
  const Eyes all = eyes ? eyes : eyes_of(camera);
  const oracle::Point eye = position(all ? middle_of(*all) : eye_of(camera));
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum += std::max(std::fabs(model.min[axis] - eye[axis]), std::fabs(model.max[axis] - eye[axis]));
    if (all) sum += reach(*all, axis);
  }
  return sum;
}

namespace {

using HalfSpaces = std::vector<HalfSpaceCoefficients>;

HalfSpaceCoefficients complement(const HalfSpaceCoefficients& h) { return {-h[0], -h[1], -h[2], -h[3]}; }

/// Whether a point of `model`, in a half-space, may be in what `picture_from` shows of one of the eyes, which it is given.
/// The eye and the point may be moved together until the eye is in the middle. Then the point is in the picture from there,
/// and no farther from the model and the half-space than the eyes reach. The intersection of half-spaces that were moved
/// instead is larger: it begins behind the eyes.
bool may_show(const HalfSpaceCoefficients& half_space, oracle::Aabb model, const AnyCamera& camera, const Eyes& eyes,
              const auto& picture_from) {
  const Eyes all = eyes ? eyes : eyes_of(camera);
  HalfSpaces shown = picture_from(all ? Eyes(oracle::Ball{position(middle_of(*all)), 0}) : std::nullopt);
  shown.push_back(half_space);
  if (all) {
    shown.back()[3] += reach(*all, {half_space[0], half_space[1], half_space[2]});
    shown.back()[3] = std::nextafter(shown.back()[3], kInfinity);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      model.min[axis] = std::nextafter(model.min[axis] - reach(*all, axis), -kInfinity);
      model.max[axis] = std::nextafter(model.max[axis] + reach(*all, axis), kInfinity);
    }
  }
  return oracle::relation_to_half_spaces(shown, model).relation != Relation::outside;
}

}  // namespace

bool may_draw_beyond(const std::array<double, 4>& plane, const AnyCamera& camera, const oracle::Aabb& model,
                     const Eyes& eyes) {
  return may_show(complement(plane), model, camera, eyes, [&](const Eyes& from) {
    auto [shown, depth] = picture_of(camera, kRendererRounds * depth_of(model, camera, eyes), from);
    shown.insert(shown.end(), depth.begin(), depth.end());
    return shown;
  });
}

bool draws_all_in(const HalfSpaceCoefficients& half_space, const AnyCamera& camera, const oracle::Aabb& model,
                  const Eyes& eyes) {
  const double rounded = kRendererRounds * depth_of(model, camera, eyes);
  return !may_show(half_space, model, camera, eyes, [&](const Eyes& from) {
    HalfSpaces shown = picture_of(camera, rounded, from).sides;
    shown.push_back(complement(picture_of(camera, -rounded, from).depth.front()));
    return shown;
  });
}

namespace {

/// The half-space of the near plane, moved inwards by this share of the depth.
HalfSpaceCoefficients beyond_near(const AnyCamera& camera, const oracle::Aabb& model, const Eyes& eyes, double share) {
  constexpr double kLeast = 0x1p-100, kMost = 0x1p100;
  HalfSpaceCoefficients near = picture_of(camera, -share * depth_of(model, camera, eyes), eyes).depth.front();
  double& offset = near[3];
  if (offset != 0 && std::fabs(offset) < kLeast) offset = -kLeast;  // inward
  if (std::fabs(offset) > kMost) {
    for (double& number : near) number *= 0x1p-4;
  }
  return near;
}

}  // namespace

HalfSpaceCoefficients drawn(const AnyCamera& camera, const oracle::Aabb& model, const Eyes& eyes) {
  return beyond_near(camera, model, eyes, kRendererRounds);
}

HalfSpaceCoefficients drawn_of_sheets(const AnyCamera& camera, const oracle::Aabb& model, const Eyes& eyes) {
  static_assert(kSheetsBegin > kRendererRounds);
  return beyond_near(camera, model, eyes, kSheetsBegin);
}

bool may_clip(const AnyCamera& camera, const oracle::Aabb& model, std::span<const oracle::Point> points, const Eyes& eyes) {
  const HalfSpaceCoefficients near = drawn(camera, model, eyes);
  return !std::ranges::all_of(points, [&](const oracle::Point& p) {
    return oracle::relation_to_half_spaces(std::span(&near, 1), oracle::Aabb{p, p}).relation == Relation::inside;
  });
}

}  // namespace occlude::proof
