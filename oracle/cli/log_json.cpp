// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "cases/case_line.h"
#include "log_record.h"

namespace occlude::cli {
namespace {

using nlohmann::json;

LineError wrong(const std::string& name, const char* what) { return LineError(fmt::format("\"{}\": {}", name, what)); }

void require_known(const json& object, std::initializer_list<std::string_view> known) {
  for (const auto& [name, value] : object.items()) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw LineError(fmt::format("unknown member \"{}\"; known are {}", name, fmt::join(known, ", ")));
  }
}

std::uint32_t whole(const json& value, const std::string& name) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMost) {
    throw wrong(name, "expected whole numbers from 0 to 4294967295");
  }
  return value.get<std::uint32_t>();
}

const json& list(const json& object, const char* name) {
  const json& value = cases::member(object, name);
  if (!value.is_array()) throw wrong(name, "expected an array");
  return value;
}

/// Ranges [first, count] and single numbers.
std::vector<culler::PolygonRange> ranges(const json& object, const char* name) {
  std::vector<culler::PolygonRange> result;
  for (const json& value : list(object, name)) {
    if (!value.is_array()) {
      result.push_back({whole(value, name), 1});
    } else if (value.size() == 2) {
      result.push_back({whole(value[0], name), whole(value[1], name)});
    } else {
      throw wrong(name, "expected numbers and ranges [first, count]");
    }
  }
  return result;
}

/// Which of two words the member is; the first if there is none.
bool is_second(const json& object, const char* name, const char* first, const char* second) {
  if (!object.contains(name)) return false;
  const json& value = object[name];
  if (value != first && value != second)
    throw LineError(fmt::format("\"{}\": expected \"{}\" or \"{}\"", name, first, second));
  return value == second;
}

glm::dvec3 vector_of(const json& object, const char* name) {
  const kernel::Vec3 v = cases::vec3(cases::member(object, name), name);
  return {v.x, v.y, v.z};
}

culler::Camera eye_camera(const json& object) {
  culler::Camera camera{.eye = vector_of(object, "eye"), .target = vector_of(object, "target")};
  if (object.contains("up")) camera.up = vector_of(object, "up");
  const auto take = [&](const char* name, double& value) {
    if (object.contains(name)) value = cases::number(object[name], name);
  };
  if (is_second(object, "projection", "perspective", "orthographic")) {
    camera.projection = culler::Projection::orthographic;
    camera.height = cases::number(cases::member(object, "view_height"), "view_height");
    if (object.contains("fov_y_deg")) throw wrong("fov_y_deg", "an orthographic projection has none");
  } else if (object.contains("view_height")) {
    throw wrong("view_height", "expected \"projection\":\"orthographic\" with it");
  }
  take("fov_y_deg", camera.fov_y_deg);
  take("near", camera.near_plane);
  take("far", camera.far_plane);
  return camera;
}

culler::MatrixCamera matrix_camera(const json& object) {
  const json& value = object["matrix"];
  if (!value.is_array() || value.size() != 16) throw wrong("matrix", "expected 16 numbers");
  std::array<double, 16> numbers;
  std::ranges::transform(value, numbers.begin(), [](const json& number) { return cases::number(number, "matrix"); });
  const culler::ClipDepth depth = is_second(object, "clip_depth", "minus_w_to_w", "zero_to_w")
                                      ? culler::ClipDepth::zero_to_w
                                      : culler::ClipDepth::minus_w_to_w;
  return is_second(object, "order", "column", "row") ? culler::MatrixCamera::from_rows(numbers.data(), depth)
                                                     : culler::MatrixCamera::from_columns(numbers.data(), depth);
}

constexpr std::array kLists{"culled", "drawn", "culled_objects", "drawn_objects"};

void require_members(const json& object) {
  if (object.contains("matrix")) {
    require_known(object, {"frame", "matrix", "order", "clip_depth", "width", "height", "culled", "drawn", "culled_objects",
                           "drawn_objects"});
  } else {
    require_known(object, {"frame", "eye", "target", "up", "fov_y_deg", "near", "far", "projection", "view_height", "width",
                           "height", "culled", "drawn", "culled_objects", "drawn_objects"});
  }
}

FrameRecord frame_record(const json& object) {
  require_members(object);
  FrameRecord frame;
  for (const auto& [name, value] : {std::pair{"frame", &frame.frame}, {"width", &frame.width}, {"height", &frame.height}}) {
    *value = whole(cases::member(object, name), name);
  }
  if (object.contains("matrix")) {
    frame.camera = matrix_camera(object);
  } else {
    frame.camera = eye_camera(object);
  }
  if (std::ranges::count_if(kLists, [&](const char* name) { return object.contains(name); }) != 1) {
    throw LineError(fmt::format("expected one of {}", fmt::join(kLists, ", ")));
  }
  for (std::size_t i = 0; i < kLists.size(); ++i) {
    if (!object.contains(kLists[i])) continue;
    frame.is_drawn = i % 2 == 1;
    frame.is_of_objects = i >= 2;
    if (!frame.is_of_objects) frame.polygons = ranges(object, kLists[i]);
    if (!frame.is_of_objects) continue;
    for (const json& id : list(object, kLists[i])) frame.objects.push_back(whole(id, kLists[i]));
  }
  return frame;
}

}  // namespace

LogRecord json_record(std::string_view line) {
  const json object = cases::parse_object(line);
  if (!object.contains("object")) return frame_record(object);
  require_known(object, {"object", "polygons"});
  return ObjectRecord{whole(object["object"], "object"), ranges(object, "polygons")};
}

}  // namespace occlude::cli
