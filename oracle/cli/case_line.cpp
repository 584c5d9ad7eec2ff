// SPDX-License-Identifier: MIT
#include "case_line.h"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <variant>

#include "occlude/render/errors.h"

namespace occlude::cli {
namespace {

using Json = nlohmann::ordered_json;

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

/// JSON has no NaN and no infinity: strings, as json_input.h reads them.
Json json(double x) {
  if (std::isfinite(x)) return x;
  return std::isnan(x) ? "nan" : x > 0 ? "inf" : "-inf";
}

Json json(const kernel::Vec3& v) { return Json::array({json(v.x), json(v.y), json(v.z)}); }

template <class Points>
Json json_of_all(const Points& points) {
  Json result = Json::array();
  for (const kernel::Vec3& point : points) result.push_back(json(point));
  return result;
}

Json json(const Polygon& polygon) { return {{"polygon", json_of_all(polygon)}}; }
Json json(const kernel::Polytope& polytope) {
  return {{"vertices", json_of_all(polytope.vertices)}, {"faces", polytope.faces}};
}
Json json(const kernel::Aabb& box) { return {{"min", json(box.min)}, {"max", json(box.max)}}; }
Json json(const kernel::Obb& box) { return {{"center", json(box.center)}, {"half_edges", json_of_all(box.half_edges)}}; }

void read_lines(std::istream& in, const std::string& name,
                const std::function<void(std::size_t number, const nlohmann::json&)>& take) {
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      take(number, parse_object(line));
    } catch (const LineError& error) {
      throw render::InputError(fmt::format("{}:{}: {}", name, number, error.what()));
    }
  }
  if (in.bad()) throw render::InputError(name + ": cannot be read");
}

}  // namespace

Json case_id(const nlohmann::json& object) {
  if (!object.contains("id")) return nullptr;
  if (!object["id"].is_string() && !object["id"].is_number()) throw LineError("\"id\": expected a string or a number");
  return object["id"];
}

CaseLine read_case(const nlohmann::json& object) {
  return {{viewpoint(object), occluder(member(object, "occluder")), near_of(object), box(object)}, expect_of(object)};
}

void for_each_case(const std::string& file, const std::function<void(std::size_t number, const nlohmann::json&)>& take) {
  if (file == "-") return read_lines(std::cin, "standard input", take);
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) throw render::InputError(file + ": cannot be opened");
  read_lines(in, file, take);
}

std::string write_case(const std::string& id, const fuzz::Case& question, const std::string& expect) {
  const auto write = [](const auto& kind) { return json(kind); };
  Json line{{"id", id}};
  line[question.viewpoint.is_eye() ? "eye" : "direction"] = json(question.viewpoint.value);
  line["occluder"] = std::visit(write, question.occluder);
  line["near"] = question.near == kernel::Near::farthest ? "farthest" : "surface";
  line["box"] = std::visit(write, question.box);
  if (!expect.empty()) line["expect"] = expect;
  return line.dump();
}

}  // namespace occlude::cli
