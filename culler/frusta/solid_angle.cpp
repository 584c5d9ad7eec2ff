// SPDX-License-Identifier: MIT
#include "frusta/solid_angle.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace occlude::culler {
namespace {

/// The solid angle of a loop of vertices: the sum over its fan.
double solid_angle_of(SoupView soup, std::span<const std::uint32_t> loop, const glm::dvec3& eye) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += solid_angle(soup.vertices[loop[0]] - eye, soup.vertices[loop[i]] - eye, soup.vertices[loop[i + 1]] - eye);
  }
  return std::fabs(sum);
}

double exact_solid_angle(const PotentialOccluders& occluders, std::uint32_t i, const glm::dvec3& eye) {
  const SoupView soup = occluders.soup();
  if (!occluders.is_shell(i)) return solid_angle_of(soup, occluders.loop(i), eye);
  double sum = 0;
  for (const std::uint32_t p : occluders.parts(i)) sum += solid_angle_of(soup, soup.loop(p), eye);
  return sum / 2;  // every line of sight that enters a convex solid leaves it
}

}  // namespace

double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double cosine = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2 * std::atan2(glm::dot(a, glm::cross(b, c)), cosine);
}

double seen_size(const PotentialOccluders& occluders, std::uint32_t i, const FrameView& view, Objective::Angle angle) {
  const PotentialOccluder& known = occluders[i];
  if (!view.is_perspective) {
    const double projected = std::fabs(glm::dot(known.area_normal, view.axes.forward)) + known.round_area;
    return projected / view.area;
  }
  return angle == Objective::Angle::area ? known.area_angle(view.eye) : exact_solid_angle(occluders, i, view.eye);
}

}  // namespace occlude::culler
