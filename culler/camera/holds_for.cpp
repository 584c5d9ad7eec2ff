// SPDX-License-Identifier: MIT
#include "camera/holds_for.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <variant>

#include "camera/extent.h"
#include "camera/eye_region.h"
#include "camera/single_precision.h"
#include "camera/sound_camera.h"

namespace occlude::culler {
namespace {

/// The part of the margins of a frame that its renderer needs, as a share of the depth. The rest is for cameras that are
/// turned by rounding.
constexpr double kNeeded = 0.75;
static_assert(kNeeded * kDepthMargin > 1.125 * kSinglePrecision);

class Question {
 public:
  template <class AnyCamera>
  Question(const FrameView& frame, const AnyCamera& camera, double eye_error)
      : frame_(frame),
        frame_eyes_(std::visit([](const auto& c) { return c.eyes; }, frame.any_camera)),
        eyes_(camera.eyes),
        view_(of_one_eye(camera), kNeeded * frame.depth),
        extent_(camera, view_),
        from_eye_(view_.eye - frame.eye),
        eye_error_(frame.eye_uncertainty + view_.eye_uncertainty + eye_error) {}

  [[nodiscard]] bool holds() const {
    if (!is_same_projection() || !are_eyes_within()) return false;
    for (std::size_t i = 0; i < frame_.half_space_count; ++i) {
      if (!is_within(frame_.half_spaces[i], kNeeded * frame_.half_space_margins[i] * frame_.depth)) return false;
    }
    return draws_what_hides();
  }

 private:
  template <class AnyCamera>
  [[nodiscard]] static AnyCamera of_one_eye(AnyCamera camera) {
    camera.eyes = {};
    return camera;
  }

  /// Of parallel rays that are a matrix's nobody knows whether they are the same.
  [[nodiscard]] bool is_same_projection() const {
    if (view_.is_perspective || frame_.is_perspective) return view_.is_perspective && frame_.is_perspective;
    return std::holds_alternative<Camera>(view_.any_camera) && std::holds_alternative<Camera>(frame_.any_camera) &&
           view_.axes.forward == frame_.axes.forward;
  }

  /// The corners of a box are eyes of it, and no others need be asked.
  [[nodiscard]] bool are_eyes_within() const {
    const auto& [a, b, c] = eyes_.half_edges;
    double error = eye_error_ + eyes_.radius;
    if (!eyes_.is_point()) error += kProductRounded * (radius_of(eyes_) + glm::length(from_eye_));
    for (unsigned i = 0; i < 8; ++i) {
      const glm::dvec3 corner = (i & 1U ? a : -a) + (i & 2U ? b : -b) + (i & 4U ? c : -c);
      if (!contains(frame_eyes_, from_eye_ + corner, error)) return false;
    }
    return true;
  }

  /// Whether all that shows lies in a half-space by as much as `margin`. Nothing of the model is farther than the depth.
  [[nodiscard]] bool is_within(const HalfSpace& h, double margin) const {
    const double length = glm::length(h.normal), depth = (1 + kProductRounded) * frame_.depth;
    const double of_eyes = eyes_.reach(h.normal) + length * eye_error_;
    const double size = glm::length(view_.eye) + depth + extent_.length;
    const double rounded = kProductRounded * (length * size + std::fabs(h.offset) + of_eyes);
    const double inside = std::max(least_of_shown(h.normal, depth), -length * depth);
    return glm::dot(h.normal, view_.eye) + h.offset - of_eyes - rounded + inside >= length * margin;
  }
  /// The least of n . v for all v that show from the eye within the depth.
  [[nodiscard]] double least_of_shown(const glm::dvec3& n, double depth) const {
    const double far = std::min(extent_.farthest, depth), near = std::min(extent_.nearest, far);
    const double least = extent_.least(n), along = glm::dot(n, view_.axes.forward);
    if (!view_.is_perspective) return least + std::min(near * along, far * along);
    return least > 0 ? (1 - kProductRounded) * near * least : (1 + kProductRounded) * far * least;
  }

  /// What hides lies where m . v >= d relative to each eye, m the normal of the frame's near plane. What the camera draws
  /// has n . v >= e. The first implies the second if, for some s, s d >= e and (n - s m) . c >= 0 at the corners; and also
  /// if the product is less by what s d exceeds e over the depth.
  [[nodiscard]] bool draws_what_hides() const {
    const glm::dvec3 &m = frame_.near_normal, &n = view_.near_normal;
    const double reach = frame_eyes_.reach(m);
    const double hides = frame_.near_distance - reach - kProductRounded * (std::fabs(frame_.near_distance) + reach);
    const double drawn = view_.near_distance;
    if (!view_.is_perspective) return hides >= drawn;  // n = m
    const auto does = [&](double share) {
      const double rounded = kProductRounded * (1 + share) * extent_.length;
      const double least = extent_.least(n - share * m) - rounded;
      return share * hides + std::min(least, 0.0) * frame_.depth >= drawn;
    };
    return does(1) || (hides > 0 && drawn > 0 && does((1 + kProductRounded) * drawn / hides));
  }

  const FrameView& frame_;
  EyeRegion frame_eyes_, eyes_;
  FrameView view_;  ///< of the camera's own eye
  Extent extent_;
  glm::dvec3 from_eye_;  ///< of the frame
  double eye_error_;
};

template <class AnyCamera>
bool holds_for_any(const FrameView& frame, const AnyCamera& camera, double eye_error) {
  require_sound(camera);
  const AnyCamera* const same = std::get_if<AnyCamera>(&frame.any_camera);
  if (same != nullptr && *same == camera && eye_error == 0) return true;
  const Question question(frame, camera, eye_error);
  return question.holds();
}

}  // namespace

bool holds_for(const FrameView& frame, const Camera& camera, double eye_error) {
  return holds_for_any(frame, camera, eye_error);
}
bool holds_for(const FrameView& frame, const MatrixCamera& camera) { return holds_for_any(frame, camera, 0); }

}  // namespace occlude::culler
