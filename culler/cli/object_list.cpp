// SPDX-License-Identifier: MIT
#include "object_list.h"

#include <fmt/format.h>

#include <stdexcept>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/errors.h"
#include "occlude/render/json_text.h"

namespace occlude::cli {
namespace {

/// A number, or a range [first, count].
culler::PolygonRange range_of(const nlohmann::json& value, std::size_t polygons) {
  const bool is_range = value.is_array() && value.size() == 2;
  const auto whole = [&](const nlohmann::json& number) {
    if (!number.is_number_unsigned()) throw std::invalid_argument("expected numbers of polygons and ranges [first, count]");
    const auto n = number.get<std::uint64_t>();
    if (n > polygons) throw std::invalid_argument(fmt::format("{}: the model has {} polygons", n, polygons));
    return static_cast<std::uint32_t>(n);
  };
  const culler::PolygonRange range{whole(is_range ? value[0] : value), is_range ? whole(value[1]) : 1};
  if (range.first + std::size_t{range.count} > polygons) {
    throw std::invalid_argument(
        fmt::format("polygons {} to {}: the model has {}", range.first, range.first + range.count - 1, polygons));
  }
  return range;
}

}  // namespace

ObjectList read_objects(const std::string& file, std::size_t polygons) {
  const nlohmann::json root = render::read_json(file);
  const auto fail = [&](const std::string& what) { throw render::InputError(fmt::format("{}: {}", file, what)); };
  if (!root.is_object() || root.size() != 1 || !root.contains("objects") || !root["objects"].is_array()) {
    fail("expected {\"objects\":[[polygon, [first, count], …], …]}");
  }
  const nlohmann::json& objects = root["objects"];
  ObjectList list{static_cast<std::uint32_t>(objects.size()), {}};
  list.of_polygon.assign(polygons, list.count);
  for (std::uint32_t object = 0; object < list.count; ++object) {
    try {
      if (!objects[object].is_array()) throw std::invalid_argument("expected an array");
      for (const nlohmann::json& value : objects[object]) {
        const auto [first, count] = range_of(value, polygons);
        for (std::uint32_t p = first; p < first + count; ++p) {
          std::uint32_t& of = list.of_polygon[p];
          if (of != list.count) throw std::invalid_argument(fmt::format("polygon {} is in object {} already", p, of));
          of = object;
        }
      }
    } catch (const std::invalid_argument& error) {
      fail(fmt::format("object {}: {}", object, error.what()));
    }
  }
  return list;
}

}  // namespace occlude::cli
