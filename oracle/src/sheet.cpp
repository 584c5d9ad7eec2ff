// SPDX-License-Identifier: MIT
#include "sheet.h"

#include <algorithm>
#include <set>

#include "faults.h"
#include "half_spaces.h"

namespace occlude::oracle {
namespace {

/// Elements modulo 2: one that is added twice is gone.
template <class T>
void toggle(std::set<T>& elements, const T& element) {
  if (!elements.insert(element).second) elements.erase(element);
}

std::string fault_of(const std::vector<Loop>& polygons, const std::optional<HalfSpaceCoefficients>& drawn) {
  for (const Loop& polygon : polygons) {
    if (std::string reason = range_fault(polygon); !reason.empty()) return reason;
    if (polygon.size() < 3) return "a polygon has fewer than 3 vertices";
  }
  return drawn ? plane_fault(*drawn) : "";
}

/// Leaves out what is not drawn. A triangle that begins before the plane ends on it with an edge, or with one that it has
/// there, which may be that of another triangle and then counts once less.
void cut(Sheet::Prepared& sheet) {
  Plane plane(CoefficientPlane{*sheet.drawn});
  const auto reaches = [&](CGAL::Sign least) {
    return [&plane, least](const auto& corners) {
      return std::ranges::any_of(corners, [&](const Point& corner) { return plane.side(corner) >= least; });
    };
  };
  const auto is_before = [&](const Triangle& triangle) {
    return std::ranges::any_of(triangle, [&](const Point& corner) { return plane.side(corner) == CGAL::NEGATIVE; });
  };
  for (const Triangle& triangle : sheet.triangles) {
    if (is_before(triangle) && reaches(CGAL::ZERO)(triangle)) sheet.cut.push_back(triangle);
  }
  std::erase_if(sheet.triangles, [&](const Triangle& t) { return is_before(t) && !reaches(CGAL::POSITIVE)(t); });
  std::erase_if(sheet.border, std::not_fn(reaches(CGAL::ZERO)));
}

void prepare(Sheet::Prepared& sheet) {
  std::set<Triangle> triangles;
  std::set<std::array<Point, 2>> border;
  for (const Loop& polygon : sheet.polygons) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      Triangle triangle{polygon[0], polygon[i], polygon[i + 1]};
      std::ranges::sort(triangle);
      toggle(triangles, triangle);
      const auto& [a, b, c] = triangle;
      if (a != b) toggle(border, {a, b});
      if (b != c) toggle(border, {b, c});
      if (a != c) toggle(border, {a, c});
    }
  }
  sheet.triangles.assign(triangles.begin(), triangles.end());
  sheet.border.assign(border.begin(), border.end());
  if (sheet.drawn) cut(sheet);
}

}  // namespace

Sheet::Sheet(const std::vector<Loop>& polygons, const std::optional<HalfSpaceCoefficients>& drawn) {
  const RoundUpward rounding;
  const auto prepared = std::make_shared<Prepared>(Prepared{polygons, drawn, fault_of(polygons, drawn), {}, {}, {}});
  if (prepared->fault.empty()) prepare(*prepared);
  prepared_ = prepared;
}

const std::vector<Loop>& Sheet::polygons() const { return prepared_->polygons; }
const std::optional<HalfSpaceCoefficients>& Sheet::drawn() const { return prepared_->drawn; }

}  // namespace occlude::oracle
