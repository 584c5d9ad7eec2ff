// SPDX-License-Identifier: MIT
#include "town_mesh.h"

#include <algorithm>
#include <cstddef>
#include <osg/PrimitiveSet>

namespace occlude::example {

TownMesh::TownMesh()
    : corners_(new osg::Vec3Array(osg::Array::BIND_PER_VERTEX)),
      normals_(new osg::Vec3Array(osg::Array::BIND_PER_VERTEX)),
      colours_(new osg::Vec3Array(osg::Array::BIND_PER_VERTEX)),
      buffer_(new osg::VertexBufferObject) {
  for (osg::Vec3Array* const array : {corners_.get(), normals_.get(), colours_.get()}) array->setBufferObject(buffer_);
}

void TownMesh::triangle(const std::array<osg::Vec3, 3>& corners, const Colour& colour) {
  osg::Vec3 normal = (corners[1] - corners[0]) ^ (corners[2] - corners[0]);
  normal.normalize();
  for (const osg::Vec3& corner : corners) {
    corners_->push_back(corner);
    normals_->push_back(normal);
    colours_->push_back(colour);
  }
}

void TownMesh::quad(const std::array<osg::Vec3, 4>& corners, const Colour& colour) {
  triangle({corners[0], corners[1], corners[2]}, colour);
  triangle({corners[0], corners[2], corners[3]}, colour);
}

void TownMesh::box(const osg::Vec3& low, const osg::Vec3& high, const Colour& colour) {
  const auto corner = [&](unsigned int i) {
    return osg::Vec3((i & 1U) != 0 ? high.x() : low.x(), (i & 2U) != 0 ? high.y() : low.y(),
                     (i & 4U) != 0 ? high.z() : low.z());
  };
  using Face = std::array<unsigned int, 4>;
  for (const auto& [a, b, c, d] : {Face{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    quad({corner(a), corner(b), corner(c), corner(d)}, colour);
  }
}

void TownMesh::wall(const osg::Vec3& from, const osg::Vec3& to, float height, const Colour& colour,
                    std::span<const Opening> openings) {
  osg::Vec3 along = to - from;
  const float length = along.normalize();
  // Cells between all borders of the openings; those in an opening are left out.
  std::vector<float> across = {0, length}, up = {0, height};
  for (const Opening& opening : openings) {
    across.insert(across.end(), {opening.left, opening.right});
    up.insert(up.end(), {opening.bottom, opening.top});
  }
  std::ranges::sort(across);
  std::ranges::sort(up);
  const auto at = [&](float x, float z) { return from + along * x + osg::Vec3(0, 0, z); };
  for (std::size_t i = 0; i + 1 < across.size(); ++i) {
    for (std::size_t k = 0; k + 1 < up.size(); ++k) {
      const float x = (across[i] + across[i + 1]) / 2, z = (up[k] + up[k + 1]) / 2;
      const bool is_open = std::ranges::any_of(openings, [&](const Opening& opening) {
        return opening.left < x && x < opening.right && opening.bottom < z && z < opening.top;
      });
      if (is_open || across[i] == across[i + 1] || up[k] == up[k + 1]) continue;
      quad({at(across[i], up[k]), at(across[i + 1], up[k]), at(across[i + 1], up[k + 1]), at(across[i], up[k + 1])}, colour);
    }
  }
}

osg::ref_ptr<osg::Geometry> TownMesh::geometry() const {
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setUseDisplayList(false);
  geometry->setUseVertexBufferObjects(true);
  geometry->setVertexArray(corners_);
  geometry->setNormalArray(normals_);
  geometry->setColorArray(colours_);
  geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_->size())));
  return geometry;
}

}  // namespace occlude::example
