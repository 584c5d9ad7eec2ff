// SPDX-License-Identifier: MIT
// libccd: GJK and MPR over support functions.
#include <ccd/ccd.h>

#include <cmath>

#include "bounded_frustum.h"
#include "peers.h"
#include "vector_math.h"

namespace occlude::bench {
namespace {

struct CcdBox {
  ccd_vec3_t center, half;
};

struct CcdHull {
  std::array<ccd_vec3_t, 8> corners;
  ccd_vec3_t center;
};

ccd_vec3_t to_ccd(const Vec3& v) { return {{v.x, v.y, v.z}}; }

void box_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* support) {
  const auto& box = *static_cast<const CcdBox*>(object);
  for (int axis = 0; axis < 3; ++axis) {
    support->v[axis] = box.center.v[axis] + std::copysign(box.half.v[axis], direction->v[axis]);
  }
}

void hull_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* support) {
  const auto& hull = *static_cast<const CcdHull*>(object);
  const ccd_vec3_t* farthest = hull.corners.data();
  double reach = ccdVec3Dot(farthest, direction);
  for (const ccd_vec3_t& corner : hull.corners) {
    const double its = ccdVec3Dot(&corner, direction);
    if (its > reach) {
      reach = its;
      farthest = &corner;
    }
  }
  *support = *farthest;
}

void box_center(const void* object, ccd_vec3_t* at) { *at = static_cast<const CcdBox*>(object)->center; }
void hull_center(const void* object, ccd_vec3_t* at) { *at = static_cast<const CcdHull*>(object)->center; }

void from_center_to_center(const void* hull, const void* box, ccd_vec3_t* direction) {
  ccdVec3Sub2(direction, &static_cast<const CcdBox*>(box)->center, &static_cast<const CcdHull*>(hull)->center);
}

ccd_t settings() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.first_dir = from_center_to_center;
  ccd.support1 = hull_support;
  ccd.support2 = box_support;
  ccd.center1 = hull_center;
  ccd.center2 = box_center;
  ccd.max_iterations = 500;  // the default has no limit, and shapes that touch can make it run for ever
  return ccd;
}

CcdHull make_hull(const BoundedFrustum& frustum) {
  CcdHull hull{};
  for (std::size_t i = 0; i < hull.corners.size(); ++i) hull.corners[i] = to_ccd(frustum.corners[i]);
  hull.center = to_ccd(frustum.center);
  return hull;
}

template <auto kIntersect>
Pass prepare(const Workload& workload) {
  std::vector<CcdBox> boxes;
  boxes.reserve(workload.boxes.size());
  for (const kernel::Aabb& box : workload.boxes) boxes.push_back({to_ccd(center(box)), to_ccd(half_extents(box))});
  return each_box([boxes = std::move(boxes), hull = make_hull(BoundedFrustum(workload)), ccd = settings()](std::size_t i) {
    return kIntersect(&hull, &boxes[i], &ccd) != 0 ? kernel::Relation::partial : kernel::Relation::outside;
  });
}

}  // namespace

std::vector<Subject> libccd_subjects() {
  return {{"libccd_mpr", Question::overlap, prepare<ccdMPRIntersect>, true},
          {"libccd_gjk", Question::overlap, prepare<ccdGJKIntersect>, true}};
}

}  // namespace occlude::bench
