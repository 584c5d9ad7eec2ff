// SPDX-License-Identifier: MIT
// Why six sides of a box stand for all eyes outside of the hull of a model in it: a line from a point of the hull through an
// eye that is not in it never comes back, and somewhere it, or the segment before the eye, crosses a side of the box. What
// hides the point from there is in the hull, so it is before the eye.
#include "hidden_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "cases/case_line.h"
#include "cases/to_oracle.h"
#include "cover_line.h"
#include "occlude/oracle/closed_shell.h"

namespace occlude::proof {
namespace {

using Json = nlohmann::json;

/// "min" and "max". Numbers that there are not, and boxes without a point, are refused.
kernel::Aabb box_in(const Json& value, const char* name) {
  const kernel::Aabb box{vec3(member(value, "min"), name), vec3(member(value, "max"), name)};
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(box.min[axis]) || !std::isfinite(box.max[axis]) || box.min[axis] > box.max[axis])
      throw LineError(std::string("\"") + name + "\": no box");
  }
  return box;
}

bool holds(const kernel::Aabb& box, const oracle::Point& point) { return oracle::contains(to_oracle(box), point); }

bool hold(const Eyes& eyes, const kernel::Aabb& box) {
  for (unsigned i = 0; i < 8; ++i) {
    const auto end = [&](unsigned axis) { return (i >> axis & 1U ? box.max : box.min)[static_cast<int>(axis)]; };
    if (!contains(*eyes, {end(0), end(1), end(2)})) return false;
  }
  return true;
}

std::vector<kernel::Aabb> sides_of(const kernel::Aabb& box) {
  std::vector<kernel::Aabb> sides(6, box);
  for (int axis = 0; axis < 3; ++axis) {
    sides[static_cast<std::size_t>(2 * axis)].max[axis] = box.min[axis];
    sides[static_cast<std::size_t>(2 * axis) + 1].min[axis] = box.max[axis];
  }
  return sides;
}

const Json& list_in(const Json& object, const char* name) {
  const Json& list = member(object, name);
  if (!list.is_array()) throw LineError(std::string("\"") + name + "\": expected a list");
  return list;
}

HiddenLine failed(std::string why) {
  HiddenLine line;
  line.failure = std::move(why);
  return line;
}

/// The parts of the box on the two sides of a face of the other that comes into it. None where none does.
std::optional<std::array<kernel::Aabb, 2>> parted(const kernel::Aabb& box, const kernel::Aabb& other) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double at : {other.min[axis], other.max[axis]}) {
      if (!(box.min[axis] < at && at < box.max[axis])) continue;
      std::array<kernel::Aabb, 2> parts{box, box};
      parts[0].max[axis] = parts[1].min[axis] = at;
      return parts;
    }
  }
  return std::nullopt;
}

/// Whether the other has points of the box beside those of its borders. A flat box is all border across its plane.
bool comes_into(const kernel::Aabb& other, const kernel::Aabb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_flat = box.min[axis] == box.max[axis];
    if (is_flat ? other.max[axis] < box.min[axis] || other.min[axis] > box.max[axis]
                : other.max[axis] <= box.min[axis] || other.min[axis] >= box.max[axis])
      return false;
  }
  return true;
}

}  // namespace

bool is_claim(std::string_view line) { return parse_object(line).contains("claim"); }

bool is_covered(const kernel::Aabb& box, const std::vector<kernel::Aabb>& by) {
  std::vector<kernel::Aabb> near;
  std::ranges::copy_if(by, std::back_inserter(near), [&](const kernel::Aabb& other) { return comes_into(other, box); });
  if (near.empty()) return false;
  for (const kernel::Aabb& other : near) {
    if (!parted(box, other)) return true;
  }
  const auto parts = *parted(box, near.front());
  return is_covered(parts[0], near) && is_covered(parts[1], near);
}

HiddenLine HiddenProver::prove(std::string_view line) const {
  const Json object = parse_object(line);
  if (object.contains("claim")) return claim(object);
  return object.contains("shell") ? by_shell(object) : by_cover(object);
}

HiddenLine HiddenProver::claim(const Json& object) const {
  HiddenLine line;
  line.is_claim = true;
  HiddenClaim& claim = line.claim;
  std::size_t end = 0;
  for (const Json& run : list_in(object, "claim")) {
    const auto [first, count] = claim.faces.emplace_back(run_of(run, "claim"));
    if (first < end || count > polygons_.faces() || first > polygons_.faces() - count)
      throw LineError("\"claim\": no such polygons, or not in ascending order");
    end = first + count;
  }
  claim.is_outside = object.contains("outside");
  if (claim.is_outside == object.contains("from")) throw LineError("expected \"from\" or \"outside\"");
  if (object.contains("touching")) {
    if (!claim.is_outside || !object["touching"].is_boolean())
      throw LineError("\"touching\": true or false, of \"outside\"");
    claim.may_touch = object["touching"].get<bool>();
  }
  if (!claim.is_outside) {
    for (const Json& box : list_in(object, "from")) claim.from.push_back(box_in(box, "from"));
    return line;
  }
  const kernel::Aabb around = box_in(object["outside"], "outside");
  const culler::SoupView soup = polygons_.hierarchy().soup();
  const auto is_in = [&](std::uint32_t index) {
    const glm::dvec3& v = soup.vertices[index];
    return holds(around, {v.x, v.y, v.z});
  };
  if (!std::ranges::all_of(soup.indices, is_in)) throw LineError("\"outside\": a part of the model is outside of the box");
  claim.from = sides_of(around);
  return line;
}

HiddenLine HiddenProver::by_cover(const Json& object) const {
  HiddenLine line;
  line.from = box_in(member(object, "from"), "from");
  const kernel::Aabb box = box_in(member(object, "box"), "box");
  for (const Json& name : list_in(object, "hidden")) {
    const std::optional<std::uint32_t> p = polygons_.named(name);
    if (!p) return failed("no such polygon");
    const auto is_in = [&](const oracle::Point& corner) { return holds(box, corner); };
    if (!std::ranges::all_of(polygons_.loop(*p), is_in)) return failed("a polygon is not in the box");
    line.polygons.push_back(*p);
  }
  const oracle::HalfSpaceCoefficients drawn = four_numbers(object, "drawn");
  if (const Eyes eyes = eyes_in(object)) {
    line.failure = hold(eyes, line.from) ? fault_of_windows(*eyes, object, drawn, to_oracle(box), polygons_)
                                         : "an eye is not in the region";
    return line;
  }
  const oracle::Viewpoint eye = to_oracle(viewpoint(object));
  const bool is_same = !eye.at_infinity && to_oracle(line.from.min) == eye.value && to_oracle(line.from.max) == eye.value;
  line.failure =
      is_same ? fault_of_polygons(eye, object, drawn, to_oracle(box), polygons_) : "the eye is not all of the box";
  return line;
}

HiddenLine HiddenProver::by_shell(const Json& object) const {
  std::vector<oracle::Triangle> triangles;
  for (const Json& name : list_in(object, "shell")) {
    const std::optional<std::uint32_t> p = polygons_.named(name);
    if (!p) return failed("no such polygon");
    const culler::SoupView soup = polygons_.hierarchy().soup();
    if (!soup.is_opaque(*p)) return failed("a see-through polygon hides nothing");
    for (std::uint32_t k = 1; k + 1 < soup.loop(*p).size(); ++k) triangles.push_back(polygons_.triangle({*p, k}));
  }
  const oracle::ClosedShell shell(triangles);
  if (!shell.fault().empty()) return failed(shell.fault());
  HiddenLine line;
  for (const Json& name : list_in(object, "hidden")) {
    const std::optional<culler::FanTriangle> named = polygons_.named_triangle(name);
    if (!named) return failed("no such triangle");
    const oracle::Triangle triangle = polygons_.triangle(*named);
    if (shell.refute_inside(triangle, false).empty()) {
      line.well_inside.push_back(*named);
    } else if (std::string why = shell.refute_inside(triangle, true); why.empty()) {
      line.inside.push_back(*named);
    } else {
      return failed(std::move(why));
    }
  }
  return line;
}

}  // namespace occlude::proof
