// SPDX-License-Identifier: MIT
#include "never_seen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <limits>
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

int longest_axis(const kernel::Aabb& box) {
  const glm::dvec3 size = culler::to_glm(box.max) - culler::to_glm(box.min);
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
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
  camera.target = culler::to_glm(middle_of(box).min);
  const glm::dvec3 sight = glm::abs(camera.target - camera.eye);
  camera.up = sight.z > sight.x && sight.z > sight.y ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  camera.near_plane = std::max(near, kernel::kMinMagnitude);
  if (camera.eye == camera.target) return std::nullopt;
  const auto [right, up, forward] = camera.axes();
  // Room for the picture's pixels, and for what is focused elsewhere.
  constexpr double kRoom = 1.25, kLeast = 0x1p-10, kMost = 8;
  double width = kLeast * kLeast, height = width;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 to = culler::to_glm(culler::corner(box, i)) - camera.eye;
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
    const glm::dvec3 eye = culler::to_glm(cell.min) +
                           glm::dvec3(share(), share(), share()) * (culler::to_glm(cell.max) - culler::to_glm(cell.min));
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

/// Whether these are hidden from everywhere in a part of a cell. In ascending order.
struct Ask {
  kernel::Aabb cell;
  Polygons polygons;
};

class Search {
 public:
  Search(const culler::Culler& culler, const SearchOptions& options)
      : culler_(culler),
        cull_(cull_options_of(options)),
        keeps_looks_(options.keeps_looks),
        is_given_up_(culler.hierarchy().soup().size()) {}

  /// What of the polygons of these asks is hidden, of each from its cell, with at most so many culls; these are deducted.
  /// Wide before narrow: all asks are answered before any is divided, so that what asks for least is found first.
  void answer(std::vector<Ask> asks, std::size_t& culls) {
    while (!asks.empty()) {
      give_up_beyond(asks, culls);
      culls -= asks.size();
      std::vector<Look> looks(asks.size());
      const auto look = [&](std::size_t i) {
        culler::View view;
        Polygons shown = shown_of(asks[i], view, looks[i].cameras);
        looks[i].cell = asks[i].cell;
        std::ranges::set_difference(asks[i].polygons, shown, std::back_inserter(looks[i].hidden));
        asks[i].polygons = std::move(shown);
      };
      culler::parallel_for(asks.size(), look, render::check_interrupt);
      if (keeps_looks_) std::ranges::move(looks, std::back_inserter(looks_));
      std::vector<Ask> parts;
      for (Ask& ask : asks) divide(std::move(ask), parts);
      asks = std::move(parts);
    }
  }

  [[nodiscard]] bool is_given_up(std::uint32_t p) const { return is_given_up_[p]; }

  /// What is left of all looks without what was given up.
  [[nodiscard]] std::vector<Look> take_looks() {
    for (Look& look : looks_) std::erase_if(look.hidden, [&](std::uint32_t p) { return is_given_up_[p]; });
    std::erase_if(looks_, [](const Look& look) { return look.hidden.empty(); });
    return std::move(looks_);
  }

 private:
  /// Gives polygons up until there are no more asks than this: first those that are in the most asks.
  void give_up_beyond(std::vector<Ask>& asks, std::size_t most) {
    forget_what_is_given_up(asks);
    if (asks.size() <= most) return;
    std::vector<std::uint32_t> asks_of(is_given_up_.size());
    for (const Ask& ask : asks) {
      for (const std::uint32_t p : ask.polygons) ++asks_of[p];
    }
    std::vector<std::uint32_t> least;
    for (const Ask& ask : asks) {
      const auto fewest = std::ranges::min_element(ask.polygons, {}, [&](std::uint32_t p) { return asks_of[p]; });
      least.push_back(asks_of[*fewest]);
    }
    std::ranges::nth_element(least, least.begin() + static_cast<std::ptrdiff_t>(most));
    for (const Ask& ask : asks) {
      for (const std::uint32_t p : ask.polygons) is_given_up_[p] = is_given_up_[p] || asks_of[p] >= least[most];
    }
    forget_what_is_given_up(asks);
  }

  void forget_what_is_given_up(std::vector<Ask>& asks) const {
    for (Ask& ask : asks) std::erase_if(ask.polygons, [&](std::uint32_t p) { return is_given_up_[p]; });
    std::erase_if(asks, [](const Ask& ask) { return ask.polygons.empty(); });
  }

  /// Appends asks for what is left of this one, which are easier to answer: of fewer polygons, or of a smaller part.
  void divide(Ask ask, std::vector<Ask>& parts) {
    // A picture of polygons that lie no wider than this has room for what hides them. A cell that is shorter, as seen from
    // there, hides hardly more.
    constexpr double kWide = 4, kFinest = 64;
    if (ask.polygons.empty()) return;
    const kernel::Aabb box = box_of(ask.polygons);
    const double length = culler::length_of(ask.cell);
    if (ask.polygons.size() > 1 && culler::length_of(box) > kWide * length) {
      const auto middle = ask.polygons.begin() + static_cast<std::ptrdiff_t>(ask.polygons.size() / 2);
      parts.push_back({ask.cell, {ask.polygons.begin(), middle}});
      parts.push_back({ask.cell, {middle, ask.polygons.end()}});
    } else if (length * kFinest > culler::distance(ask.cell, box)) {
      const auto [one, other] = halves_of(ask.cell);
      parts.push_back({one, ask.polygons});
      parts.push_back({other, std::move(ask.polygons)});
    } else {
      for (const std::uint32_t p : ask.polygons) is_given_up_[p] = true;
    }
  }

  /// Those that culls for all eyes of the cell do not hide. Adds the cameras of these culls.
  [[nodiscard]] Polygons shown_of(const Ask& ask, culler::View& view, std::vector<culler::Camera>& cameras) const {
    const kernel::Aabb box = box_of(ask.polygons);
    const std::span<const culler::HierarchyNode> nodes = culler_.hierarchy().nodes();
    // Of what hides, nothing is before the model, and little so near.
    const double near = std::max(culler::distance(ask.cell, nodes[0].box), culler::distance(ask.cell, box) / 2) / 32;
    Polygons polygons = ask.polygons, shown;
    if (const auto camera = camera_for(ask.cell, box, near)) {  // what lies beyond the picture is not hidden
      cameras.push_back(*camera);
      for (const culler::Culled& culled : culler_.cull(*camera, cull_, view).culled) {
        if (culled.by != culler::Culled::By::cover) continue;
        const culler::HierarchyNode& node = nodes[culled.node];
        polygons.erase(std::ranges::lower_bound(polygons, node.first),
                       std::ranges::lower_bound(polygons, node.first + node.count));
      }
      return polygons;
    }
    for (const culler::Camera& side : culler::cameras_around(ask.cell)) {
      cameras.push_back(side);
      for (const auto& [first, count] : culler_.cull(side, cull_, view).drawn) {
        const auto begin = std::ranges::lower_bound(polygons, first),
                   end = std::ranges::lower_bound(polygons, first + count);
        shown.insert(shown.end(), begin, end);
        polygons.erase(begin, end);
      }
    }
    std::ranges::sort(shown);
    return shown;
  }

  [[nodiscard]] kernel::Aabb box_of(std::span<const std::uint32_t> polygons) const {
    kernel::Aabb box = culler::empty_box();
    for (const std::uint32_t p : polygons) culler::grow(box, culler_.hierarchy().soup().box(p));
    return box;
  }

  const culler::Culler& culler_;
  culler::CullOptions cull_;
  bool keeps_looks_;
  std::vector<Look> looks_;
  std::vector<bool> is_given_up_;  ///< of each polygon, whether it is not asked for any more, and counts as seen
};

/// The cells, divided into as many parts as this at most, the longest first, but not into shorter ones than are worth it.
std::vector<kernel::Aabb> divided(std::vector<kernel::Aabb> cells, const kernel::Aabb& model, std::size_t most) {
  constexpr double kFirst = 6;  // a cell that looks longer from the model hides little
  const auto is_longer = [](const kernel::Aabb& a, const kernel::Aabb& b) {
    return culler::length_of(a) < culler::length_of(b);
  };
  std::ranges::make_heap(cells, is_longer);
  while (cells.size() < most && culler::length_of(cells.front()) * kFirst > culler::distance(cells.front(), model)) {
    const auto halves = halves_of(cells.front());
    std::ranges::pop_heap(cells, is_longer);
    cells.back() = halves[0];
    std::ranges::push_heap(cells, is_longer);
    cells.push_back(halves[1]);
    std::ranges::push_heap(cells, is_longer);
  }
  return cells;
}

}  // namespace

culler::CullOptions cull_options_of(const SearchOptions& options) {
  culler::CullOptions cull;
  cull.method = culler::Method::cover;
  cull.cover.width = cull.cover.height = static_cast<int>(options.cover_size);
  return cull;
}

NeverSeen never_seen(const culler::Culler& culler, const std::vector<kernel::Aabb>& cells,
                     const std::vector<bool>& candidates, const SearchOptions& options,
                     const std::function<void(std::size_t done, std::size_t all)>& progress) {
  const culler::SoupView& soup = culler.hierarchy().soup();
  const render::TreeRays rays(culler.hierarchy());
  std::vector<std::uint8_t> is_asked(candidates.size());
  constexpr std::size_t kBlock = 1024;
  const auto choose = [&](std::size_t block) {
    for (std::size_t p = block * kBlock; p < std::min(is_asked.size(), (block + 1) * kBlock); ++p) {
      if (!candidates[p] || is_reached(static_cast<std::uint32_t>(p), soup, rays, cells, options.rays)) continue;
      is_asked[p] = 1;
    }
  };
  culler::parallel_for((is_asked.size() + kBlock - 1) / kBlock, choose, render::check_interrupt);
  Polygons hidden;
  for (std::uint32_t p = 0; p < is_asked.size(); ++p) {
    if (is_asked[p] != 0) hidden.push_back(p);
  }

  // A few parts at a time, from all directions: what is not hidden from these is given up before others are asked.
  constexpr std::size_t kTogether = 32, kCullsOfPart = 16, kMostShares = 4;
  std::vector<kernel::Aabb> parts = divided(cells, culler.hierarchy().nodes()[0].box, options.effort / kCullsOfPart);
  std::mt19937_64 random(1);
  for (std::size_t i = parts.size(); i > 1; --i) std::swap(parts[i - 1], parts[random() % i]);
  Search search(culler, options);
  std::size_t left = options.effort;
  for (std::size_t i = 0; i < parts.size() && !hidden.empty(); i += kTogether) {
    const std::size_t end = std::min(parts.size(), i + kTogether);
    std::vector<Ask> asks;
    for (std::size_t k = i; k < end; ++k) asks.push_back({parts[k], hidden});
    const std::size_t share = std::min(left, kMostShares * left * (end - i) / (parts.size() - i));
    std::size_t culls = share + asks.size();
    left -= share;
    search.answer(std::move(asks), culls);
    left += culls;
    std::erase_if(hidden, [&](std::uint32_t p) { return search.is_given_up(p); });
    progress(end, parts.size());
  }
  NeverSeen found{std::vector<bool>(is_asked.size()), search.take_looks()};
  for (const std::uint32_t p : hidden) found.polygons[p] = true;
  return found;
}

}  // namespace occlude::cli
