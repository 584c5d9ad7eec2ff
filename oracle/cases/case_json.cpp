// SPDX-License-Identifier: MIT
#include "cases/case_json.h"

#include <cmath>
#include <variant>

namespace occlude::cases {
namespace {

using OrderedJson = nlohmann::ordered_json;

kernel::Near near_of(const nlohmann::json& object) {
  if (!object.contains("near")) return kernel::Near::farthest;
  if (object["near"] == "farthest") return kernel::Near::farthest;
  if (object["near"] == "surface") return kernel::Near::surface;
  throw LineError("\"near\": expected \"farthest\" or \"surface\"");
}

std::optional<std::string> expect_of(const nlohmann::json& object) {
  if (!object.contains("expect")) return std::nullopt;
  const auto& expect = object["expect"];
  if (expect != "inside" && expect != "partial" && expect != "outside") {
    throw LineError("\"expect\": expected \"inside\", \"partial\" or \"outside\"");
  }
  return expect.get<std::string>();
}

OrderedJson json(const kernel::Vec3& v) { return OrderedJson::array({json_of(v.x), json_of(v.y), json_of(v.z)}); }

template <class Points>
OrderedJson json_of_all(const Points& points) {
  OrderedJson result = OrderedJson::array();
  for (const kernel::Vec3& point : points) result.push_back(json(point));
  return result;
}

OrderedJson json(const Polygon& polygon) { return {{"polygon", json_of_all(polygon)}}; }
OrderedJson json(const kernel::Polytope& polytope) {
  return {{"vertices", json_of_all(polytope.vertices)}, {"faces", polytope.faces}};
}
OrderedJson json(const kernel::Aabb& box) { return {{"min", json(box.min)}, {"max", json(box.max)}}; }
OrderedJson json(const kernel::Obb& box) {
  return {{"center", json(box.center)}, {"half_edges", json_of_all(box.half_edges)}};
}

template <class Variant>
OrderedJson json_of_any(const Variant& variant) {
  return std::visit([](const auto& kind) { return json(kind); }, variant);
}

/// The line with what all kinds of cases end with.
std::string finished(OrderedJson line, const Box& box, const std::string& expect) {
  line["box"] = json_of_any(box);
  if (!expect.empty()) line["expect"] = expect;
  return line.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace

OrderedJson json_of(double x) {
  if (std::isfinite(x)) return x;
  return std::isnan(x) ? "nan" : x > 0 ? "inf" : "-inf";
}

OrderedJson case_id(const nlohmann::json& object) {
  if (!object.contains("id")) return nullptr;
  if (!object["id"].is_string() && !object["id"].is_number()) throw LineError("\"id\": expected a string or a number");
  return object["id"];
}

CaseLine read_case(const nlohmann::json& object) {
  return {{viewpoint(object), occluder(member(object, "occluder")), near_of(object), box(object)}, expect_of(object)};
}

bool is_cover(const nlohmann::json& object) {
  const auto occluder = object.find("occluder");
  return occluder != object.end() && occluder->is_object() && occluder->contains("cover");
}

CoverLine read_cover(const nlohmann::json& object) {
  const nlohmann::json& occluder = object["occluder"];
  for (const char* other : {"polygon", "vertices", "faces"}) {
    if (occluder.contains(other)) throw LineError("both \"cover\" and \"" + std::string(other) + '"');
  }
  return {viewpoint(object), cover(occluder["cover"]), box(object), expect_of(object)};
}

bool is_region(const nlohmann::json& object) { return object.contains("eyes") || object.contains("directions"); }

RegionLine read_region(const nlohmann::json& object) {
  if (object.contains("near") && object["near"] != "surface") {
    throw LineError("\"near\": the shadow of a region begins at the \"surface\"");
  }
  const nlohmann::json& shadow = member(object, "shadow");
  if (shadow != "umbra" && shadow != "penumbra") throw LineError("\"shadow\": expected \"umbra\" or \"penumbra\"");
  const kernel::ShadowKind kind = shadow == "umbra" ? kernel::ShadowKind::umbra : kernel::ShadowKind::penumbra;
  RegionLine line{{view_region(object), kind, occluder(member(object, "occluder")), box(object)}, expect_of(object)};
  if (vertices_of(line.question.occluder).size() > kMostRegionVertices) {
    throw LineError("\"occluder\": more than " + std::to_string(kMostRegionVertices) + " vertices, seen from a region");
  }
  return line;
}

std::string write_case(const std::string& id, const Case& question, const std::string& expect) {
  OrderedJson line{{"id", id}};
  line[question.viewpoint.is_eye() ? "eye" : "direction"] = json(question.viewpoint.value);
  line["occluder"] = json_of_any(question.occluder);
  line["near"] = question.near == kernel::Near::farthest ? "farthest" : "surface";
  return finished(std::move(line), question.box, expect);
}

std::string write_case(const std::string& id, const RegionCase& question, const std::string& expect) {
  OrderedJson line{{"id", id}};
  const auto& [kind, box] = question.region;
  line[kind == kernel::Viewpoint::Kind::eye ? "eyes" : "directions"] = json(box);
  line["occluder"] = json_of_any(question.occluder);
  line["shadow"] = question.kind == kernel::ShadowKind::umbra ? "umbra" : "penumbra";
  return finished(std::move(line), question.box, expect);
}

}  // namespace occlude::cases
