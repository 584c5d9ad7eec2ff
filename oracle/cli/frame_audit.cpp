// SPDX-License-Identifier: MIT
#include "frame_audit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "base/parallel.h"
#include "item_buffers.h"
#include "marked_picture.h"
#include "occlude/render/pixel_rays.h"
#include "occlude/render/progress.h"

namespace occlude::cli {
namespace {

using glm::dvec3;

/// What our own cull knows of a polygon.
enum class State : std::uint8_t { out_of_view, hidden, open };

std::vector<State> states_of(const culler::Hierarchy& hierarchy, const culler::CullResult& result) {
  std::vector<State> states(hierarchy.soup().size(), State::open);
  for (const culler::Culled& culled : result.culled) {
    const culler::HierarchyNode& node = hierarchy.nodes()[culled.node];
    const State state = culled.by == culler::Culled::By::view ? State::out_of_view : State::hidden;
    std::fill_n(states.begin() + node.first, node.count, state);
  }
  return states;
}

/// Of the polygons of the tree, for those of the model file.
std::vector<bool> in_tree(const culler::Hierarchy& hierarchy, const std::vector<bool>& of_file) {
  std::vector<bool> result(hierarchy.soup().size());
  for (std::size_t p = 0; p < result.size(); ++p) result[p] = of_file[hierarchy.face(p)];
  return result;
}

glm::dvec2 pixel_of(const LoggedFrame& frame, const dvec3& point) {
  const render::PixelRays rays(frame.shown, frame.width, frame.height);
  return rays.project(point, rays.depth(point));
}

/// The polygons that are culled and that our own cull does not prove hidden, and those of them that are found visible.
class Suspects {
 public:
  Suspects(const culler::Hierarchy& hierarchy, const LoggedFrame& frame, const std::vector<bool>& culled,
           const std::vector<State>& states)
      : hierarchy_(hierarchy), frame_(frame), rays_(hierarchy, frame.camera, culled) {
    for (std::uint32_t p = 0; p < states.size(); ++p) {
      if (culled[p] && states[p] == State::open) open_.push_back(p);
    }
  }

  /// Casts rays into them. Those outside of the picture are suspects no longer.
  void cast(std::size_t rays) {
    struct Found {
      bool is_in_picture = false;
      std::optional<dvec3> point;
    };
    std::vector<Found> found(open_.size());
    const auto cast_into = [&](std::size_t i) {
      std::uint32_t hider = open_[i];
      proof::for_each_triangle(hierarchy_.soup(), open_[i], [&](const oracle::Triangle& triangle) {
        const std::vector<dvec3> part = rays_.in_picture(triangle);
        if (part.size() < 3) return;
        found[i].is_in_picture = true;
        for_each_point(part, rays, [&](const dvec3& point) {
          if (found[i].point || !rays_.seems_clear(point, open_[i], hider)) return;
          if (rays_.shows(point, open_[i])) found[i].point = point;
        });
      });
    };
    culler::parallel_for(open_.size(), cast_into, render::check_interrupt);
    std::vector<std::uint32_t> left;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].point) {
        add(open_[i], *found[i].point);
      } else if (found[i].is_in_picture) {
        left.push_back(open_[i]);
      }
    }
    open_ = std::move(left);
    forget_seen();
  }

  /// Whether none is left.
  [[nodiscard]] bool are_settled() const { return open_.empty(); }

  /// Looks for them in a picture: of the pixels that show one, in scan order, casts a ray through the 1st, 2nd, 4th, 8th and
  /// so on. So rays are spread over it, and few where none of them bears it out.
  void look_at(const render::ItemBuffer& items, const glm::dvec2& offset) {
    const render::PixelRays pixels(frame_.shown, items.width, items.height);
    std::vector<bool> is_sought(hierarchy_.soup().size());
    for (const std::uint32_t p : open_) is_sought[p] = true;
    std::vector<std::uint32_t> pixels_of(is_sought.size());
    for (const render::Items* layer : {static_cast<const render::Items*>(&items), &items.before}) {
      for (int y = 0; y < layer->height; ++y) {
        for (int x = 0; x < layer->width; ++x) {
          const std::uint32_t p = layer->at(x, y);
          if (p == render::kNothing || !is_sought[p] || !std::has_single_bit(++pixels_of[p])) continue;
          const auto [origin, direction] = pixels.ray(x + 0.5 - offset.x, y + 0.5 + offset.y);
          const std::optional<dvec3> point = rays_.where(origin, direction, p);
          if (!point || !rays_.shows(*point, p)) continue;
          add(p, *point);
          is_sought[p] = false;
        }
      }
    }
    forget_seen();
  }

  [[nodiscard]] std::vector<SeenPolygon> seen() const {
    std::vector<SeenPolygon> result;
    for (const auto& [face, polygon] : seen_) result.push_back(polygon);
    return result;
  }
  /// The number of polygons of the file that are left.
  [[nodiscard]] std::size_t unsettled() const {
    std::set<std::uint32_t> faces;
    for (const std::uint32_t p : open_) faces.insert(hierarchy_.face(p));
    return faces.size();
  }

 private:
  /// Calls f(point) for points of a convex polygon: near its corners and sides, where most of what is hidden shows, and
  /// evenly all over it, by a sequence of low discrepancy (Roberts 2018).
  template <class F>
  static void for_each_point(const std::vector<dvec3>& part, std::size_t points, const F& f) {
    constexpr double kInward = 0x1p-10;  // of the way to the middle
    dvec3 middle(0);
    for (const dvec3& corner : part) middle += corner / static_cast<double>(part.size());
    f(middle);
    std::vector<double> areas{0};
    for (std::size_t i = 0; i < part.size(); ++i) {
      const dvec3 &a = part[i], &b = part[(i + 1) % part.size()];
      f(a + kInward * (middle - a));
      const dvec3 side = (a + b) / 2.0;
      f(side + kInward * (middle - side));
      areas.push_back(areas.back() + glm::length(glm::cross(a - middle, b - middle)));
    }
    constexpr double kStepX = 0.7548776662466927, kStepY = 0.5698402909980532;
    for (std::size_t k = 1; k <= points; ++k) {
      const auto share = [&](double step) {
        return static_cast<double>(k) * step - std::floor(static_cast<double>(k) * step);
      };
      // One number chooses the sector of the middle and a side, and the place in it.
      const double area = share(kStepX) * areas.back();
      const auto sector = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
          std::ranges::upper_bound(areas, area) - areas.begin() - 1, 0, static_cast<std::ptrdiff_t>(part.size()) - 1));
      const double width = areas[sector + 1] - areas[sector];
      const double along = width > 0 ? (area - areas[sector]) / width : 0.5;
      const dvec3 &a = part[sector], &b = part[(sector + 1) % part.size()];
      f(middle + std::sqrt(share(kStepY)) * (a + along * (b - a) - middle));
    }
  }

  void add(std::uint32_t p, const dvec3& point) {
    seen_.try_emplace(hierarchy_.face(p), SeenPolygon{hierarchy_.face(p), p, point, pixel_of(frame_, point)});
  }

  /// Of a polygon in pieces, one that is seen is enough.
  void forget_seen() {
    std::erase_if(open_, [&](std::uint32_t p) { return seen_.contains(hierarchy_.face(p)); });
  }

  const culler::Hierarchy& hierarchy_;
  const LoggedFrame& frame_;
  FrameRays rays_;
  std::vector<std::uint32_t> open_;            ///< the suspects that are left
  std::map<std::uint32_t, SeenPolygon> seen_;  ///< by the polygon of the file
};

/// Of several pieces of a polygon, the state of the one that is known least hidden.
std::vector<State> states_of_file(const culler::Hierarchy& hierarchy, const std::vector<State>& states) {
  std::vector<State> result(hierarchy.face_count(), State::out_of_view);
  for (std::size_t p = 0; p < states.size(); ++p) {
    State& state = result[hierarchy.face(p)];
    state = std::max(state, states[p]);
  }
  return result;
}

}  // namespace

FrameAudit Auditor::judge(const LoggedFrame& frame) {
  render::check_interrupt();
  const culler::Hierarchy& hierarchy = culler_.hierarchy();
  const culler::CullResult& result = cull(frame.camera);
  const std::vector<State> states = states_of(hierarchy, result);
  const std::vector<bool> culled = in_tree(hierarchy, frame.culled);
  FrameAudit audit;
  audit.frame = frame.number;
  Suspects suspects(hierarchy, frame, culled, states);
  suspects.cast(options_.rays);
  for (std::size_t turn = 0; !suspects.are_settled() && turn < options_.item_buffers; ++turn) {
    render::check_interrupt();
    const glm::dvec2 offset = ItemBuffers::offset_of(turn);
    suspects.look_at(renderer(frame).item_buffer(frame.shown, result.drawn, offset), offset);
  }
  audit.unsettled = suspects.unsettled();
  audit.visible = suspects.seen();
  const std::vector<State> of_file = states_of_file(hierarchy, states);
  for (std::size_t p = 0; p < of_file.size(); ++p) {
    const bool is_hidden = of_file[p] == State::hidden;
    if (frame.culled[p]) {
      audit.hidden += is_hidden;
    } else {
      audit.drawn += of_file[p] != State::out_of_view;
      audit.needless += is_hidden;
    }
  }
  audit.culled = audit.hidden + audit.visible.size() + audit.unsettled;
  return audit;
}

const culler::CullResult& Auditor::cull(const proof::AnyCamera& camera) {
  const culler::CullOptions options{.method = culler::Method::cover, .cover = options_.cover};
  return std::visit([&](const auto& c) -> const culler::CullResult& { return culler_.cull(c, options, view_); }, camera);
}

render::SceneRenderer& Auditor::renderer(const LoggedFrame& frame) {
  if (!context_) context_ = render::make_offscreen_context();
  if (!renderer_ || renderer_->width() != frame.width || renderer_->height() != frame.height) {
    renderer_ = std::make_unique<render::SceneRenderer>(culler_.hierarchy().soup(), frame.width, frame.height);
  }
  return *renderer_;
}

render::Image Auditor::picture(const LoggedFrame& frame, const std::vector<SeenPolygon>& marked) {
  std::vector<culler::PolygonRange> ranges;
  std::vector<glm::dvec2> places;
  for (const SeenPolygon& polygon : marked) {
    ranges.push_back({polygon.in_tree, 1});
    places.push_back(polygon.pixel);
  }
  render::Image picture = marked_picture(culler_.hierarchy().soup(), renderer(frame), frame.shown, ranges);
  add_rings(picture, places);
  return picture;
}

}  // namespace occlude::cli
