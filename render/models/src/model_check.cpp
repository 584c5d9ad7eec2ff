// SPDX-License-Identifier: MIT
#include "model_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

std::optional<std::string> coordinate_fault(char axis, double value) {
  switch (kernel::check(value)) {
    case kernel::Refusal::none:
      return std::nullopt;
    case kernel::Refusal::not_finite:
      return fmt::format("{} is not finite", axis);
    default:
      return fmt::format("{} is out of range (neither 0 nor of magnitude 2^-100 to 2^100)", axis);
  }
}

}  // namespace

std::optional<std::string> vertex_fault(const glm::dvec3& v) {
  if (auto fault = coordinate_fault('x', v.x)) return fault;
  if (auto fault = coordinate_fault('y', v.y)) return fault;
  return coordinate_fault('z', v.z);
}

std::size_t drop_tiny(glm::dvec3& v) {
  std::size_t dropped = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (v[axis] == 0 || !(std::abs(v[axis]) < kernel::kMinMagnitude)) continue;
    v[axis] = 0;
    ++dropped;
  }
  return dropped;
}

void require_coarse(const std::filesystem::path& file, culler::SoupView soup) {
  constexpr double kLeast = 0x1p53 * kernel::kMinMagnitude;  // of doubles from here on, the last bit is 2^-100 or more
  const auto is_coarse = [](const glm::dvec3& v) {
    const glm::dvec3 magnitudes = glm::abs(v);
    return std::max({magnitudes.x, magnitudes.y, magnitudes.z}) >= kLeast;
  };
  if (std::ranges::any_of(soup.vertices, is_coarse)) return;
  throw InputError(file.string() +
                   ": coordinates are nearer to 0 than 2^-100, and none reaches 2^-47: give them in another unit");
}

void require_usable(const std::filesystem::path& file, culler::SoupView soup) {
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (soup.empty()) throw InputError(file.string() + ": no polygons");
  if (soup.vertices.size() > kMost || soup.indices.size() > kMost)
    throw InputError(fmt::format("{}: more than {} polygon corners", file.string(), kMost));
}

}  // namespace occlude::render
