// SPDX-License-Identifier: MIT
// FCL: a box against a convex mesh, with each of its two solvers, without contacts and without a broad phase.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <memory>

#include "bounded_frustum.h"
#include "peers.h"
#include "vector_math.h"

namespace occlude::bench {
namespace {

struct FclBox {
  fcl::Boxd shape;
  fcl::Transform3d place;
};

fcl::Vector3d to_fcl(const Vec3& v) { return {v.x, v.y, v.z}; }

fcl::Convexd make_convex(const BoundedFrustum& frustum) {
  const auto corners = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Vec3& corner : frustum.corners) corners->push_back(to_fcl(corner));
  const auto faces = std::make_shared<std::vector<int>>();  // for each face the number of its corners, then the corners
  for (const BoundedFrustum::Face& face : BoundedFrustum::kFaces) {
    faces->push_back(static_cast<int>(face.size()));
    for (const std::size_t corner : face) faces->push_back(static_cast<int>(corner));
  }
  return {corners, static_cast<int>(BoundedFrustum::kFaces.size()), faces};
}

std::vector<FclBox> make_boxes(const Workload& workload) {
  std::vector<FclBox> boxes;
  boxes.reserve(workload.boxes.size());
  for (const kernel::Aabb& box : workload.boxes) {
    boxes.push_back({fcl::Boxd(to_fcl(box.max - box.min)), fcl::Transform3d::Identity()});
    boxes.back().place.translation() = to_fcl(center(box));
  }
  return boxes;
}

template <class Solver>
Pass prepare(const Workload& workload) {
  return each_box([boxes = make_boxes(workload), convex = make_convex(BoundedFrustum(workload)),
                   origin = fcl::Transform3d(fcl::Transform3d::Identity()), solver = Solver()](std::size_t i) {
    const bool meet = solver.shapeIntersect(boxes[i].shape, boxes[i].place, convex, origin, nullptr);
    return meet ? kernel::Relation::partial : kernel::Relation::outside;
  });
}

}  // namespace

std::vector<Subject> fcl_subjects() {
  return {{"fcl_libccd", Question::overlap, prepare<fcl::detail::GJKSolver_libccd<double>>, true},
          {"fcl_indep", Question::overlap, prepare<fcl::detail::GJKSolver_indep<double>>, true}};
}

}  // namespace occlude::bench
