// SPDX-License-Identifier: MIT
// A case as a JSON object.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cases/json_input.h"

namespace occlude::cases {

/// A question, and the right answer if the line has one.
struct CaseLine {
  Case question;
  std::optional<std::string> expect;
};

/// The member "id", or null when there is none. Like the functions below it throws LineError.
[[nodiscard]] nlohmann::ordered_json case_id(const nlohmann::json& object);

[[nodiscard]] CaseLine read_case(const nlohmann::json& object);

/// A question about the joined shadow of several polygons. Its answers are "inside" and "partial".
struct CoverLine {
  kernel::Viewpoint viewpoint;
  std::vector<Polygon> polygons;
  Box box;
  std::optional<std::string> expect;
};

/// Whether the object's occluder is a "cover".
[[nodiscard]] bool is_cover(const nlohmann::json& object);

[[nodiscard]] CoverLine read_cover(const nlohmann::json& object);

/// A question about the umbra or penumbra of an occluder for a region of viewpoints.
struct RegionLine {
  RegionCase question;
  std::optional<std::string> expect;
};

/// Whether the object has "eyes" or "directions".
[[nodiscard]] bool is_region(const nlohmann::json& object);

[[nodiscard]] RegionLine read_region(const nlohmann::json& object);

/// JSON has no NaN and no infinity. They become strings, as json_input.h reads them.
[[nodiscard]] nlohmann::ordered_json json_of(double x);

/// The line that reads back as the same case, without a line break. An empty `expect` is left out.
[[nodiscard]] std::string write_case(const std::string& id, const Case& question, const std::string& expect);
[[nodiscard]] std::string write_case(const std::string& id, const RegionCase& question, const std::string& expect);

}  // namespace occlude::cases
