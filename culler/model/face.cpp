// SPDX-License-Identifier: MIT
// Ears are clipped. A triangle of three successive corners of what is left is cut off where it is not turned over. The edges
// of triangles and of what is left always add up to the loop. So whatever is cut off, and in whatever order, properties 1 to
// 3 hold once nothing is left. Which triangles are ears decides only whether it comes to that: a corner inside of one would
// be left outside of the rest, where the loop turns the other way.
#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/bounds.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/orientation.h"

namespace occlude::culler {
namespace {

/// The corners of a face.
class Corners {
 public:
  Corners(std::span<const glm::dvec3> vertices, std::span<const std::uint32_t> loop) : vertices_(vertices), loop_(loop) {}

  [[nodiscard]] std::size_t size() const { return loop_.size(); }
  [[nodiscard]] std::uint32_t vertex(std::size_t place) const { return loop_[place]; }
  [[nodiscard]] const glm::dvec3& operator[](std::size_t place) const { return vertices_[loop_[place]]; }

 private:
  std::span<const glm::dvec3> vertices_;
  std::span<const std::uint32_t> loop_;
};

/// The face as it is seen along one axis.
class FacePicture {
 public:
  explicit FacePicture(const Corners& corners) : corners_(corners) {
    glm::dvec3 normal(0), size(0);  // a face that crosses itself may have a size without a normal
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const glm::dvec3 part = glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
      normal += part;
      size += glm::abs(part);
    }
    for (int axis = 1; axis < 3; ++axis) {
      if (size[axis] > size[axis_]) axis_ = axis;
    }
    side_ = normal[axis_] < 0 ? -1 : 1;
  }

  /// 1 where a, b, c turn as the face does, -1 where they turn the other way, 0 where they lie on a line. Exact.
  [[nodiscard]] int turn(std::size_t a, std::size_t b, std::size_t c) const {
    return side_ * kernel::turn(axis_, to_kernel(corners_[a]), to_kernel(corners_[b]), to_kernel(corners_[c]));
  }
  /// Whether the ways from `from` to a and to b begin in the same direction. REQUIRES: the three lie on a line.
  [[nodiscard]] bool is_one_way(std::size_t from, std::size_t a, std::size_t b) const {
    for (const int axis : {(axis_ + 1) % 3, (axis_ + 2) % 3}) {
      const double start = corners_[from][axis], to_a = corners_[a][axis], to_b = corners_[b][axis];
      if ((to_a < start && to_b < start) || (to_a > start && to_b > start)) return true;
    }
    return false;
  }
  /// Whether a, b, c lie on a line in space.
  [[nodiscard]] bool is_line(std::size_t a, std::size_t b, std::size_t c) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (kernel::turn(axis, to_kernel(corners_[a]), to_kernel(corners_[b]), to_kernel(corners_[c])) != 0) return false;
    }
    return true;
  }
  /// Where a corner is in the picture, from left to right and upwards.
  [[nodiscard]] double across(std::size_t corner) const { return corners_[corner][(axis_ + 1) % 3]; }
  [[nodiscard]] double up(std::size_t corner) const { return corners_[corner][(axis_ + 2) % 3]; }

 private:
  Corners corners_;
  int axis_ = 0, side_ = 1;
};

class EarClipping {
 public:
  explicit EarClipping(const Corners& corners) : corners_(corners), picture_(corners), most_(kFaceWork * corners.size()) {
    link();
    for (Place b = 0; b < corners.size(); ++b) {
      if (is_gone(b)) continue;
      asked_.push_back(b);
      is_convex_[b] = turn_at(b) > 0;
      if (!is_convex_[b]) concave_.push_back(b);
    }
    std::ranges::sort(concave_, {}, [&](Place b) { return picture_.across(b); });
  }

  std::optional<std::vector<FaceTriangle>> triangles() {
    while (left_ > 2) {
      if (work_ > most_ || !(clip_ears(true) || clip_flat() || clip_one())) return std::nullopt;
    }
    return std::move(triangles_);
  }

 private:
  using Place = std::uint32_t;  ///< in the loop
  using Triangle = std::array<Place, 3>;

  /// Links the corners, without those that repeat the one before.
  void link() {
    const Place count = static_cast<Place>(corners_.size());
    next_.assign(count, kGone);
    before_.assign(count, kGone);
    is_convex_.assign(count, false);
    std::vector<Place> kept;
    for (Place b = 0; b < count; ++b) {
      if (kept.empty() || corners_[b] != corners_[kept.back()]) kept.push_back(b);
    }
    while (kept.size() > 1 && corners_[kept.back()] == corners_[kept.front()]) kept.pop_back();
    left_ = kept.size();
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const Place following = kept[(i + 1) % kept.size()];
      next_[kept[i]] = following;
      before_[following] = kept[i];
    }
  }

  [[nodiscard]] bool is_gone(Place b) const { return next_[b] == kGone; }

  int turn(Place a, Place b, Place c) {
    ++work_;
    return picture_.turn(a, b, c);
  }
  int turn_at(Place b) { return turn(before_[b], b, next_[b]); }

  /// Clips the ears among those who are to be asked. Returns whether there was one. `strictly`: what only touches a triangle
  /// counts as inside of it.
  bool clip_ears(bool strictly, std::size_t most = ~std::size_t{0}) {
    const std::size_t left_before = left_;
    for (; asked_from_ < asked_.size() && left_ > 2 && left_before - left_ < most && work_ <= most_; ++asked_from_) {
      const Place b = asked_[asked_from_];
      if (!is_gone(b) && (is_convex_[b] ? !has_inside(b, strictly) : is_fold(b))) clip(b);
    }
    return left_ < left_before;
  }

  /// Whether the loop turns back at `b`, on the way it came. Nothing is lost without this corner, and no ear is right as
  /// long as it is there.
  bool is_fold(Place b) { return turn_at(b) == 0 && picture_.is_one_way(b, before_[b], next_[b]); }

  /// Removes corners that lie on a line with their neighbours, which changes no area. Returns whether there was one.
  bool clip_flat() {
    const std::size_t left_before = left_;
    const std::size_t asked = ask_all();
    for (std::size_t i = 0; i < asked && left_ > 2; ++i) {
      const Place b = asked_[i];
      if (!is_gone(b) && !is_convex_[b] && turn_at(b) == 0) clip(b);
    }
    return left_ < left_before;
  }

  /// Clips an ear although the loop touches it. Returns whether there was one.
  bool clip_one() {
    ask_all();
    return clip_ears(false, 1);
  }

  std::size_t ask_all() {
    asked_.clear();
    asked_from_ = 0;
    for (Place b = 0; b < next_.size(); ++b) {
      if (!is_gone(b)) asked_.push_back(b);
    }
    work_ += next_.size();
    return asked_.size();
  }

  void clip(Place b) {
    const Place a = before_[b], c = next_[b];
    if (is_convex_[b] || !picture_.is_line(a, b, c)) {
      triangles_.push_back({corners_.vertex(a), corners_.vertex(b), corners_.vertex(c)});
    }
    next_[a] = c;
    before_[c] = a;
    next_[b] = kGone;
    --left_;
    for (const Place neighbour : {a, c}) {
      is_convex_[neighbour] = turn_at(neighbour) > 0;
      asked_.push_back(neighbour);
    }
  }

  /// Whether the loop is somewhere inside of the triangle at `b`. Where it is, a corner that is not convex is there, too.
  bool has_inside(Place b, bool strictly) {
    const Place a = before_[b], c = next_[b];
    const auto across = [&](Place p) { return picture_.across(p); };
    const auto [left, right] = std::minmax({across(a), across(b), across(c)});
    const auto [low, high] = std::minmax({picture_.up(a), picture_.up(b), picture_.up(c)});
    for (auto p = std::ranges::lower_bound(concave_, left, {}, across); p != concave_.end() && across(*p) <= right; ++p) {
      ++work_;
      const double up = picture_.up(*p);
      if (up < low || up > high || is_gone(*p) || is_convex_[*p] || *p == a || *p == b || *p == c) continue;
      if (is_inside(*p, {a, b, c}, strictly)) return true;
    }
    return false;
  }

  bool is_inside(Place p, const Triangle& triangle, bool strictly) {
    const auto& [a, b, c] = triangle;
    const std::array<int, 3> sides{turn(a, b, p), turn(b, c, p), turn(c, a, p)};
    if (std::ranges::min(sides) < 0) return false;
    const auto on = std::ranges::count(sides, 0);
    if (on < 2) return on == 0 || strictly;
    // It is at a corner of the triangle, and the loop may go on from there into the triangle.
    const std::size_t at = sides[0] != 0 ? 2 : sides[1] != 0 ? 0 : 1;
    return is_between(triangle, at, next_[p]) || is_between(triangle, at, before_[p]);
  }

  /// Whether the way from a corner of the triangle to `q` begins inside of it.
  bool is_between(const Triangle& triangle, std::size_t at, Place q) {
    const Place corner = triangle[at], after = triangle[(at + 1) % 3], before = triangle[(at + 2) % 3];
    return turn(corner, after, q) > 0 && turn(corner, q, before) > 0;
  }

  static constexpr Place kGone = ~Place{0};

  Corners corners_;
  FacePicture picture_;
  std::vector<Place> next_, before_;
  std::vector<bool> is_convex_;  ///< as it is now
  std::vector<Place> concave_;   ///< who was not at first, from left to right
  std::vector<Place> asked_;     ///< who may be an ear or a fold, from asked_from_ on
  std::size_t asked_from_ = 0, left_ = 0;
  std::uint64_t work_ = 0, most_;
  std::vector<FaceTriangle> triangles_;
};

}  // namespace

bool fan_is_face(std::span<const glm::dvec3> vertices, std::span<const std::uint32_t> loop) {
  if (loop.size() <= 3) return true;
  const FacePicture picture(Corners(vertices, loop));
  int side = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const int turn = picture.turn(0, i, i + 1);
    if (turn * side < 0) return false;
    if (turn != 0) side = turn;
  }
  return true;
}

std::optional<std::vector<FaceTriangle>> triangles_of_face(std::span<const glm::dvec3> vertices,
                                                           std::span<const std::uint32_t> loop) {
  return EarClipping(Corners(vertices, loop)).triangles();
}

}  // namespace occlude::culler
