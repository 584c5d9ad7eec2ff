// SPDX-License-Identifier: MIT
#include "json_input.h"

#include <fmt/core.h>

#include <limits>

namespace occlude::cli {

using Json = nlohmann::json;

Json parse_object(std::string_view line) {
  Json object;
  try {
    object = Json::parse(line);
  } catch (const Json::parse_error& error) {
    throw LineError(fmt::format("not JSON, at column {}", error.byte));
  } catch (const Json::out_of_range&) {
    throw LineError("a number is out of range");
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
  if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
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
  if (object.contains("direction")) return kernel::Viewpoint::direction(vec3(object["direction"], "direction"));
  return kernel::Viewpoint::eye(vec3(member(object, "eye"), "eye"));
}

kernel::Aabb aabb(const Json& object) {
  const Json& box = member(object, "box");
  if (!box.is_object()) throw LineError("\"box\": expected an object");
  return {vec3(member(box, "min"), "min"), vec3(member(box, "max"), "max")};
}

}  // namespace occlude::cli
