// SPDX-License-Identifier: MIT
#include "never_seen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <mutex>
#include <optional>
#include <random>
#include <span>
#include <utility>

#include "base/parallel.h"
#include "held/around_box.h"
#include "model/bounds.h"
#include "occlude/kernel/validity.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/tree_rays.h"

namespace occlude::cli {
namespace {

using Polygons = std::vector<std::uint32_t>;

glm::dvec3 corner_of(const kernel::Aabb& box, unsigned i) {
  return {(i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
          (i & 4U) != 0 ? box.max.z : box.min.z};
}

glm::dvec3 low_of(const kernel::Aabb& box) { return corner_of(box, 0); }
glm::dvec3 high_of(const kernel::Aabb& box) { return corner_of(box, 7); }

int longest_axis(const kernel::Aabb& box) {
  const glm::dvec3 size = high_of(box) - low_of(box);
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

double length_of(const kernel::Aabb& box) {
  const int axis = longest_axis(box);
  return box.max[axis] - box.min[axis];
}

double distance_of(const kernel::Aabb& a, const kernel::Aabb& b) {
  return glm::length(glm::max(glm::max(low_of(a) - high_of(b), low_of(b) - high_of(a)), glm::dvec3(0)));
}

/// Both have the numbers where it is divided.
std::array<kernel::Aabb, 2> halves_of(const kernel::Aabb& box) {
  const int axis = longest_axis(box);
  std::array<kernel::Aabb, 2> halves{box, box};
  halves[0].max[axis] = halves[1].min[axis] = kernel::flushed(box.min[axis] / 2 + box.max[axis] / 2);
  return halves;
}

kernel::Aabb middle_of(const kernel::Aabb& box) {
  kernel::Aabb middle = box;
  for (int axis = 0; axis < 3; ++axis) {
    middle.min[axis] = middle.max[axis] = kernel::flushed(box.min[axis] / 2 + box.max[axis] / 2);
  }
  return middle;
}

/// A camera of all eyes in the cell whose picture has the box, as seen from any of them. None if the eyes are too near.
std::optional<culler::Camera> camera_for(const kernel::Aabb& cell, const kernel::Aabb& box, double near) {
  culler::Camera camera = culler::camera_of(cell);
  camera.target = low_of(middle_of(box));
  const glm::dvec3 sight = glm::abs(camera.target - camera.eye);
  camera.up = sight.z > sight.x && sight.z > sight.y ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  camera.near_plane = std::max(near, kernel::kMinMagnitude);
  if (camera.eye == camera.target) return std::nullopt;
  const auto [right, up, forward] = camera.axes();
  // Room for the picture's pixels, and for what is focused elsewhere.
  constexpr double kRoom = 1.25, kLeast = 0x1p-10, kMost = 8;
  double width = kLeast * kLeast, height = width;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 to = corner_of(box, i) - camera.eye;
    const double away = glm::dot(to, forward) - camera.eyes.reach(forward);
    if (!(away > 0)) return std::nullopt;
    width = std::max(width, (std::fabs(glm::dot(to, right)) + camera.eyes.reach(right)) / away);
    height = std::max(height, (std::fabs(glm::dot(to, up)) + camera.eyes.reach(up)) / away);
  }
  width = std::max(width, height / 4) * kRoom;
  height = std::max(height, width / 4) * kRoom;
  if (!(width < kMost && height < kMost)) return std::nullopt;
  camera.fov_y_deg = std::max(glm::degrees(2 * std::atan(height)), 0.002);
  camera.aspect = width / height;
  return fault(camera).empty() ? std::optional(camera) : std::nullopt;
}

culler::CullOptions cull_options(const SearchOptions& options) {
  culler::CullOptions cull;
  cull.method = culler::Method::cover;
  cull.cover.width = cull.cover.height = static_cast<int>(options.cover_size);
  return cull;
}

/// The polygons that culls of all directions for whole cells show, all at once.
std::vector<bool> shown_from(const culler::Culler& culler, const std::vector<kernel::Aabb>& cells,
                             const SearchOptions& options) {
  std::vector<bool> shown(culler.hierarchy().soup().size());
  std::mutex mutex;
  const auto cull = [&](std::size_t cell) {
    culler::View view;
    for (const culler::Camera& side : culler::cameras_around(cells[cell])) {
      culler.cull(side, cull_options(options), view);
      const std::scoped_lock lock(mutex);
      for (const auto& [first, count] : view.result().drawn) {
        for (std::uint32_t p = first; p < first + count; ++p) shown[p] = true;
      }
    }
  };
  culler::parallel_for(cells.size(), cull, render::check_interrupt);
  return shown;
}

/// Whether a segment from a random eye seems to reach polygon p. Only what is worth asking depends on it.
bool is_reached(std::uint32_t p, const culler::SoupView& soup, const render::TreeRays& rays,
                std::span<const kernel::Aabb> cells, std::size_t count) {
  // Of a segment, what is nearer to its ends than this share is not asked: what touches the point does not hide it.
  constexpr double kEnd = 0x1p-30;
  std::mt19937_64 random(p);
  const auto share = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  const auto loop = soup.loop(p);
  const auto& v = soup.vertices;
  std::uint32_t hider = p;
  for (std::size_t i = 0; i < count; ++i) {
    const kernel::Aabb& cell = cells[random() % cells.size()];
    const glm::dvec3 eye = low_of(cell) + glm::dvec3(share(), share(), share()) * (high_of(cell) - low_of(cell));
    const std::size_t triangle = 1 + random() % (loop.size() - 2);
    double a = share(), b = share();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const glm::dvec3 point = v[loop[0]] + a * (v[loop[triangle]] - v[loop[0]]) + b * (v[loop[triangle + 1]] - v[loop[0]]);
    const auto hides = [&](std::uint32_t other) {
      return other != p && rays.meeting(eye, point - eye, kEnd, other) < 1 - kEnd;
    };
    if (hides(hider)) continue;
    const auto is_hider = [&](std::uint32_t other) { return hides(other) && (hider = other, true); };
    if (!rays.any_of(eye, point - eye, 1, is_hider)) return true;
  }
  return false;
}

/// Asks what of a few polygons that lie together is hidden.
class Question {
 public:
  /// Asks at most so many parts of cells.
  Question(const culler::Culler& culler, Polygons polygons, std::size_t parts, const SearchOptions& options)
      : culler_(culler), polygons_(std::move(polygons)), left_(parts), cull_(cull_options(options)) {}

  /// Those that are hidden from all cells.
  [[nodiscard]] Polygons hidden_from(std::span<const kernel::Aabb> cells) {
    for (const kernel::Aabb& cell : cells) polygons_ = hidden_of(std::move(polygons_), cell);
    return std::move(polygons_);
  }

 private:
  /// Those that are hidden from everywhere in the cell, as far as that is found.
  [[nodiscard]] Polygons hidden_of(Polygons polygons, const kernel::Aabb& cell) {
    constexpr double kFirst = 4, kFinest = 32;  // cells that look longer hide little, and shorter ones hardly more
    constexpr std::size_t kFew = 4;
    if (polygons.empty() || left_ == 0) return {};
    --left_;
    const kernel::Aabb box = box_of(polygons);
    const double share = length_of(cell) == 0 ? 0 : distance_of(cell, box) / length_of(cell);
    if (share < kFirst && length_of(cell) > 0) return hidden_of_halves(std::move(polygons), cell);
    Polygons shown = shown_of(polygons, cell, box);
    if (shown.empty()) return polygons;
    Polygons still;  // that are hidden, of those that this cull shows
    if (shown.size() > kFew) {
      const auto middle = shown.begin() + static_cast<std::ptrdiff_t>(shown.size() / 2);
      still = hidden_of({shown.begin(), middle}, cell);
      const Polygons others = hidden_of({middle, shown.end()}, cell);
      still.insert(still.end(), others.begin(), others.end());
    } else if (length_of(cell) > 0 && share < kFinest) {
      still = without(shown, shown_of(shown, middle_of(cell), box));  // what one eye seems to see is not looked at further
      still = hidden_of_halves(std::move(still), cell);
    }
    return without(std::move(polygons), without(std::move(shown), still));
  }

  /// The polygons that are not among these others. All are in ascending order.
  [[nodiscard]] static Polygons without(Polygons polygons, const Polygons& others) {
    std::erase_if(polygons, [&](std::uint32_t p) { return std::ranges::binary_search(others, p); });
    return polygons;
  }

  [[nodiscard]] Polygons hidden_of_halves(Polygons polygons, const kernel::Aabb& cell) {
    for (const kernel::Aabb& half : halves_of(cell)) polygons = hidden_of(std::move(polygons), half);
    return polygons;
  }

  /// Those that one cull for all eyes of the cell does not hide. What lies beyond the picture is not hidden.
  [[nodiscard]] Polygons shown_of(Polygons polygons, const kernel::Aabb& cell, const kernel::Aabb& box) {
    const std::span<const culler::HierarchyNode> nodes = culler_.hierarchy().nodes();
    // Of what hides, nothing is before the model, and little so near.
    const double near = std::max(distance_of(cell, nodes[0].box), distance_of(cell, box) / 2) / 32;
    const auto camera = camera_for(cell, box, near);
    if (!camera) return polygons;
    for (const culler::Culled& culled : culler_.cull(*camera, cull_, view_).culled) {
      if (culled.by != culler::Culled::By::cover) continue;
      const culler::HierarchyNode& node = nodes[culled.node];
      polygons.erase(std::ranges::lower_bound(polygons, node.first),
                     std::ranges::lower_bound(polygons, node.first + node.count));
    }
    return polygons;
  }

  [[nodiscard]] kernel::Aabb box_of(std::span<const std::uint32_t> polygons) const {
    kernel::Aabb box = culler::empty_box();
    for (const std::uint32_t p : polygons) culler::grow(box, culler_.hierarchy().soup().box(p));
    return box;
  }

  const culler::Culler& culler_;
  Polygons polygons_;
  std::size_t left_;  ///< parts of cells that may still be asked
  culler::CullOptions cull_;
  culler::View view_;
};

}  // namespace

std::vector<bool> never_seen(const culler::Culler& culler, const std::vector<kernel::Aabb>& cells,
                             const std::vector<bool>& candidates, const SearchOptions& options,
                             const std::function<void(std::size_t done, std::size_t all)>& progress) {
  const culler::SoupView& soup = culler.hierarchy().soup();
  const render::TreeRays rays(culler.hierarchy());
  const std::vector<bool> is_shown = shown_from(culler, cells, options);
  std::vector<std::uint8_t> is_asked(candidates.size());
  constexpr std::size_t kBlock = 1024;
  const auto choose = [&](std::size_t block) {
    for (std::size_t p = block * kBlock; p < std::min(is_asked.size(), (block + 1) * kBlock); ++p) {
      if (!candidates[p] || !is_shown[p] || is_reached(static_cast<std::uint32_t>(p), soup, rays, cells, options.rays)) {
        continue;
      }
      is_asked[p] = 1;
    }
  };
  culler::parallel_for((is_asked.size() + kBlock - 1) / kBlock, choose, render::check_interrupt);

  // Polygons that follow each other in the tree lie close together.
  constexpr std::size_t kTogether = 64;
  std::vector<Polygons> groups;
  for (std::uint32_t p = 0; p < is_asked.size(); ++p) {
    if (is_asked[p] == 0) continue;
    if (groups.empty() || groups.back().size() == kTogether) groups.emplace_back();
    groups.back().push_back(p);
  }
  const std::size_t asked = static_cast<std::size_t>(std::ranges::count(is_asked, 1));
  std::mutex mutex;
  std::size_t done = 0;
  const auto ask = [&](std::size_t i) {
    const std::size_t parts = groups[i].size() * options.effort / asked;
    groups[i] = Question(culler, std::move(groups[i]), parts, options).hidden_from(cells);
    const std::scoped_lock lock(mutex);
    progress(++done, groups.size());
  };
  culler::parallel_for(groups.size(), ask, render::check_interrupt);
  std::vector<bool> is_hidden(is_asked.size());
  for (std::size_t p = 0; p < is_hidden.size(); ++p) is_hidden[p] = candidates[p] && !is_shown[p];
  for (const Polygons& polygons : groups) {
    for (const std::uint32_t p : polygons) is_hidden[p] = true;
  }
  return is_hidden;
}

}  // namespace occlude::cli
