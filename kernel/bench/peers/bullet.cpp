// SPDX-License-Identifier: MIT
// Bullet in double precision: the GJK of its GJK-EPA solver and the GJK of its pair detector. The shapes have no margins.
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>

#include "bounded_frustum.h"
#include "peers.h"
#include "vector_math.h"

namespace occlude::bench {
namespace {

btVector3 to_bullet(const Vec3& v) { return {v.x, v.y, v.z}; }

btTransform at(const Vec3& v) { return btTransform(btMatrix3x3::getIdentity(), to_bullet(v)); }

struct BulletBox {
  explicit BulletBox(const kernel::Aabb& box) : shape(to_bullet(half_extents(box))), place(at(center(box))) {
    shape.setMargin(0);
  }
  btBoxShape shape;
  btTransform place;
};

/// The frustum relative to its centre, because the search starts from the origins of the shapes.
struct BulletHull {
  explicit BulletHull(const BoundedFrustum& frustum) : place(at(frustum.center)) {
    for (const Vec3& corner : frustum.corners) shape.addPoint(to_bullet(corner - frustum.center), false);
    shape.recalcLocalAabb();
    shape.setMargin(0);
  }
  btConvexHullShape shape;
  btTransform place;
};

/// Bullet's shapes know their own addresses, so they are made once and never moved.
struct Scene {
  explicit Scene(const Workload& workload)
      : hull(BoundedFrustum(workload)), boxes(workload.boxes.begin(), workload.boxes.end()) {}
  BulletHull hull;
  std::vector<BulletBox> boxes;
};

bool gjk_epa_meets(const BulletHull& hull, const BulletBox& box) {
  btGjkEpaSolver2::sResults results;
  const btVector3 guess = hull.place.getOrigin() - box.place.getOrigin();
  return !btGjkEpaSolver2::Distance(&hull.shape, hull.place, &box.shape, box.place, guess, results);
}

/// Without a solver for the penetration depth, the detector reports a point only for disjoint shapes.
bool pair_detector_meets(const BulletHull& hull, const BulletBox& box) {
  btVoronoiSimplexSolver simplex;
  btGjkPairDetector detector(&hull.shape, &box.shape, &simplex, nullptr);
  detector.setCachedSeparatingAxis(hull.place.getOrigin() - box.place.getOrigin());
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = hull.place;
  input.m_transformB = box.place;
  btPointCollector collector;
  detector.getClosestPoints(input, collector, nullptr);
  return !collector.m_hasResult;
}

template <auto kMeets>
Pass prepare(const Workload& workload) {
  return each_box([scene = std::make_shared<const Scene>(workload)](std::size_t i) {
    return kMeets(scene->hull, scene->boxes[i]) ? kernel::Relation::partial : kernel::Relation::outside;
  });
}

}  // namespace

std::vector<Subject> bullet_subjects() {
  return {{"bullet_gjk_epa", Question::overlap, prepare<gjk_epa_meets>, true},
          {"bullet_pair_detector", Question::overlap, prepare<pair_detector_meets>, true}};
}

}  // namespace occlude::bench
