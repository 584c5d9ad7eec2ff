// SPDX-License-Identifier: MIT
// A corner b of the box is in the shadow from every eye when all eyes are in the shadow from b. This shadow is convex, so it
// is a question about planes: those through b and an edge of a polygon, or two vertices of a polytope with all others on one
// side, and those of the faces turned to b. The points with this property are convex, too, so corners are enough.
#include <vector>

#include "box.h"
#include "eyes.h"
#include "faults.h"
#include "half_spaces.h"
#include "occlude/oracle/region.h"
#include "prepared.h"
#include "region_faults.h"

namespace occlude::oracle {
namespace {

/// The planes of a polygon or of the faces of a polytope. Faces without area have none.
std::vector<LoopPlane> planes_of(const Occluder& occluder) {
  if (const Loop* loop = std::get_if<Loop>(&occluder)) return {LoopPlane{*loop}};
  const auto& [vertices, faces] = std::get<Polytope>(occluder);
  std::vector<LoopPlane> planes;
  for (const auto& face : faces) {
    Loop loop;
    for (const std::uint32_t index : face) loop.push_back(vertices[index]);
    if (side_of_all(LoopPlane{loop}, vertices) != CGAL::ZERO) planes.push_back({std::move(loop)});
  }
  return planes;
}

class Umbra {
 public:
  Umbra(const EyeRegion& region, const Occluder& occluder, const Box& box)
      : region_(region),
        box_(box),
        vertices_(vertices_of(occluder)),
        is_loop_(std::holds_alternative<Loop>(occluder)),
        planes_(planes_of(occluder)) {}

  [[nodiscard]] bool holds(unsigned corner) const {
    bool is_before = false;
    for (const LoopPlane& plane : planes_) {
      const CGAL::Sign side =
          decide([&]<class N>() { return certain_sign(plane.operator()<N>().height(point<N>(corner))); });
      const CGAL::Sign inner = side_of_all(plane, vertices_);
      if (side == CGAL::ZERO || side == inner) continue;
      is_before = true;
      const bool are_eyes_beyond = decide([&]<class N>() {
        return least_side(eyes_of<N>(region_), turned(plane.operator()<N>(), -side)) == CGAL::POSITIVE;
      });
      if (!are_eyes_beyond) return false;
    }
    return is_before && are_eyes_within_sides(corner);
  }

 private:
  template <class N>
  Vector<N> point(unsigned corner) const {
    return std::visit([&](const auto& kind) { return corners_of<N>(kind)[corner]; }, box_);
  }

  template <class N>
  static HalfSpace<N> turned(const HalfSpace<N>& h, CGAL::Sign positive) {
    return positive == CGAL::NEGATIVE ? HalfSpace<N>{-h.normal, h.point, -h.offset} : h;
  }

  bool are_eyes_within_sides(unsigned corner) const {
    const std::size_t size = vertices_.size();
    const auto are_within = [&](std::size_t i, std::size_t j) {
      return vertices_[i] == vertices_[j] || decide([&]<class N>() { return are_eyes_within<N>(point<N>(corner), i, j); });
    };
    for (std::size_t i = 0; i < size; ++i) {
      if (is_loop_ && !are_within(i, (i + 1) % size)) return false;
      for (std::size_t j = 0; j < i && !is_loop_; ++j) {
        if (!are_within(i, j)) return false;
      }
    }
    return true;
  }

  /// Whether the eyes are on the side of the plane through b and two vertices on which all others are, if they are on one.
  /// Those of a loop are on one side of each of its edges.
  template <class N>
  bool are_eyes_within(const Vector<N>& b, std::size_t i, std::size_t j) const {
    const HalfSpace<N> plane{CGAL::cross_product(vector_of<N>(vertices_[i]) - b, vector_of<N>(vertices_[j]) - b), b};
    CGAL::Sign inner = CGAL::ZERO;
    for (std::size_t k = 0; k < vertices_.size() && !(is_loop_ && inner != CGAL::ZERO); ++k) {
      if (k == i || k == j) continue;
      const CGAL::Sign side = certain_sign(plane.height(vertices_[k]));
      if (side != CGAL::ZERO && side == -inner) return true;
      if (side != CGAL::ZERO) inner = side;
    }
    return inner == CGAL::ZERO || least_side(eyes_of<N>(region_), turned(plane, inner)) != CGAL::NEGATIVE;
  }

  const EyeRegion& region_;
  const Box& box_;
  const std::vector<Point>& vertices_;
  bool is_loop_;
  std::vector<LoopPlane> planes_;
};

}  // namespace

Answer relation_to_umbra(const EyeRegion& eyes, const Occluder& occluder, const Box& box) {
  const Point& middle = std::visit([](const auto& kind) -> const Point& { return kind.center; }, eyes);
  if (std::string reason = Shadow({middle}, occluder, {Near::Kind::surface, {}, {}}).refusal(); !reason.empty()) {
    return {std::move(reason), Relation::partial};
  }
  const RoundUpward rounding;
  for (std::string reason : {fault_of(eyes), strict_box_fault(box)}) {
    if (!reason.empty()) return {std::move(reason), Relation::partial};
  }
  const Umbra umbra(eyes, occluder, box);
  const std::size_t corners = std::visit([](const auto& kind) { return corners_of<Interval>(kind).size(); }, box);
  for (unsigned i = 0; i < corners; ++i) {
    if (!umbra.holds(i)) return {"", Relation::partial};
  }
  return {"", Relation::inside};
}

}  // namespace occlude::oracle
