// SPDX-License-Identifier: MIT
#include "proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "border.h"
#include "cases/case_line.h"
#include "cases/to_oracle.h"
#include "cover_line.h"
#include "occlude/culler/cull_result.h"

namespace occlude::proof {
namespace {

using Json = nlohmann::json;

bool contains(const kernel::Aabb& outer, const kernel::Aabb& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (inner.min[axis] < outer.min[axis] || inner.max[axis] > outer.max[axis]) return false;
  }
  return true;
}

oracle::Near near_of(const Json& near) {
  if (near == "farthest") return to_oracle(kernel::Near::farthest);
  if (near == "surface") return to_oracle(kernel::Near::surface);
  if (!near.is_object()) throw LineError("\"near\": expected \"farthest\", \"surface\" or an object");
  return {oracle::Near::Kind::plane, to_oracle(vec3(member(near, "normal"), "normal")),
          to_oracle(vec3(member(near, "point"), "point"))};
}

const Json& occluders_of(const Json& object) {
  const Json& occluders = member(object, "occluders");
  const bool is_one_or_two = occluders.is_array() && (occluders.size() == 1 || occluders.size() == 2);
  if (!is_one_or_two) throw LineError("\"occluders\": expected one occluder or two");
  return occluders;
}

/// The shadow of one of the occluders on the line. Its near side is its own if it has one, else that of the line.
oracle::Shadow shadow_of(const kernel::Viewpoint& view, const Json& described, const Json& line) {
  const Json& near = member(described.contains("near") ? described : line, "near");
  return {to_oracle(view), to_oracle(occluder(described)), near_of(near)};
}

/// The polygons of the model that an occluder consists of.
std::vector<Polygon> polygons_of(const Occluder& occluder) {
  if (const Polygon* polygon = std::get_if<Polygon>(&occluder)) return {*polygon};
  const auto& [vertices, faces] = std::get<kernel::Polytope>(occluder);
  std::vector<Polygon> polygons;
  for (const auto& face : faces) {
    Polygon& polygon = polygons.emplace_back();
    for (const std::uint32_t index : face) {
      if (index >= vertices.size()) throw LineError("\"faces\": a vertex that does not exist");
      polygon.push_back(vertices[index]);
    }
  }
  return polygons;
}

/// 0 when the witness has no margin.
double margin_of(const Json& object) {
  if (!object.contains("margin")) return 0;
  const double margin = number(object["margin"], "margin");
  if (!(margin >= 0) || !std::isfinite(margin)) throw LineError("\"margin\": expected a number from 0");
  return margin;
}

std::array<double, 3> key(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

std::array<double, 3> key(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

/// A frame that holds for a region is proved for that region, and for no less.
std::string fault_of_eyes(const Eyes& eyes, const AnyCamera& camera) {
  const Eyes own = eyes_of(camera);
  if (!own || viewpoint_of(camera).at_infinity) return "";
  if (!eyes) return "the frame holds for a region of eyes, and the line is of one";
  return eyes == own ? "" : "the eyes are not the frame's";
}

/// Compares polygons vertex by vertex. A polygon is given by its index in the soup or by its vertices.
struct LessByVertices {
  culler::SoupView soup;

  bool operator()(std::uint32_t a, std::uint32_t b) const { return less(soup.loop(a), soup.loop(b)); }
  bool operator()(std::uint32_t a, const Polygon& b) const { return less(soup.loop(a), b); }
  bool operator()(const Polygon& a, std::uint32_t b) const { return less(a, soup.loop(b)); }

 private:
  [[nodiscard]] std::array<double, 3> corner(std::uint32_t index) const { return key(soup.vertices[index]); }
  [[nodiscard]] static std::array<double, 3> corner(const kernel::Vec3& v) { return key(v); }
  [[nodiscard]] bool less(const auto& a, const auto& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [&](const auto& v, const auto& w) { return corner(v) < corner(w); });
  }
};

/// None when the line does not say it.
std::optional<std::uint32_t> leaf_size_in(const Json& object) {
  if (!object.contains("leaf")) return std::nullopt;
  const Json& leaf = object["leaf"];
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (!leaf.is_number_unsigned() || leaf.get<std::uint64_t>() == 0 || leaf.get<std::uint64_t>() > kMost) {
    throw LineError("\"leaf\": expected a whole number from 1");
  }
  return leaf.get<std::uint32_t>();
}

std::uint64_t key(std::size_t first, std::size_t count) { return (static_cast<std::uint64_t>(first) << 32U) | count; }

}  // namespace

std::uint32_t leaf_size_of(std::string_view line) {
  return leaf_size_in(parse_object(line)).value_or(culler::leaf_size_for(culler::Method::frusta));
}

Prover::Prover(const culler::Hierarchy& hierarchy, Cameras cameras)
    : hierarchy_(hierarchy), polygons_(hierarchy), cameras_(std::move(cameras)) {
  const culler::SoupView soup = hierarchy.soup();
  for (std::size_t p = 0; p <= soup.size(); ++p) first_triangle_.push_back(hierarchy.first_triangle(p));
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    if (soup.is_opaque(p)) by_vertices_.push_back(p);
  }
  std::stable_sort(by_vertices_.begin(), by_vertices_.end(), LessByVertices{soup});
  model_ = to_oracle(box_of_triangles(0, first_triangle_.back()));
}

Proof Prover::prove(std::string_view line) const {
  const Json object = parse_object(line);
  const Json& frame = member(object, "frame");
  if (!frame.is_number_unsigned() || frame.get<std::size_t>() >= cameras_.frames) return Proof{.failure = "no such frame"};
  if (leaf_size_in(object).value_or(hierarchy_.leaf_size()) != hierarchy_.leaf_size())
    throw LineError("\"leaf\": another tree than that of the first line");
  const auto [first, count] = run_of(member(object, "triangles"), "triangles");
  const std::size_t total = first_triangle_.back();
  if (count == 0 || first >= total || count > total - first) return Proof{.failure = "no such triangles"};
  const auto number = frame.get<std::size_t>();
  return Proof{fault(object, cameras_.at(number), first, count), number, first, count};
}

std::string Prover::fault(const Json& object, const AnyCamera& camera, std::size_t first, std::size_t count) const {
  const Box box = proof::box(object);
  const Json& by = member(object, "by");
  if (!lie_in(box, first, count)) return "the triangles are not in the box";

  const double margin = margin_of(object);
  const oracle::Viewpoint expected = viewpoint_of(camera);
  const Eyes eyes = eyes_in(object);
  if (std::string fault = fault_of_eyes(eyes, camera); !fault.empty()) return fault;
  if (eyes && expected.at_infinity) return "a region of eyes is for perspective";
  if (eyes && !contains(*eyes, expected.value)) return "the frame's eye is not in the region";
  if (by == "view") {
    const auto plane = four_numbers(object, "plane");
    if (std::string fault = oracle::refute_view_cull(plane, to_oracle(box), margin); !fault.empty()) return fault;
    return may_draw_beyond(plane, camera, model_, eyes)
               ? "the plane cuts what the camera shows (is --size that of the walk?)"
               : "";
  }
  if (by != "shadow" && by != "cover") return "\"by\": expected \"view\", \"shadow\" or \"cover\"";

  if (by == "cover" && margin != 0) return "a cover has no margin";
  if (by == "cover" && eyes) {
    const bool is_said = object.contains("drawn");
    const auto drawn = is_said ? four_numbers(object, "drawn") : drawn_of_sheets(camera, model_, eyes);
    if (is_said && !draws_all_in(drawn, camera, model_, eyes)) return "sheets count where the near plane may clip them";
    return fault_of_windows(*eyes, object, drawn, to_oracle(box), polygons_);
  }
  if (eyes && margin != 0) return "a shadow for a region of eyes has no margin";
  if (eyes) return fault_of_umbra(*eyes, object, camera, box, first, count);
  const kernel::Viewpoint view = viewpoint(object);
  const oracle::Viewpoint said = to_oracle(view);
  if (said.at_infinity != expected.at_infinity || said.value != expected.value) return "the viewpoint is not the frame's";
  if (by == "cover") return fault_of_polygons(said, object, drawn(camera, model_), to_oracle(box), polygons_);
  std::vector<oracle::Shadow> shadows;
  for (const Json& described : occluders_of(object)) {
    if (std::string fault = fault_of_occluder(described, camera, {}, first, count); !fault.empty()) return fault;
    shadows.push_back(shadow_of(view, described, object));
  }
  if (shadows.size() == 1) return shadows[0].refute_cull(to_oracle(box), margin);
  if (margin != 0) return "two shadows together have no margin";
  return shadows[0].refute_union_cull(shadows[1], to_oracle(box));
}

std::string Prover::fault_of_umbra(const oracle::EyeRegion& eyes, const Json& object, const AnyCamera& camera,
                                   const Box& box, std::size_t first, std::size_t count) const {
  const Json& occluders = occluders_of(object);
  if (occluders.size() != 1) throw LineError("\"occluders\": expected one occluder for a region of eyes");
  if (std::string fault = fault_of_occluder(occluders[0], camera, eyes, first, count); !fault.empty()) return fault;
  const oracle::Answer answer = oracle::relation_to_umbra(eyes, to_oracle(occluder(occluders[0])), to_oracle(box));
  if (!answer.refusal.empty()) return answer.refusal;
  return answer.relation == oracle::Relation::inside ? "" : "the box is not in the shadow from every eye";
}

std::string Prover::fault_of_occluder(const Json& described, const AnyCamera& camera, const Eyes& eyes, std::size_t first,
                                      std::size_t count) const {
  const Occluder occluder = proof::occluder(described);
  const bool is_joined = described.contains("parts");
  if (is_joined && !std::holds_alternative<Polygon>(occluder)) throw LineError("\"parts\": only a polygon has them");
  for (const Polygon& polygon : polygons_of(occluder)) {
    const bool is_drawn = is_joined ? is_joined_outside(polygon, described["parts"], first, count)
                                    : is_model_polygon_outside(polygon, first, count);
    if (!is_drawn) return "the occluder is not of the model outside the subtree";
    if (may_clip(camera, model_, to_oracle(polygon), eyes)) return "the renderer clips the occluder";
  }
  return "";
}

bool Prover::lie_in(const Box& box, std::size_t first, std::size_t count) const {
  if (const kernel::Aabb* aabb = std::get_if<kernel::Aabb>(&box)) return contains(*aabb, box_of_triangles(first, count));
  const kernel::Obb& obb = std::get<kernel::Obb>(box);
  const std::uint64_t run = key(first, count);
  {
    const std::shared_lock lock(mutex_);
    if (const auto found = holding_.find(run); found != holding_.end() && found->second == obb) return true;
  }
  const culler::SoupView soup = hierarchy_.soup();
  const auto [begin, end] = polygons_with(first, count);
  for (std::size_t p = begin; p != end; ++p) {
    for (const std::uint32_t index : soup.loop(p)) {
      if (!oracle::contains(to_oracle(obb), key(soup.vertices[index]))) return false;
    }
  }
  const std::unique_lock lock(mutex_);
  holding_.insert_or_assign(run, obb);
  return true;
}

std::pair<std::size_t, std::size_t> Prover::polygons_with(std::size_t first, std::size_t count) const {
  const auto begin = std::prev(std::upper_bound(first_triangle_.begin(), first_triangle_.end(), first));
  const auto end = std::lower_bound(begin, first_triangle_.end(), first + count);
  return {static_cast<std::size_t>(begin - first_triangle_.begin()),
          static_cast<std::size_t>(end - first_triangle_.begin())};
}

kernel::Aabb Prover::box_of_triangles(std::size_t first, std::size_t count) const {
  const std::uint64_t run = key(first, count);
  {
    const std::shared_lock lock(mutex_);
    if (const auto found = boxes_.find(run); found != boxes_.end()) return found->second;
  }
  const auto [begin, end] = polygons_with(first, count);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  kernel::Aabb box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  const culler::SoupView soup = hierarchy_.soup();
  for (std::size_t p = begin; p != end; ++p) {
    for (const std::uint32_t index : soup.loop(p)) {
      const glm::dvec3& v = soup.vertices[index];
      for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::min(box.min[axis], v[axis]);
        box.max[axis] = std::max(box.max[axis], v[axis]);
      }
    }
  }
  const std::unique_lock lock(mutex_);
  return boxes_.emplace(run, box).first->second;
}

bool Prover::is_model_polygon_outside(const Polygon& loop, std::size_t first, std::size_t count) const {
  const LessByVertices less{hierarchy_.soup()};
  const auto [begin, end] = std::equal_range(by_vertices_.begin(), by_vertices_.end(), loop, less);
  // The polygons of the triangles are consecutive, and the equal polygons are sorted by index. So if any of these is
  // outside, the first or the last is.
  const auto is_outside = [&](std::uint32_t p) {
    return first_triangle_[p + 1] <= first || first_triangle_[p] >= first + count;
  };
  return begin != end && (is_outside(*begin) || is_outside(*std::prev(end)));
}

Polygon Prover::polygon(std::size_t p, std::size_t first, std::size_t count) const {
  const auto indices = hierarchy_.soup().loop(p);
  Polygon loop;
  const auto add = [&](std::uint32_t index) {
    const glm::dvec3& v = hierarchy_.soup().vertices[index];
    loop.push_back({v.x, v.y, v.z});
  };
  add(indices[0]);
  for (std::size_t i = first + 1; i <= first + count + 1; ++i) add(indices[i]);
  return loop;
}

bool Prover::is_joined_outside(const Polygon& loop, const Json& parts, std::size_t first, std::size_t count) const {
  if (!parts.is_array()) throw LineError("\"parts\": expected a list of [first, count]");
  std::vector<Polygon> polygons;
  for (const Json& part : parts) {
    const auto [from, length] = run_of(part, "parts");
    if (from < first + count && first < from + length) return false;
    const auto end = std::upper_bound(first_triangle_.begin(), first_triangle_.end(), from);
    if (end == first_triangle_.end() || length == 0 || length > *end - from) return false;  // beyond the fan of the polygon
    const auto p = static_cast<std::size_t>(end - first_triangle_.begin()) - 1;
    if (!hierarchy_.soup().is_opaque(p)) return false;
    polygons.push_back(polygon(p, from - first_triangle_[p], length));
  }
  return have_border(polygons, loop);
}

}  // namespace occlude::proof
