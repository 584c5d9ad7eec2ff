// SPDX-License-Identifier: MIT
// OpenSceneGraph: its occluder's containment test, and the overlap test of a polytope. Its planes are in double precision,
// its boxes in single precision.
#include <osg/BoundingBox>
#include <osg/Polytope>
#include <osg/ShadowVolumeOccluder>

#include "peers.h"
#include "vector_math.h"

namespace occlude::bench {
namespace {

osg::Vec3d to_osg(const Vec3& v) { return {v.x, v.y, v.z}; }

osg::Polytope make_polytope(const kernel::ShadowFrustum& frustum) {
  osg::Polytope polytope;
  for (std::size_t i = 0; i < frustum.plane_count(); ++i) {
    const kernel::HalfSpace plane = frustum.rounded_plane(i);
    const Vec3& n = plane.normal;
    polytope.add(osg::Plane(n.x, n.y, n.z, plane.offset - dot(n, frustum.origin())));
  }
  return polytope;
}

std::vector<osg::BoundingBox> make_boxes(const Workload& workload) {
  std::vector<osg::BoundingBox> boxes;
  boxes.reserve(workload.boxes.size());
  for (const kernel::Aabb& box : workload.boxes) boxes.emplace_back(to_osg(box.min), to_osg(box.max));
  return boxes;
}

Pass prepare_occluder(const Workload& workload) {
  osg::ShadowVolumeOccluder occluder;
  occluder.getOccluder() = make_polytope(workload.frustum);
  return each_box([boxes = make_boxes(workload), occluder](std::size_t i) mutable {
    return occluder.contains(boxes[i]) ? kernel::Relation::inside : kernel::Relation::partial;
  });
}

Pass prepare_polytope(const Workload& workload) {
  return each_box([boxes = make_boxes(workload), polytope = make_polytope(workload.frustum)](std::size_t i) mutable {
    return polytope.contains(boxes[i]) ? kernel::Relation::partial : kernel::Relation::outside;
  });
}

}  // namespace

std::vector<Subject> osg_subjects() {
  return {{"osg_occluder_contains", Question::containment, prepare_occluder},
          {"osg_polytope_overlap", Question::overlap, prepare_polytope}};
}

}  // namespace occlude::bench
