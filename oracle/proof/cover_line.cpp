// SPDX-License-Identifier: MIT
#include "cover_line.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include "cases/to_oracle.h"
#include "occlude/oracle/cover.h"
#include "occlude/render/input_limits.h"

namespace occlude::proof {
namespace {

using Json = nlohmann::json;

oracle::Focus focus_of(const Json& object) {
  const Json& focus = member(object, "focus");
  const auto vector = [&](const char* name) { return to_oracle(vec3(member(focus, name), name)); };
  return {vector("point"), vector("normal"), vector("right")};
}

}  // namespace

std::array<double, 4> four_numbers(const Json& object, const char* name) {
  const Json& numbers = member(object, name);
  if (!numbers.is_array() || numbers.size() != 4) throw LineError(fmt::format("\"{}\": expected four numbers", name));
  std::array<double, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = number(numbers[i], name);
  return result;
}

Eyes eyes_in(const Json& object) {
  if (!object.contains("eyes")) return std::nullopt;
  const Json& eyes = object["eyes"];
  if (!eyes.is_object()) throw LineError("\"eyes\": expected an object");
  if (object.contains("eye")) throw LineError("both \"eye\" and \"eyes\"");
  if (eyes.contains("radius") && eyes.contains("half_edges"))
    throw LineError("\"eyes\": both \"radius\" and \"half_edges\"");
  const oracle::Point center = to_oracle(vec3(member(eyes, "center"), "center"));
  if (eyes.contains("radius")) return oracle::Ball{center, number(eyes["radius"], "radius")};
  const std::vector<kernel::Vec3> half_edges = vec3s(member(eyes, "half_edges"), "half_edges");
  if (half_edges.size() != 3) throw LineError("\"half_edges\": expected three vectors");
  return oracle::Obb{center, {to_oracle(half_edges[0]), to_oracle(half_edges[1]), to_oracle(half_edges[2])}};
}

bool contains(const oracle::EyeRegion& eyes, const oracle::Point& eye) {
  return std::visit([&](const auto& kind) { return oracle::contains(kind, eye); }, eyes);
}

std::string fault_of_windows(const oracle::EyeRegion& eyes, const Json& object, const oracle::HalfSpaceCoefficients& drawn,
                             const oracle::Box& box, const ModelPolygons& polygons) {
  std::map<std::pair<Json, Json>, oracle::Sheet> sheets;  // windows side by side have the same one
  std::size_t windows = 0, vertices = 0;
  std::string fault;
  const auto sheet_of = [&](const Json& window) {
    const std::pair key(member(window, "polygons"), window.value("triangles", Json::array()));
    auto found = sheets.find(key);
    if (found != sheets.end()) return found->second;
    auto [cover, fault_of_cover] = polygons.cover(key.first, vertices);
    if (fault_of_cover.empty()) fault_of_cover = polygons.append_triangles(key.second, cover, vertices);
    if (fault.empty()) fault = fault_of_cover;
    return sheets.emplace(key, oracle::Sheet(cover, drawn)).first->second;
  };
  const std::function<oracle::Layer(const Json&)> layer_of = [&](const Json& described) {
    const Json& listed = member(described, "windows");
    if (!listed.is_array()) throw LineError("\"windows\": expected a list");
    windows += listed.size();
    if (windows > render::kMostWitnessWindows)
      throw LineError(fmt::format("\"windows\": more than {}", render::kMostWitnessWindows));
    oracle::Layer layer{focus_of(described), {}};
    for (const Json& window : listed) {
      const auto [x0, y0, x1, y1] = four_numbers(window, "rect");
      if (window.contains("windows") && window.contains("polygons")) throw LineError("both \"polygons\" and \"windows\"");
      if (window.contains("windows")) {
        layer.windows.push_back({x0, y0, x1, y1, layer_of(window)});
      } else {
        layer.windows.push_back({x0, y0, x1, y1, sheet_of(window)});
      }
    }
    return layer;
  };
  const oracle::RegionWitness witness{eyes, box, layer_of(object)};
  return fault.empty() ? oracle::judge(witness).reason : fault;
}

std::string fault_of_polygons(const oracle::Viewpoint& view, const Json& object, const oracle::HalfSpaceCoefficients& drawn,
                              const oracle::Box& box, const ModelPolygons& polygons) {
  std::size_t vertices = 0;
  const auto [cover, fault] = polygons.cover(member(object, "polygons"), vertices);
  if (!fault.empty()) return fault;
  const oracle::Answer answer = oracle::relation_to_cover(view, cover, box, drawn);
  if (!answer.refusal.empty()) return answer.refusal;
  return answer.relation == oracle::Relation::inside ? "" : "the polygons do not hide the box";
}

}  // namespace occlude::proof
