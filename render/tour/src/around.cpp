// SPDX-License-Identifier: MIT
#include "around.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace occlude::render {
namespace {

using glm::dvec3;

constexpr double kStart = -2 * std::numbers::pi / 3;  // between the front and the left of a model that faces -y
constexpr int kPoses = 360;
constexpr int kRoundFrames = 200;  // with a flight after it; alone it takes all frames
// The eye looks down by 25 degrees, 12 more at one side and 12 less at the other.
constexpr double kDown = 25 * std::numbers::pi / 180, kSway = 12 * std::numbers::pi / 180;
// A picture of 60 degrees: tan 30 to top and bottom, and 16 ninths of that to the sides.
constexpr double kTop = 0.57735026918962576, kSide = kTop * 16 / 9;
constexpr double kOutside = 1.1;  // of the radius of the sphere around the model

/// From the middle of the model to the eye.
dvec3 direction(double turn, double yaw) {
  const double down = kDown + kSway * std::sin(turn);
  return {std::cos(yaw + turn) * std::cos(down), std::sin(yaw + turn) * std::cos(down), std::sin(down)};
}

/// From how far away in this direction a corner, given from the middle, is in the picture.
double distance_for(const dvec3& corner, const dvec3& direction) {
  const dvec3 right = glm::normalize(glm::cross(dvec3(0, 0, 1), direction)), up = glm::cross(direction, right);
  const double beside = std::max(std::fabs(glm::dot(corner, right)) / kSide, std::fabs(glm::dot(corner, up)) / kTop);
  return glm::dot(corner, direction) + beside;
}

double distance(const Place& place, double yaw) {
  double most = kOutside * place.radius;
  for (int i = 0; i < kPoses; ++i) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const dvec3 sides(corner & 1U ? 1 : -1, corner & 2U ? 1 : -1, corner & 4U ? 1 : -1);
      most = std::max(most, distance_for(0.5 * sides * place.size(), direction(2 * std::numbers::pi * i / kPoses, yaw)));
    }
  }
  return most;
}

}  // namespace

std::vector<Pose> round(const Place& place, double yaw) {
  const double far = distance(place, yaw);
  const dvec3 middle = 0.5 * (place.low + place.high);
  std::vector<Pose> poses;
  for (int i = 0; i <= kPoses; ++i) {
    const dvec3 eye = middle + far * direction(2 * std::numbers::pi * i / kPoses, yaw);
    poses.push_back(pose(eye, middle, 0, 2 * std::numbers::pi * far / kRoundFrames));
  }
  return poses;
}

std::optional<CameraPath> around(const Place& place) {
  // The eye keeps a tenth of the radius from the sphere; half of that is free whatever is rounded.
  return film(place, round(place, kStart), (kOutside - 1) / 2 * place.radius);
}

}  // namespace occlude::render
