// SPDX-License-Identifier: MIT
#include "silhouette.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "plane_coefficients.h"

namespace occlude::kernel {

ExactPlane side_plane(const Viewpoint& viewpoint, const Vec3& from, const Vec3& to) {
  if (viewpoint.is_eye()) {
    const Vec3& eye = viewpoint.value;
    return {.direct = false, .a_to = from, .a_from = eye, .b_to = to, .b_from = eye, .origin = eye};
  }
  return {.direct = false, .a_to = viewpoint.value, .a_from = {}, .b_to = to, .b_from = from, .origin = from};
}

namespace {

/// Sign of the dot product of the normals of two planes.
int normals_agree(const ExactPlane& p, const ExactPlane& q) {
  return certified([&]<class A>(A& arithmetic) { return arithmetic.sign(dot(normal<A>(p), normal<A>(q))); });
}

/// The way a loop turns at a vertex, seen from the viewpoint.
enum class Turn : std::uint8_t { left, right, straight, back, none };

/// The turn at `b`. `none`: two of the three coincide seen from the viewpoint. `back`: the loop reverses its direction.
Turn turn(const Viewpoint& viewpoint, const Vec3& a, const Vec3& b, const Vec3& c) {
  const ExactPlane incoming = side_plane(viewpoint, a, b);
  const int side = sign_at(incoming, c);
  if (side != 0) return side > 0 ? Turn::left : Turn::right;
  const int agreement = normals_agree(incoming, side_plane(viewpoint, b, c));
  return agreement > 0 ? Turn::straight : agreement < 0 ? Turn::back : Turn::none;
}

bool has_three_distinct(std::span<const Vec3> loop) {
  const auto other = std::find_if(loop.begin(), loop.end(), [&](const Vec3& v) { return v != loop[0]; });
  return std::any_of(other, loop.end(), [&](const Vec3& v) { return v != loop[0] && v != *other; });
}

/// Whether x is seen between a and b, or at one of them. REQUIRES: a and b are neither seen at the same place nor opposite
/// each other, and x is not the eye.
bool is_between(const Viewpoint& viewpoint, const Vec3& a, const Vec3& x, const Vec3& b) {
  const ExactPlane side = side_plane(viewpoint, a, b);
  return sign_at(side, x) == 0 && normals_agree(side_plane(viewpoint, a, x), side) >= 0 &&
         normals_agree(side_plane(viewpoint, x, b), side) >= 0;
}

/// The loop without the vertices at which it does not turn. These are dropped in rounds, each from the first vertex to the
/// last, until the loop turns at every vertex that is left or only two are left. A turn can change only beside a dropped
/// vertex. So after the first round only such vertices are asked again, and rounds cost no more than what they drop.
class Ring {
 public:
  Ring(const Viewpoint& viewpoint, std::span<const Vec3> loop, std::pmr::memory_resource& memory)
      : viewpoint_(viewpoint),
        loop_(loop),
        memory_(memory),
        next_(loop.size(), &memory),
        previous_(loop.size(), &memory),
        turns_(loop.size(), Turn::none, &memory),
        asked_(loop.size(), &memory),
        later_(&memory),
        size_(loop.size()) {
    const auto n = static_cast<Index>(loop.size());
    for (Index i = 0; i < n; ++i) {
      next_[i] = i + 1 < n ? i + 1 : 0;
      previous_[i] = i > 0 ? i - 1 : n - 1;
      asked_[i] = i;
    }
    while (!asked_.empty() && size_ >= 3) ask_round();
    const Index end = size_ < 3 ? dropped_last_ : n;  // a round that leaves two vertices ends there
    for (Index i = 0; i < end; ++i) {
      if (is_left(i)) has_[static_cast<std::size_t>(turns_[i])] = true;
    }
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool has(Turn turn) const { return has_[static_cast<std::size_t>(turn)]; }

  [[nodiscard]] std::pmr::vector<Vec3> corners() const {
    std::pmr::vector<Vec3> corners(&memory_);
    corners.reserve(size_);
    for (Index i = 0; i < loop_.size(); ++i) {
      if (is_left(i)) corners.push_back(loop_[i]);
    }
    return corners;
  }

  /// Whether every dropped vertex is seen on the edge between the two corners that it was dropped between.
  [[nodiscard]] bool keeps_to_its_edges() const {
    const auto n = static_cast<Index>(loop_.size());
    for (Index from = 0; from < n; ++from) {
      if (!is_left(from)) continue;
      const Index to = next_[from];
      for (Index i = from + 1 < n ? from + 1 : 0; i != to; i = i + 1 < n ? i + 1 : 0) {
        if (!is_between(viewpoint_, loop_[from], loop_[i], loop_[to])) return false;
      }
    }
    return true;
  }

 private:
  using Index = std::uint32_t;

  [[nodiscard]] bool is_left(Index i) const { return turns_[i] != Turn::straight && turns_[i] != Turn::none; }

  void ask_round() {
    later_.clear();
    Index end = 0;  // this round has passed the vertices before this one
    for (std::size_t k = 0; k < asked_.size() && size_ >= 3; ++k) {
      for (Index i = asked_[k]; i >= end && size_ >= 3; i = next_[i]) {
        end = i + 1;
        turns_[i] = turn(viewpoint_, loop_[previous_[i]], loop_[i], loop_[next_[i]]);
        if (is_left(i)) break;
        drop(i);
      }
    }
    std::sort(later_.begin(), later_.end());
    later_.erase(std::unique(later_.begin(), later_.end()), later_.end());
    asked_.swap(later_);
  }

  /// Its neighbours have to be asked: in the next round those that this round has passed, in this round the others.
  void drop(Index i) {
    const Index before = previous_[i], after = next_[i];
    next_[before] = after;
    previous_[after] = before;
    --size_;
    dropped_last_ = i;
    (before < i ? later_ : asked_).push_back(before);
    if (after < i) later_.push_back(after);
  }

  const Viewpoint& viewpoint_;
  std::span<const Vec3> loop_;
  std::pmr::memory_resource& memory_;
  std::pmr::vector<Index> next_, previous_;  ///< of each vertex that is left; for a dropped one, its last neighbours
  std::pmr::vector<Turn> turns_;             ///< for a dropped vertex, the reason
  std::pmr::vector<Index> asked_, later_;    ///< the vertices that this round asks, and the next one; ascending
  std::size_t size_;
  Index dropped_last_ = 0;
  std::array<bool, 5> has_{};
};

/// The side to which the loop turns at every vertex; 0 if there is none.
int common_side(const Viewpoint& viewpoint, std::span<const Vec3> loop) {
  const auto side_at = [&](std::size_t i) {
    const Vec3 &a = loop[i], &b = loop[i + 1 < loop.size() ? i + 1 : 0], &c = loop[(i + 2) % loop.size()];
    return sign_at(side_plane(viewpoint, a, b), c);
  };
  const int side = side_at(0);
  // The three turns of a triangle are one determinant.
  for (std::size_t i = 1; side != 0 && loop.size() > 3 && i < loop.size(); ++i) {
    if (side_at(i) != side) return 0;
  }
  return side;
}

/// Whether a loop is the border of a convex cone and runs round it once. REQUIRES: it turns left at each of its corners.
///
/// If so, the other corners are in order about the first one, each less than half a turn from the one before, and all on the
/// inner side of the first edge: within half a turn in all. So some plane has the viewpoint on it and all corners beyond it.
/// Seen through a plane parallel to it, the loop is a planar polygon that does not meet itself, and it is convex because it
/// turns left everywhere. Conversely, every convex loop has these properties. For the corner after the first edge and for
/// the last corner they are turns.
bool is_convex(const Viewpoint& viewpoint, std::span<const Vec3> corners) {
  const ExactPlane first = side_plane(viewpoint, corners[0], corners[1]);
  for (std::size_t i = 3; i + 1 < corners.size(); ++i) {
    if (sign_at(first, corners[i]) <= 0) return false;
    if (sign_at(side_plane(viewpoint, corners[i - 1], corners[i]), corners[0]) <= 0) return false;
  }
  return true;
}

}  // namespace

Silhouette silhouette(const Viewpoint& viewpoint, std::span<const Vec3> loop, std::pmr::memory_resource& memory) {
  if (!has_three_distinct(loop)) return {.corners = {}, .refusal = Refusal::too_few_vertices};
  if (viewpoint.is_eye() && std::find(loop.begin(), loop.end(), viewpoint.value) != loop.end()) {
    return {.corners = {}, .refusal = Refusal::eye_in_plane};
  }
  if (const int side = common_side(viewpoint, loop); side != 0) {
    std::pmr::vector<Vec3> corners(loop.begin(), loop.end(), &memory);
    if (side < 0) std::reverse(corners.begin(), corners.end());
    if (!is_convex(viewpoint, corners)) return {.corners = {}, .refusal = Refusal::not_convex};
    return {.corners = std::move(corners)};
  }
  const Ring ring(viewpoint, loop, memory);
  if (!ring.has(Turn::left) && !ring.has(Turn::right)) return {.corners = {}, .refusal = Refusal::eye_in_plane};
  if (ring.size() < 3 || ring.has(Turn::back) || (ring.has(Turn::left) && ring.has(Turn::right))) {
    return {.corners = {}, .refusal = Refusal::not_convex};
  }
  std::pmr::vector<Vec3> corners = ring.corners();
  if (ring.has(Turn::right)) std::reverse(corners.begin(), corners.end());
  if (!is_convex(viewpoint, corners) || !ring.keeps_to_its_edges()) return {.corners = {}, .refusal = Refusal::not_convex};
  return {.corners = std::move(corners)};
}

}  // namespace occlude::kernel
