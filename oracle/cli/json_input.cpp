// SPDX-License-Identifier: MIT
#include "json_input.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>

namespace occlude::cli {

using Json = nlohmann::json;

namespace {

/// Far more than any line needs, far less than recursion over a hostile one could bear.
constexpr int kDeepest = 16;

Json parse(std::string_view line) {
  return Json::parse(line, [](int depth, Json::parse_event_t, Json&) {
    if (depth > kDeepest) throw LineError("nested too deeply");
    return true;
  });
}

/// Puts the numbers that JSON cannot write, NaN, Infinity and those too large for a double, in quotes as "nan", "inf",
/// "-inf".
std::string with_special_numbers_quoted(std::string_view line) {
  std::string result;
  bool in_string = false;
  for (std::size_t i = 0; i < line.size();) {
    const std::string_view rest = line.substr(i);
    const std::size_t word = in_string ? 0 : std::min(rest.find_first_of(",]} \t\r\n:\""), rest.size());
    const std::string text(rest.substr(0, word));
    char* end = nullptr;
    const double value = word == 0 ? 0 : std::strtod(text.c_str(), &end);
    if (word != 0 && end == text.c_str() + word && !std::isfinite(value)) {
      result += std::isnan(value) ? "\"nan\"" : value > 0 ? "\"inf\"" : "\"-inf\"";
      i += word;
      continue;
    }
    if (in_string && line[i] == '\\') result += line[i++];
    if (i < line.size()) {
      if (line[i] == '"') in_string = !in_string;
      result += line[i++];
    }
  }
  return result;
}

std::uint32_t index(const Json& value) {
  if (!value.is_number_unsigned()) throw LineError("\"faces\": expected indices, which are whole numbers from 0");
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(value.get<std::uint64_t>(), kLast));
}

std::vector<std::vector<std::uint32_t>> faces(const Json& value) {
  constexpr const char* kExpected = "\"faces\": expected an array of arrays of indices";
  if (!value.is_array()) throw LineError(kExpected);
  std::vector<std::vector<std::uint32_t>> result;
  for (const Json& loop : value) {
    if (!loop.is_array()) throw LineError(kExpected);
    std::ranges::transform(loop, std::back_inserter(result.emplace_back()), index);
  }
  return result;
}

}  // namespace

Json parse_object(std::string_view line) {
  Json object;
  try {
    object = parse(line);
  } catch (const Json::exception&) {
    try {
      object = parse(with_special_numbers_quoted(line));
    } catch (const Json::parse_error& error) {
      throw LineError(fmt::format("not JSON, near column {}", error.byte));
    } catch (const Json::exception&) {
      throw LineError("not JSON");
    }
  }
  if (!object.is_object()) throw LineError("not a JSON object");
  return object;
}

const Json& member(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) throw LineError(fmt::format("\"{}\" is missing", name));
  return *found;
}

double number(const Json& value, const char* name) {
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (text == "inf") return std::numeric_limits<double>::infinity();
    if (text == "-inf") return -std::numeric_limits<double>::infinity();
  }
  throw LineError(fmt::format("\"{}\": expected a number", name));
}

kernel::Vec3 vec3(const Json& value, const char* name) {
  if (!value.is_array() || value.size() != 3) throw LineError(fmt::format("\"{}\": expected [x, y, z]", name));
  return {number(value[0], name), number(value[1], name), number(value[2], name)};
}

std::vector<kernel::Vec3> vec3s(const Json& value, const char* name) {
  if (!value.is_array()) throw LineError(fmt::format("\"{}\": expected an array of [x, y, z]", name));
  std::vector<kernel::Vec3> points;
  for (const Json& point : value) points.push_back(vec3(point, name));
  return points;
}

kernel::Viewpoint viewpoint(const Json& object) {
  if (object.contains("direction") && object.contains("eye")) throw LineError("both \"eye\" and \"direction\"");
  if (object.contains("direction")) return kernel::Viewpoint::direction(vec3(object["direction"], "direction"));
  return kernel::Viewpoint::eye(vec3(member(object, "eye"), "eye"));
}

Box box(const Json& object) {
  const Json& value = member(object, "box");
  if (!value.is_object()) throw LineError("\"box\": expected an object");
  const bool oriented = value.contains("center") || value.contains("half_edges");
  if (oriented && (value.contains("min") || value.contains("max"))) throw LineError("\"box\": both \"min\" and \"center\"");
  if (!oriented) return kernel::Aabb{vec3(member(value, "min"), "min"), vec3(member(value, "max"), "max")};
  const auto half_edges = vec3s(member(value, "half_edges"), "half_edges");
  if (half_edges.size() != 3) throw LineError("\"half_edges\": expected three of them");
  return kernel::Obb{vec3(member(value, "center"), "center"), {half_edges[0], half_edges[1], half_edges[2]}};
}

Occluder occluder(const Json& value) {
  if (!value.is_object()) throw LineError("expected an occluder to be an object");
  const bool has_faces = value.contains("vertices") || value.contains("faces");
  if (has_faces && value.contains("polygon")) throw LineError("both \"polygon\" and \"vertices\"");
  if (!has_faces) return vec3s(member(value, "polygon"), "polygon");
  return kernel::Polytope{vec3s(member(value, "vertices"), "vertices"), faces(member(value, "faces"))};
}

}  // namespace occlude::cli
