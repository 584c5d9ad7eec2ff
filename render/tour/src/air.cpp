// SPDX-License-Identifier: MIT
#include "air.h"

#include <algorithm>
#include <cmath>

#include "rounds.h"

namespace occlude::render {
namespace {

using glm::dvec3;

// Some 15 MB and a second.
constexpr double kMostCells = 1e6;
constexpr double kMostVisits = 2e7;  // of cells by triangles
// Coarser than a sixteenth of the model the grid tells nothing about openings.
constexpr double kWidestCell = 1.0 / 16;
constexpr std::uint32_t kAround = 3;  // free cells on each side of the model, so that one can go round it

/// How often the triangles go through cells of this width.
double visits(const Place& place, double cell) {
  double sum = 0;
  place.for_each_triangle([&](const dvec3& a, const dvec3& b, const dvec3& c) {
    const double around = glm::distance(a, b) + glm::distance(b, c) + glm::distance(c, a);
    sum += cells_of(0.5 * glm::length(glm::cross(b - a, c - a)), around, cell);
  });
  return sum;
}

}  // namespace

std::optional<Air> Air::find(const Place& place, const culler::Checkpoint& checkpoint) {
  const dvec3 size = place.size();
  const double largest = std::max({size.x, size.y, size.z});
  if (!(largest > 0)) return std::nullopt;
  const auto count = [](double extent, double cell) { return std::ceil(extent / cell) + 2 * kAround; };
  const auto cells = [&](double cell) { return count(size.x, cell) * count(size.y, cell) * count(size.z, cell); };
  double cell = largest / 256;
  while (cells(cell) > kMostCells) cell *= 1.03;
  for (; cell <= largest * kWidestCell; cell *= 1.25) {
    checkpoint();
    if (visits(place, cell) > kMostVisits) continue;
    const auto whole = [&](double extent) { return static_cast<std::uint32_t>(count(extent, cell)); };
    const Columns columns{place.low.x - kAround * cell, place.low.y - kAround * cell, cell, whole(size.x), whole(size.y)};
    return Air(place, columns, place.low.z - kAround * cell, whole(size.z), checkpoint);
  }
  return std::nullopt;
}

Air::Air(const Place& place, const Columns& columns, double z, std::uint32_t nz, const culler::Checkpoint& checkpoint)
    : columns_(columns), z_(z), nz_(nz) {
  find_clearance(place, checkpoint);
  checkpoint();
  find_width();
  checkpoint();
  find_enclosure();
}

glm::dvec3 Air::middle(std::uint32_t cell) const {
  const auto [x, y, z] = position(cell);
  return dvec3(columns_.x, columns_.y, z_) + columns_.cell * (dvec3(x, y, z) + 0.5);
}

std::uint32_t Air::cell_at(const dvec3& point) const {
  const auto at = [&](double p, double start, std::uint32_t count) {
    return static_cast<int>(std::clamp((p - start) / columns_.cell, 0.0, count - 1.0));
  };
  return number(at(point.x, columns_.x, columns_.nx), at(point.y, columns_.y, columns_.ny), at(point.z, z_, nz_));
}

bool Air::is_outermost(std::uint32_t cell) const {
  const auto [x, y, z] = position(cell);
  return !has(x - 1, y, z) || !has(x + 1, y, z) || !has(x, y - 1, z) || !has(x, y + 1, z) || !has(x, y, z + 1);
}

void Air::find_clearance(const Place& place, const culler::Checkpoint& checkpoint) {
  std::vector<std::uint8_t> is_full(size());
  std::size_t triangle = 0;
  place.for_each_triangle([&](const dvec3& a, const dvec3& b, const dvec3& c) {
    checkpoint.at(triangle++);
    for_each_column(columns_, a, b, c, [&](std::size_t column, double low, double high) {
      const auto at = [&](double height) {
        return static_cast<std::size_t>(std::clamp((height - z_) / columns_.cell, 0.0, nz_ - 1.0));
      };
      for (std::size_t z = at(low); z <= at(high); ++z) is_full[column * nz_ + z] = 1;
    });
  });
  std::vector<std::uint32_t> full;
  for (std::uint32_t cell = 0; cell < size(); ++cell) {
    if (is_full[cell] != 0) full.push_back(cell);
  }
  clearance_ = costs(*this, full, checkpoint);
}

/// From the outermost cells, the widest ways first.
void Air::find_width() {
  width_.assign(size(), 0);
  const std::uint32_t most = *std::max_element(clearance_.begin(), clearance_.end());
  std::vector<std::vector<std::uint32_t>> waiting(most + 1);  // by width
  const auto meet = [&](std::uint32_t cell, std::uint32_t width) {
    if (width <= width_[cell]) return;
    width_[cell] = width;
    waiting[width].push_back(cell);
  };
  for (std::uint32_t cell = 0; cell < size(); ++cell) {
    if (is_outermost(cell)) meet(cell, clearance_[cell]);
  }
  for (std::uint32_t width = most; width > 0; --width) {
    for (std::size_t i = 0; i < waiting[width].size(); ++i) {
      const std::uint32_t cell = waiting[width][i];
      if (width_[cell] != width) continue;
      for_each_next(cell, [&](std::uint32_t next, std::uint32_t) { meet(next, std::min(width, clearance_[next])); });
    }
  }
}

void Air::find_enclosure() {
  enclosure_.assign(size(), 0);
  std::vector<std::uint8_t> is_hidden(size());  // whether there is a triangle in the direction
  const auto look = [&](int dx, int dy, int dz, bool forwards) {
    const auto count = static_cast<std::uint32_t>(size());
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t cell = forwards ? i : count - 1 - i;
      const auto [x, y, z] = position(cell);
      const bool has_next = has(x + dx, y + dy, z + dz);
      const std::uint32_t next = has_next ? number(x + dx, y + dy, z + dz) : 0;
      is_hidden[cell] = has_next && (clearance_[next] == 0 || is_hidden[next] != 0) ? 1 : 0;
      enclosure_[cell] = static_cast<std::uint8_t>(enclosure_[cell] + is_hidden[cell]);
    }
  };
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dz = -1; dz <= 1; ++dz) {
        // The next cell in the direction comes first.
        const int order = dy != 0 ? dy : dx != 0 ? dx : dz;
        if (order != 0) look(dx, dy, dz, order < 0);
      }
    }
  }
}

}  // namespace occlude::render
