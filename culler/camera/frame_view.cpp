// SPDX-License-Identifier: MIT
#include "camera/frame_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "camera/legal_half_space.h"
#include "camera/matrix_eye.h"
#include "camera/negligible.h"
#include "camera/single_precision.h"
#include "camera/view_planes.h"
#include "model/bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// The half-space beyond `point` in the direction `inward`, from all eyes. It is moved outwards by the margin and by more
/// than its offset is rounded by: three products |normal_k| |point_k|, each with at most four roundings and a dropped
/// coefficient. The roundings of the normal tilt the plane at `depth` by far less than the margin.
HalfSpace half_space(const glm::dvec3& inward, const glm::dvec3& point, double depth, const EyeRegion& eyes) {
  const glm::dvec3 normal = without_negligible(inward / glm::length(inward));
  const double size = std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z);
  return legal(normal, -glm::dot(normal, point) + 0x1p-48 * size + kDepthMargin * depth + eyes.reach(normal));
}

/// No point that is `reach` from the middle of the region, in the sum of the axes, is farther from any of its eyes.
double depth_from_all(const EyeRegion& eyes, double reach) {
  return reach + 2 * eyes.radius +
         std::accumulate(eyes.half_edges.begin(), eyes.half_edges.end(), 0.0, [](double sum, const glm::dvec3& h) {
           return sum + std::fabs(h.x) + std::fabs(h.y) + std::fabs(h.z);
         });
}

/// The part of a picture whose rays matter, in halves of the camera's picture: with the border of a coarse picture, which
/// makes it half as large again, and room for what moves points.
constexpr double kWithBorder = 3;

/// How far along the line of sight a near plane lies, within a picture.
struct Crossing {
  double nearest, farthest;
};

/// Let g = normal . v be the height over the plane through the eye. The plane lies where g is `distance`. Along a ray of the
/// picture that is at distance / g of the ray's point at a distance of 1. As g is linear, the corners of the picture have
/// the extremes.
std::optional<Crossing> crossing_of(const MatrixEye& eye, const glm::dvec3& normal, double distance) {
  const double x = kWithBorder * eye.half_width(), y = kWithBorder * eye.half_height();
  const double infinity = std::numeric_limits<double>::infinity();
  double low = infinity, high = -infinity;
  for (const auto& [right, up] : {std::pair{-x, -y}, {-x, y}, {x, -y}, {x, y}}) {
    const MatrixEye::Vector ray = eye.vector(right, up, eye.is_perspective() ? 1 : 0);
    const double height = glm::dot(normal, ray.value), error = ray.error + 0x1p-50 * glm::length(ray.value);
    low = std::min(low, height - error);
    high = std::max(high, height + error);
  }
  if (eye.is_perspective()) {
    if (!(low > 0)) return std::nullopt;
    return Crossing{distance / high, distance / low};
  }
  const double along = glm::dot(normal, eye.axes().forward) - 0x1p-50;
  if (!(along > 0)) return std::nullopt;
  return Crossing{(distance - high) / along, (distance - low) / along};
}

/// A near plane is across the line of sight if, within the picture, it is nowhere more than twice as far as elsewhere; with
/// parallel rays, if the difference is less than 1/64 of its width and height together. What a cut at its farthest point
/// leaves out then hardly matters.
bool is_across(const MatrixEye& eye, const Crossing& crossing) {
  if (eye.is_perspective()) return crossing.farthest <= 2 * crossing.nearest;
  return crossing.farthest - crossing.nearest <= (eye.half_width() + eye.half_height()) / 32;
}

}  // namespace

FrameView::FrameView(const Camera& camera, double reach)
    : any_camera(camera),
      is_perspective(camera.projection == Projection::perspective),
      depth(depth_from_all(camera.eyes, reach)),
      eye(camera.eye),
      axes(camera.axes()),
      viewpoint(camera.viewpoint()),
      half_height(is_perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2),
      area(camera.height * camera.height * camera.aspect),
      near_normal(axes.forward),
      near_distance(camera.near_plane + kDepthMargin * depth + camera.eyes.reach(near_normal)),
      near(near_distance),
      is_oblique(false),
      eye_uncertainty(0),
      eyes(is_perspective ? camera.eyes : EyeRegion{}) {
  half_width = half_height * camera.aspect;
  height = 2 * half_height;
  const auto& [right, up, forward] = axes;
  const auto append = [&](const glm::dvec3& inward, const glm::dvec3& point) {
    add(half_space(inward, point, depth, camera.eyes), kDepthMargin);
  };
  for (const auto& [half, across] :
       {std::pair{half_width, right}, {half_width, -right}, {half_height, up}, {half_height, -up}}) {
    if (is_perspective) {
      append(half * forward + across, camera.eye);
    } else {
      append(across, camera.eye - half * across);
    }
  }
  if (camera.eyes.is_point()) append(forward, camera.eye + camera.near_plane * forward);
  if (std::isfinite(camera.far_plane)) append(-forward, camera.eye + camera.far_plane * forward);
}

/// Why this holds from every eye of the region, and for wherever the exact eye is: the camera at eye + e sees what a camera
/// at the eye sees of a model that is moved by -e.
///  - Half-spaces of the first are those of the second moved by e, and so along their normals by as far as the region
///    reaches. There is none of the near plane, because a camera for which the frame holds may have a nearer one.
///  - A coarse picture bounds what moves of points by `eye_uncertainty` can do, and what the eyes can.
///  - A point is beyond the near plane of all eyes if it is beyond the camera's by as far as the region reaches. Along a ray
///    from an eye, the near planes of all are equally far.
///  - Parallel rays stay what they are: nothing needs to be moved.
FrameView::FrameView(const MatrixCamera& camera, double reach)
    : any_camera(camera), is_perspective(true), area(0), near_distance(0), near(0), is_oblique(false), eye_uncertainty(0) {
  const MatrixEye of(camera);
  is_perspective = of.is_perspective();
  eyes = is_perspective ? camera.eyes : EyeRegion{};
  depth = depth_from_all(camera.eyes, reach);
  eye = of.eye();
  axes = of.axes();
  viewpoint =
      is_perspective ? kernel::Viewpoint::eye(to_kernel(eye)) : kernel::Viewpoint::direction(to_kernel(axes.forward));
  half_width = of.half_width();
  half_height = of.half_height();
  height = of.height();
  area = 4 * half_width * half_height;
  eye_uncertainty = of.moved(depth);
  const std::array<ClipPlane, 6> planes = of.planes(depth);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const ClipPlane& plane = planes[i];
    if (plane.is_everywhere || (i == MatrixEye::kNear && !camera.eyes.is_point())) continue;
    const double offset = plane.offset + plane.error + camera.eyes.reach(plane.normal);
    if (offset <= kFarthestPlane) add(legal(plane.normal, offset), plane.margin);
  }

  // What hides is cut beyond the near plane, by as much more as points may be moved. By so much it is also before the eye,
  // wherever the near plane is.
  const ClipPlane& clip = planes[MatrixEye::kNear];
  near_normal = clip.normal;
  const double distance = clip.error - (glm::dot(clip.normal, eye) + clip.offset);
  near_distance = distance + camera.eyes.reach(near_normal);
  const double beyond = eyes.reach(axes.forward) + eye_uncertainty + kDepthMargin * depth + kernel::kMinMagnitude;
  const auto crossing = crossing_of(of, near_normal, is_perspective ? distance : near_distance);
  is_oblique = !crossing || !is_across(of, *crossing);
  near = !is_oblique ? crossing->farthest + beyond : is_perspective ? beyond : -2 * depth - beyond;
}

static_assert(std::tuple_size_v<decltype(FrameView::half_spaces)> <= ViewPlanes::kMostPlanes);

void FrameView::append_half_spaces(std::vector<HalfSpace>& planes) const {
  planes.insert(planes.end(), half_spaces.begin(), half_spaces.begin() + static_cast<std::ptrdiff_t>(half_space_count));
}

bool FrameView::may_clip(std::span<const kernel::Vec3> vertices) const {
  return std::ranges::any_of(vertices, [&](const kernel::Vec3& v) { return may_clip(to_glm(v)); });
}

}  // namespace occlude::culler
