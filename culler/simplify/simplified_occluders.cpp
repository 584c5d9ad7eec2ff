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
#include "simplify/flat_mesh.h"
#include "simplify/inset_parts.h"
#include "simplify/shares_of_hiding.h"

namespace occlude::culler {
namespace {

/// A triangle to choose, where it comes from, and what it is chosen for.
struct Offer {
  std::array<glm::dvec3, 3> corners;
  OccluderOrigin origin;
  double share = 0;  ///< of what is hidden in the views
  double size = 0;
};

/// How large it looks from the eyes of the views, all together; its area if there are none.
double size_of(const std::array<glm::dvec3, 3>& corners, std::span<const Camera> views) {
  const auto& [a, b, c] = corners;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  if (views.empty()) return glm::length(normal);
  double sum = 0;
  for (const Camera& view : views) {
    const glm::dvec3& eye = view.eye;
    sum += std::fabs(view.projection == Projection::perspective ? solid_angle(a - eye, b - eye, c - eye)
                                                                : glm::dot(normal, glm::normalize(view.target - eye)));
  }
  return sum;
}

void require_sound(std::span<const Camera> views) {
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (const std::string reason = fault(views[i]); !reason.empty())
      throw std::invalid_argument("view " + std::to_string(i) + ": " + reason);
  }
}

PolygonSoup soup_of(std::span<const Offer> offers) {
  PolygonSoup soup;
  for (const Offer& offer : offers) {
    std::array<std::uint32_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = soup.add_vertex(offer.corners[i]);
    soup.add_polygon(corners);
  }
  return soup;
}

void measure(std::vector<Offer>& offers, std::span<const Camera> views, const Checkpoint& checkpoint) {
  const std::vector<double> shares = shares_of_hiding(soup_of(offers), views, checkpoint);
  const auto measure_some = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      offers[i].share = shares[i];
      offers[i].size = size_of(offers[i].corners, views);
    }
  };
  for_ranges(offers.size(), measure_some, checkpoint);
}

/// The flat triangles, but for parts that do with others inside of them.
void add_surfaces(SoupView soup, std::span<const FlatTriangle> flat, double inset, const Checkpoint& checkpoint,
                  std::vector<Offer>& offers) {
  std::vector<std::size_t> needed(soup.size());
  for (const FlatTriangle& triangle : flat) ++needed[triangle.polygon];
  if (inset > 0) {
    for (const InsetPart& part : inset_parts(soup, inset, needed, checkpoint)) {
      for (const std::uint32_t p : part.polygons) needed[p] = 0;
      for (const auto& corners : part.triangles)
        offers.push_back({corners, {.polygon = part.polygons[0], .is_inside = true}});
    }
  }
  for (const FlatTriangle& triangle : flat) {
    const auto at = [&](std::size_t i) { return soup.vertices[triangle.corners[i]]; };
    if (needed[triangle.polygon] > 0) offers.push_back({{at(0), at(1), at(2)}, {.polygon = triangle.polygon}});
  }
}

void add_boxes(std::span<const InnerBox> boxes, std::vector<Offer>& offers) {
  const PolygonSoup faces = soup_of(boxes);
  const std::size_t of_box = boxes.empty() ? 1 : faces.size() / boxes.size();
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const auto loop = faces.loop(face);
    const auto box = static_cast<std::uint32_t>(face / of_box);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      offers.push_back({{faces.vertices[loop[0]], faces.vertices[loop[i]], faces.vertices[loop[i + 1]]},
                        {boxes[box].polygon, box, true}});
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
  require_sound(options.views);
  FlatMesh mesh(soup, checkpoint);
  SimplifiedOccluders result;
  result.drawn_triangles = mesh.size();
  mesh.simplify(checkpoint);
  result.flat_triangles = mesh.size();

  std::vector<Offer> offers;
  add_surfaces(soup, mesh.triangles(), options.inset, checkpoint, offers);
  std::vector<InnerBox> boxes;
  if (options.boxes.boxes > 0) boxes = find_inner_boxes(soup, options.boxes, {}, checkpoint).boxes;
  add_boxes(boxes, offers);
  measure(offers, options.views, checkpoint);
  std::ranges::stable_sort(offers, std::ranges::greater(), [](const Offer& o) { return std::pair(o.share, o.size); });
  offers.resize(std::min(offers.size(), options.triangles));
  add_triangles(offers, result, checkpoint);
  keep_used(boxes, result);
  return result;
}

}  // namespace occlude::culler
