// SPDX-License-Identifier: MIT
// Faces of any shape, in the C interface.
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "arrays.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/validity.h"
#include "status.h"

namespace occlude::c {
namespace {

void require_legal(kernel::Refusal refusal, const std::string& what) {
  if (refusal != kernel::Refusal::none) throw std::invalid_argument(what + std::string(kernel::to_string(refusal)));
}

/// The corners of a face, and the loop of these alone.
struct LoneFace {
  LoneFace(const occlude_points* vertices, const std::uint32_t* indices, std::size_t count) : loop(count) {
    require(vertices, "vertices");
    require(indices, "loop");
    if (count < 3) throw std::invalid_argument("the face has fewer than 3 corners");
    require_legal(kernel::check_rounding(), "");
    const Points points(vertices->data, vertices->count, vertices->stride, vertices->type, "data of vertices");
    for (std::size_t i = 0; i < count; ++i) {
      if (indices[i] >= vertices->count) {
        throw std::invalid_argument("corner " + std::to_string(i) + " is vertex " + std::to_string(indices[i]) + " of " +
                                    std::to_string(vertices->count));
      }
      const auto [x, y, z] = points[indices[i]];
      const kernel::Vec3 corner{kernel::flushed(x), kernel::flushed(y), kernel::flushed(z)};
      require_legal(kernel::check(corner), "corner " + std::to_string(i) + ": ");
      corners.push_back({corner.x, corner.y, corner.z});
    }
    std::iota(loop.begin(), loop.end(), 0U);
  }

  std::vector<glm::dvec3> corners;
  std::vector<std::uint32_t> loop;
};

}  // namespace
}  // namespace occlude::c

using namespace occlude::c;

occlude_status occlude_face_is_fan(const occlude_points* vertices, const uint32_t* loop, size_t count,
                                   int32_t* is_fan) noexcept {
  return guarded([&] {
    require(is_fan, "is_fan");
    const LoneFace face(vertices, loop, count);
    *is_fan = occlude::culler::fan_is_face(face.corners, face.loop) ? 1 : 0;
  });
}

occlude_status occlude_face_triangles(const occlude_points* vertices, const uint32_t* loop, size_t count,
                                      uint32_t* triangles, size_t* triangle_count) noexcept {
  return guarded([&] {
    require(triangles, "triangles");
    require(triangle_count, "triangle_count");
    const LoneFace face(vertices, loop, count);
    const auto found = occlude::culler::triangles_of_face(face.corners, face.loop);
    if (!found) throw std::invalid_argument("the face crosses itself");
    for (const auto& triangle : *found) {
      for (const std::uint32_t corner : triangle) *triangles++ = loop[corner];
    }
    *triangle_count = found->size();
  });
}
