// SPDX-License-Identifier: MIT
#include "cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>
#include <stdexcept>
#include <tuple>

#include "occlude/kernel/validity.h"
#include "occlude/render/errors.h"
#include "occlude/render/json_text.h"

namespace occlude::cli {
namespace {

/// Which cube of the grid: how many lie before it along each axis.
using Place = std::array<std::int64_t, 3>;

glm::dvec3 vector_of(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

/// A point of a segment. Unlike glm::mix it never leaves the box of the ends.
glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double share) {
  return {std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share), std::lerp(a.z, b.z, share)};
}

/// The places in a layer count as one.
class Places {
 public:
  explicit Places(const CellGrid& grid) : grid_(grid) {}

  void add(const glm::dvec3& low, const glm::dvec3& high) {
    Place first, last;
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_layered = grid_.layer && grid_.layer->axis == axis;
      const auto i = static_cast<std::size_t>(axis);
      std::tie(first[i], last[i]) = is_layered ? std::pair<std::int64_t, std::int64_t>() : places(low[axis], high[axis]);
    }
    for (std::int64_t x = first[0]; x <= last[0]; ++x) {
      for (std::int64_t y = first[1]; y <= last[1]; ++y) {
        for (std::int64_t z = first[2]; z <= last[2]; ++z) {
          places_.insert({x, y, z});
          if (places_.size() > kMostCells) throw std::length_error(fmt::format("there would be more than {}", kMostCells));
        }
      }
    }
  }

  [[nodiscard]] std::vector<kernel::Aabb> cells() const {
    std::vector<kernel::Aabb> cells;
    for (const Place& p : places_) {
      glm::dvec3 low, high;
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = border(p[static_cast<std::size_t>(axis)]);
        high[axis] = border(p[static_cast<std::size_t>(axis)] + 1);
      }
      if (const auto& layer = grid_.layer) {
        low[layer->axis] = layer->is_down ? -layer->high : layer->low;
        high[layer->axis] = layer->is_down ? -layer->low : layer->high;
      }
      cells.push_back({{low.x, low.y, low.z}, {high.x, high.y, high.z}});
    }
    return cells;
  }

 private:
  /// The first and the last along an axis: the fewest that cover an interval.
  [[nodiscard]] std::pair<std::int64_t, std::int64_t> places(double low, double high) const {
    const std::int64_t first = place(low), last = place(high);
    return {first, last > first && border(last) == high ? last - 1 : last};
  }
  /// The one that holds a coordinate; of two that meet there, the higher one.
  [[nodiscard]] std::int64_t place(double coordinate) const {
    constexpr double kMost = 0x1p50;  // places and their neighbours are exact
    const double quotient = std::floor(coordinate / grid_.size);
    if (!(std::fabs(quotient) < kMost)) throw std::length_error("they are too small for so large a model");
    // The quotient and the borders are rounded, so it may be off by one.
    const auto before = static_cast<std::int64_t>(quotient);
    if (coordinate < border(before)) return before - 1;
    return coordinate < border(before + 1) ? before : before + 1;
  }
  [[nodiscard]] double border(std::int64_t place) const { return static_cast<double>(place) * grid_.size; }

  const CellGrid& grid_;
  std::set<Place> places_;
};

kernel::Vec3 corner(const nlohmann::json& cell, const char* name) {
  const auto found = cell.find(name);
  if (found == cell.end()) throw std::invalid_argument(fmt::format("{}: missing", name));
  std::array<double, 3> numbers;
  if (!found->is_array() || found->size() != 3) throw std::invalid_argument(fmt::format("{}: expected three numbers", name));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = render::number_of((*found)[i]);
    if (!number) throw std::invalid_argument(fmt::format("{}: expected three numbers", name));
    numbers[i] = *number;
  }
  return {numbers[0], numbers[1], numbers[2]};
}

kernel::Aabb cell_of(const nlohmann::json& cell) {
  if (!cell.is_object()) throw std::invalid_argument("expected an object");
  for (const auto& [name, value] : cell.items()) {
    if (name != "min" && name != "max") throw std::invalid_argument(fmt::format("unknown member \"{}\"", name));
  }
  const kernel::Aabb box{corner(cell, "min"), corner(cell, "max")};
  if (const kernel::Refusal refusal = check(box); refusal != kernel::Refusal::none) {
    throw std::invalid_argument(std::string(to_string(refusal)));
  }
  return box;
}

}  // namespace

std::vector<kernel::Aabb> CellGrid::cells_of(const kernel::Aabb& box) const {
  Places places(*this);
  places.add(vector_of(box.min), vector_of(box.max));
  return places.cells();
}

std::vector<kernel::Aabb> CellGrid::cells_along(const render::CameraPath& path, double reach) const {
  Places places(*this);
  glm::dvec3 last = path.camera(0, 1).eye;
  for (std::size_t frame = 0; frame < path.frames; ++frame) {
    const glm::dvec3 eye = path.camera(frame, 1).eye;
    const double steps = std::max(1.0, std::ceil(2 * glm::distance(last, eye) / size));  // of half a cell
    if (!(steps <= static_cast<double>(2 * kMostCells))) throw std::length_error("the path is too long for so small cells");
    glm::dvec3 begin = last;
    for (double step = 1; step <= steps; ++step) {
      const glm::dvec3 end = between(last, eye, step / steps);
      places.add(glm::min(begin, end) - reach, glm::max(begin, end) + reach);
      begin = end;
    }
    last = eye;
  }
  return places.cells();
}

render::CameraPath way_of_eyes(const PathArguments& arguments, const render::ModelFile& model, culler::SoupView soup) {
  render::CameraPath path = arguments.through(model);
  if (path.projection == culler::Projection::orthographic) {
    throw render::InputError(arguments.name() + ": its rays are parallel: they come from no eye near the model");
  }
  warn_of_misfit(path, arguments, model.path.string(), soup);
  return path;
}

std::vector<kernel::Aabb> read_cells(const std::string& file) {
  const nlohmann::json root = render::read_json(file);
  const auto fail = [&](const std::string& what) { throw render::InputError(fmt::format("{}: {}", file, what)); };
  if (!root.is_object() || root.size() != 1 || !root.contains("cells") || !root["cells"].is_array()) {
    fail("expected {\"cells\":[{\"min\":[x,y,z],\"max\":[x,y,z]}, …]}");
  }
  const nlohmann::json& list = root["cells"];
  if (list.empty()) fail("no cells");
  if (list.size() > kMostCells) fail(fmt::format("more than {} cells", kMostCells));
  std::vector<kernel::Aabb> cells;
  for (const nlohmann::json& cell : list) {
    try {
      cells.push_back(cell_of(cell));
    } catch (const std::invalid_argument& error) {
      fail(fmt::format("cell {}: {}", cells.size(), error.what()));
    }
  }
  return cells;
}

std::vector<kernel::Aabb> pieces_of(const kernel::Aabb& cell, double side) {
  // Of a cube of that side, 2^32 of them off, each face is rounded by 2^-21 of it at most: it stays one piece.
  constexpr double kRounding = 0x1p-20;
  std::vector<kernel::Aabb> pieces{cell};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = cell.min[axis], high = cell.max[axis],
                 count = std::max(1.0, std::ceil((high - low) / (side * (1 + kRounding))));
    if (!(count * static_cast<double>(pieces.size()) <= static_cast<double>(kMostCells))) {
      throw std::length_error(
          fmt::format("the cell from ({}, {}, {}) to ({}, {}, {}) has more than {} pieces, with --piece {}", cell.min.x,
                      cell.min.y, cell.min.z, cell.max.x, cell.max.y, cell.max.z, kMostCells, side));
    }
    const auto border = [&](double i) {
      return i == count ? high : kernel::flushed(std::min(low + i / count * (high - low), high));
    };
    std::vector<kernel::Aabb> divided;
    for (const kernel::Aabb& piece : pieces) {
      for (double i = 0; i < count; ++i) {
        divided.push_back(piece);
        divided.back().min[axis] = border(i);
        divided.back().max[axis] = border(i + 1);
      }
    }
    pieces = std::move(divided);
  }
  return pieces;
}

}  // namespace occlude::cli
