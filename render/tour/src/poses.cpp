// SPDX-License-Identifier: MIT
#include "poses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "free_way.h"

namespace occlude::render {
namespace {

using glm::dvec3;

constexpr double kFrames = 300;                            // ten seconds at 30 frames a second
constexpr double kTurn = 5 * std::numbers::pi / 180;       // the head turns by at most 5 degrees in a frame
constexpr int kSmooth = 8;                                 // and takes a quarter of a second to begin
constexpr double kSteepest = 70 * std::numbers::pi / 180;  // `up` must not be the line of sight

/// The same angle within half a turn of `other`.
double near_to(double angle, double other) { return other + std::remainder(angle - other, 2 * std::numbers::pi); }

/// How many frames it takes from one pose to the next.
double frames_between(const Pose& a, const Pose& b) {
  const double turn = std::max(std::fabs(b.yaw - a.yaw), std::fabs(b.pitch - a.pitch));
  return std::max(glm::distance(a.eye, b.eye) / a.stride, turn / kTurn);
}

Pose between(const Pose& a, const Pose& b, double t) {
  return {(1 - t) * a.eye + t * b.eye, (1 - t) * a.yaw + t * b.yaw, (1 - t) * a.pitch + t * b.pitch, a.stride};
}

/// Poses at equal times. REQUIRES: yaws that follow one another differ by the turn meant.
std::vector<Pose> at_frames(const std::vector<Pose>& poses) {
  std::vector<double> time{0};
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) time.push_back(time.back() + frames_between(poses[i], poses[i + 1]));
  const auto steps = static_cast<std::size_t>(std::ceil(std::max(kFrames - 1.0, time.back())));
  std::vector<Pose> result;
  for (std::size_t frame = 0, i = 0; frame <= steps; ++frame) {
    const double now = time.back() * static_cast<double>(frame) / static_cast<double>(steps);
    while (i + 2 < poses.size() && time[i + 1] < now) ++i;
    const double length = time[i + 1] - time[i];
    result.push_back(between(poses[i], poses[i + 1], length > 0 ? std::clamp((now - time[i]) / length, 0.0, 1.0) : 1));
  }
  return result;
}

/// Each value becomes the mean of those around it.
void smooth(std::vector<double>& values) {
  const std::vector<double> before = values;
  const auto last = static_cast<int>(values.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    const int reach = std::min({kSmooth, i, last - i});
    double sum = 0;
    for (int k = i - reach; k <= i + reach; ++k) sum += before[static_cast<std::size_t>(k)];
    values[static_cast<std::size_t>(i)] = sum / (2 * reach + 1);
  }
}

void smooth_turns(std::vector<Pose>& poses) {
  for (double Pose::*angle : {&Pose::yaw, &Pose::pitch}) {
    std::vector<double> values;
    for (const Pose& pose : poses) values.push_back(pose.*angle);
    smooth(values);
    smooth(values);
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i].*angle = values[i];
  }
}

dvec3 sight(const Pose& pose) {
  const double pitch = std::clamp(pose.pitch, -kSteepest, kSteepest);
  return {std::cos(pose.yaw) * std::cos(pitch), std::sin(pose.yaw) * std::cos(pitch), std::sin(pitch)};
}

/// Few digits, which do not depend on how functions round, and legal numbers: multiples of a power of two, of 1.6 mm for a
/// person's eye.
dvec3 rounded(const dvec3& p, double eye_height) {
  const double unit = std::max(std::exp2(std::floor(std::log2(eye_height / 1024))), 0x1p-100);
  return {std::round(p.x / unit) * unit, std::round(p.y / unit) * unit, std::round(p.z / unit) * unit};
}

}  // namespace

Pose pose(const dvec3& eye, const dvec3& target, double yaw, double stride) {
  const dvec3 d = target - eye;
  const double level = std::hypot(d.x, d.y);
  return {eye, level > 0 ? std::atan2(d.y, d.x) : yaw, d == dvec3(0) ? 0 : std::atan2(d.z, level), stride};
}

std::vector<Pose> looking_ahead(const std::vector<dvec3>& points, double ahead, double stride) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < points.size(); ++i) along.push_back(along.back() + glm::distance(points[i - 1], points[i]));
  std::vector<Pose> poses;
  for (std::size_t i = 0, k = 0; i < points.size(); ++i) {
    while (k + 1 < points.size() && along[k] < along[i] + ahead) ++k;
    const bool is_end = along[k] < along[i] + ahead;
    if (is_end && !poses.empty()) {
      poses.push_back(poses.back());
      poses.back().eye = points[i];
    } else {
      poses.push_back(pose(points[i], points[k], poses.empty() ? 0 : poses.back().yaw, stride));
    }
  }
  return poses;
}

std::optional<CameraPath> film(const Place& place, const std::vector<Pose>& poses, double clearance) {
  std::vector<Pose> turned = poses;
  for (std::size_t i = 1; i < turned.size(); ++i) turned[i].yaw = near_to(turned[i].yaw, turned[i - 1].yaw);
  std::vector<Pose> frames = at_frames(turned);
  smooth_turns(frames);

  CameraPath path;
  path.frames = frames.size();
  path.up = place.axes[2];
  const double reach = 3 * place.eye_height;  // targets this far away
  for (const Pose& frame : frames) {
    const dvec3 eye = place.in_model(frame.eye), target = place.in_model(frame.eye + reach * sight(frame));
    path.keyframes.push_back({rounded(eye, place.eye_height), rounded(target, place.eye_height)});
  }
  // A corner of the near plane is at most twice as far as the plane where 1 + (1 + a^2) tan^2 30 <= 4: for aspects a up to
  // 2.8.
  path.near = std::max(clearance, 0x1p-100) / 2;
  for (std::size_t frame = 0; frame < path.frames; ++frame) {
    if (!culler::fault(path.camera(frame, 1)).empty()) return std::nullopt;
  }
  if (!is_free_way(place.soup, path.keyframes, clearance)) return std::nullopt;
  return path;
}

}  // namespace occlude::render
