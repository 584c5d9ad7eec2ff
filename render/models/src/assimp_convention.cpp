// SPDX-License-Identifier: MIT
#include "assimp_convention.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>

#include "text_number.h"

namespace occlude::render {
namespace {

constexpr std::string_view kCollada = "Collada Importer", kFbx = "Autodesk FBX Importer",
                           kIfc = "Industry Foundation Classes (IFC) Importer";

/// Formats that have one unit and one axis for all files.
constexpr std::array<std::string_view, 2> kMetresWithYUp = {"glTF Importer", "Extensible 3D(X3D) Importer"};

/// Importers that turn each file so that y is up, by the placement of the scene's root, which the file does not have.
constexpr std::array<std::string_view, 10> kTurning = {kCollada,
                                                       kIfc,
                                                       "Discreet 3DS Importer",
                                                       "ASE Importer",
                                                       "Drawing Interchange Format (DXF) Importer",
                                                       "Quake II Mesh Importer",
                                                       "Quake III Mesh Importer",
                                                       "Quake Mesh / 3D GameStudio Mesh Importer",
                                                       "Return To Castle Wolfenstein Mesh Importer",
                                                       "Doom 3 / MD5 Mesh Importer"};

/// A unit that the library has rounded to single precision, as it is written in files; 0 for one that is none.
double unit_of(float metres) { return std::isfinite(metres) ? parse_unit(fmt::format("{}", metres)).value_or(0) : 0; }

/// The direction of the axis that is nearest; 0 for 0.
glm::dvec3 axis_along(const glm::dvec3& direction) {
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::fabs(direction[i]) > std::fabs(direction[longest])) longest = i;
  }
  glm::dvec3 axis(0);
  if (direction[longest] != 0) axis[longest] = direction[longest] < 0 ? -1 : 1;
  return axis;
}

/// A placement that takes axes to axes, and makes y of one that is up.
struct AxisTurn {
  glm::dvec3 up;
  double scale;
};

/// Nothing for a placement that does more.
std::optional<AxisTurn> axis_turn(const aiMatrix4x4& placement) {
  constexpr double kRounding = 1e-6;  // importers may turn by sines and cosines in single precision
  const std::array<glm::dvec3, 3> rows = {glm::dvec3(placement.a1, placement.a2, placement.a3),
                                          glm::dvec3(placement.b1, placement.b2, placement.b3),
                                          glm::dvec3(placement.c1, placement.c2, placement.c3)};
  const double scale = glm::length(rows[1]);
  const auto is_along_axis = [&](const glm::dvec3& row) {
    return glm::length(row - scale * axis_along(row)) <= kRounding * scale;
  };
  const bool moves = placement.a4 != 0 || placement.b4 != 0 || placement.c4 != 0;
  if (moves || !std::ranges::all_of(rows, is_along_axis)) return std::nullopt;
  return AxisTurn{axis_along(rows[1]), scale};
}

/// FBX says an axis by its number and its sign, and how many centimetres a unit is.
Convention convention_of_fbx(const aiMetadata& said) {
  std::int32_t axis = -1, sign = 1;
  float centimetres = 0;
  said.Get("UpAxis", axis);
  said.Get("UpAxisSign", sign);
  said.Get("UnitScaleFactor", centimetres);
  Convention convention{unit_of(centimetres) / 100, glm::dvec3(0)};
  if (axis >= 0 && axis < 3) convention.up[axis] = sign < 0 ? -1 : 1;
  return convention;
}

}  // namespace

Convention take_convention(const aiScene& scene, std::string_view importer) {
  const auto is_among = [&](const auto& names) { return std::ranges::find(names, importer) != names.end(); };
  if (importer == kFbx) return scene.mMetaData == nullptr ? Convention() : convention_of_fbx(*scene.mMetaData);
  if (is_among(kMetresWithYUp)) return {1, {0, 1, 0}};
  if (!is_among(kTurning)) return {};
  aiMatrix4x4& root = scene.mRootNode->mTransformation;
  const auto turn = axis_turn(root);
  if (!turn) return {};
  root = aiMatrix4x4();
  if (importer == kCollada) return {unit_of(static_cast<float>(turn->scale)), turn->up};
  return {importer == kIfc ? 1.0 : 0.0, turn->up};  // the importer of IFC converts lengths
}

}  // namespace occlude::render
