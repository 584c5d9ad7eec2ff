// SPDX-License-Identifier: MIT
#include "occlude/culler/simplified_occluders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/for_ranges.h"
#include "frusta/solid_angle.h"
#include "model/adjacency.h"
#include "model/legal_soup.h"
#include "occlude/kernel/validity.h"
#include "simplify/flat_mesh.h"

namespace occlude::culler {
namespace {

/// A triangle to choose, where it comes from, and what it is chosen for.
struct Offer {
  std::array<glm::dvec3, 3> corners;
  OccluderOrigin origin;
  double size = 0;
};

double size_of(const std::array<glm::dvec3, 3>& corners, std::span<const glm::dvec3> eyes) {
  const auto& [a, b, c] = corners;
  if (eyes.empty()) return glm::length(glm::cross(b - a, c - a));
  double sum = 0;
  for (const glm::dvec3& eye : eyes) sum += std::fabs(solid_angle(a - eye, b - eye, c - eye));
  return sum;
}

void require_finite(std::span<const glm::dvec3> eyes) {
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (kernel::check(eyes[i][axis]) != kernel::Refusal::not_finite) continue;
      throw std::invalid_argument("eye " + std::to_string(i) + ": number is not finite");
    }
  }
}

void add_boxes(std::span<const InnerBox> boxes, std::vector<Offer>& offers) {
  const PolygonSoup faces = soup_of(boxes);
  const std::size_t of_box = boxes.empty() ? 1 : faces.size() / boxes.size();
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const auto loop = faces.loop(face);
    const auto box = static_cast<std::uint32_t>(face / of_box);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      offers.push_back(
          {{faces.vertices[loop[0]], faces.vertices[loop[i]], faces.vertices[loop[i + 1]]}, {boxes[box].polygon, box}});
    }
  }
}

/// The first of so many offers, over vertices that they share.
void add_triangles(std::span<const Offer> offers, SimplifiedOccluders& result, const Checkpoint& checkpoint) {
  std::vector<glm::dvec3> corners;
  for (const Offer& offer : offers) corners.insert(corners.end(), offer.corners.begin(), offer.corners.end());
  std::vector<std::uint32_t> numbers = welded(corners, checkpoint);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool is_first = numbers[i] == i;
    numbers[i] = is_first ? result.soup.add_vertex(corners[i]) : numbers[numbers[i]];
  }
  for (std::size_t t = 0; t < offers.size(); ++t) {
    result.soup.add_polygon(std::span(numbers).subspan(3 * t, 3));
    result.origins.push_back(offers[t].origin);
  }
}

/// Leaves out the boxes that no triangle is of.
void keep_used(std::span<const InnerBox> boxes, SimplifiedOccluders& result) {
  std::vector<std::uint32_t> numbers(boxes.size(), OccluderOrigin::kNoBox);
  for (OccluderOrigin& origin : result.origins) {
    if (origin.box == OccluderOrigin::kNoBox) continue;
    std::uint32_t& number = numbers[origin.box];
    if (number == OccluderOrigin::kNoBox) {
      number = static_cast<std::uint32_t>(result.boxes.size());
      result.boxes.push_back(boxes[origin.box]);
    }
    origin.box = number;
  }
}

}  // namespace

SimplifiedOccluders simplified_occluders(SoupView soup, const SimplifyOptions& options, const Checkpoint& checkpoint) {
  require_legal(soup);
  require_finite(options.eyes);
  FlatMesh mesh(soup, checkpoint);
  SimplifiedOccluders result;
  result.drawn_triangles = mesh.size();
  mesh.simplify(checkpoint);
  result.flat_triangles = mesh.size();

  std::vector<Offer> offers;
  for (const FlatTriangle& triangle : mesh.triangles()) {
    const auto at = [&](std::size_t i) { return soup.vertices[triangle.corners[i]]; };
    offers.push_back({{at(0), at(1), at(2)}, {triangle.polygon, OccluderOrigin::kNoBox}});
  }
  std::vector<InnerBox> boxes;
  if (options.boxes.boxes > 0) boxes = find_inner_boxes(soup, options.boxes, {}, checkpoint).boxes;
  add_boxes(boxes, offers);
  const auto measure = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) offers[i].size = size_of(offers[i].corners, options.eyes);
  };
  for_ranges(offers.size(), measure, checkpoint);
  std::ranges::stable_sort(offers, std::ranges::greater(), &Offer::size);
  offers.resize(std::min(offers.size(), options.triangles));
  add_triangles(offers, result, checkpoint);
  keep_used(boxes, result);
  return result;
}

}  // namespace occlude::culler
