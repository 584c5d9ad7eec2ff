// SPDX-License-Identifier: MIT
#include "model_builder.h"

#include <algorithm>
#include <cmath>

#include "occlude/kernel/orientation.h"
#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

/// Whether three corners certainly are no line, as seen along one axis or another. The error of a difference of two products
/// of differences is below 4 * 2^-53 of the sum of their magnitudes (Shewchuk, Adaptive Precision Floating-Point
/// Arithmetic, 4.4).
bool is_surely_no_line(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  constexpr double kError = 0x1p-51;
  const glm::dvec3 u = b - a, v = c - a;
  const auto has_area = [&](int i, int j) {
    const double left = u[i] * v[j], right = u[j] * v[i];
    return std::fabs(left - right) > kError * (std::fabs(left) + std::fabs(right));
  };
  return has_area(0, 1) || has_area(1, 2) || has_area(2, 0);
}

}  // namespace

bool has_no_area(culler::SoupView soup, std::span<const std::uint32_t> loop) {
  const auto corner = [&](std::size_t i) {
    const glm::dvec3& v = soup.vertices[loop[i]];
    return kernel::Vec3{v.x, v.y, v.z};
  };
  if (is_surely_no_line(soup.vertices[loop[0]], soup.vertices[loop[1]], soup.vertices[loop[2]])) return false;
  std::size_t other = 1;
  while (other < loop.size() && corner(other) == corner(0)) ++other;
  for (std::size_t i = other + 1; i < loop.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (kernel::turn(axis, corner(0), corner(other), corner(i)) != 0) return false;
    }
  }
  return true;
}

void ModelBuilder::add_face(std::span<const std::uint32_t> loop, const Surface& surface) {
  if (loop.size() < 3) {
    ++model_.notes.few_corners;
    return;
  }
  if (!faults_.empty()) require_sound(loop);
  if (is_used_.size() < vertices()) is_used_.resize(vertices());
  for (const std::uint32_t vertex : loop) is_used_[vertex] = 1;
  culler::PolygonSoup& soup = model_.soup;
  const std::size_t first = soup.size();
  switch (soup.add_face(loop)) {
    case culler::FaceShape::fan:
      break;
    case culler::FaceShape::pieces:
      ++model_.notes.triangulated;
      break;
    case culler::FaceShape::crossing:
      ++model_.notes.crossing;
      break;
  }
  if (has_no_area(soup, loop)) ++model_.notes.without_area;
  if (!surface.is_opaque) soup.see_through_from(first);
  if (with_colours_) colour_from(first, surface.colour);
}

void ModelBuilder::colour_from(std::size_t first, const Rgb& colour) {
  std::vector<Rgb>& colours = model_.colours;
  if (colours.empty() && colour == kWhite) return;
  colours.resize(first, kWhite);
  colours.resize(model_.soup.size(), colour);
}

void ModelBuilder::reserve(std::size_t vertices, std::size_t faces) {
  model_.soup.vertices.reserve(vertices);
  model_.soup.indices.reserve(3 * faces);
  model_.soup.first.reserve(faces + 1);
}

Model ModelBuilder::finish(const std::filesystem::path& file) {
  if (model_.soup.empty()) throw InputError(file.string() + ": no polygons");
  leave_out_unused();
  model_.notes.unsound_vertices = faults_.size();
  if (model_.notes.tiny_numbers != 0) require_coarse(file, model_.soup);
  return std::move(model_);
}

void ModelBuilder::require_sound(std::span<const std::uint32_t> loop) const {
  for (const std::uint32_t vertex : loop) {
    const auto found = std::ranges::lower_bound(faults_, vertex, {}, &Fault::vertex);
    if (found != faults_.end() && found->vertex == vertex) throw InputError(found->message);
  }
}

void ModelBuilder::leave_out_unused() {
  culler::PolygonSoup& soup = model_.soup;
  is_used_.resize(vertices());
  const auto unused = static_cast<std::size_t>(std::ranges::count(is_used_, 0));
  if (unused == 0) return;
  model_.notes.unused_vertices += unused;
  std::vector<std::uint32_t> place(vertices());
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (is_used_[v] == 0) continue;
    soup.vertices[kept] = soup.vertices[v];
    place[v] = kept++;
  }
  soup.vertices.resize(kept);
  for (std::uint32_t& index : soup.indices) index = place[index];
}

}  // namespace occlude::render
