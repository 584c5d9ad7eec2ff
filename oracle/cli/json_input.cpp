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

/// A line as JSON takes it, and where in the line its characters come from.
struct Rewritten {
  std::string text;
  std::vector<std::size_t> columns;

  void add(std::string_view piece, std::size_t column, bool is_copy) {
    text += piece;
    for (std::size_t i = 0; i < piece.size(); ++i) columns.push_back(is_copy ? column + i : column);
  }
};

/// What a number that JSON cannot write, NaN, Infinity or one too large for a double, is put as; nothing for other words.
std::string_view quoted_special(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || end != word.c_str() + word.size() || std::isfinite(value)) return "";
  return std::isnan(value) ? "\"nan\"" : value > 0 ? "\"inf\"" : "\"-inf\"";
}

/// Puts those numbers in quotes as "nan", "inf", "-inf". Strings stay.
Rewritten with_special_numbers_quoted(std::string_view line) {
  Rewritten result;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t start = i;
    if (line[i] == '"') {
      for (++i; i < line.size() && line[i] != '"'; ++i) i += line[i] == '\\' ? 1 : 0;
      i = std::min(i + 1, line.size());
      result.add(line.substr(start, i - start), start, true);
    } else if (i = std::min(line.find_first_of(",[]{} \t\r\n:\"", i), line.size()); i == start) {
      result.add(line.substr(i++, 1), start, true);
    } else {
      const std::string_view word = line.substr(start, i - start), special = quoted_special(std::string(word));
      result.add(special.empty() ? word : special, start, special.empty());
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
    const Rewritten rewritten = with_special_numbers_quoted(line);
    try {
      object = parse(rewritten.text);
    } catch (const Json::parse_error& error) {
      const std::size_t at = error.byte - std::min<std::size_t>(error.byte, 1);  // it counts from 1, and 0 for none
      const std::size_t column = at < rewritten.columns.size() ? rewritten.columns[at] : line.size();
      throw LineError(fmt::format("not JSON, near column {}", column + 1));
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
