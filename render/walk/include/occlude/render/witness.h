// SPDX-License-Identifier: MIT
// The proof of a cull in numbers, for independent checks: one line of JSON per culled subtree.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/culler/scene.h"
#include "occlude/render/input_limits.h"

namespace occlude::render {

using AnyCamera = std::variant<culler::Camera, culler::MatrixCamera>;

/// The covers of what the cover of a frame that was culled with these options hides; none by Method::frusta. A cover of more
/// than kMostCoverVertices vertices is told as covers of smaller subtrees, or of single polygons.
template <class OneCamera>
[[nodiscard]] std::vector<culler::CoverWitness> covers_of(const culler::Culler& culler, const OneCamera& camera,
                                                          const culler::CullResult& result,
                                                          const culler::CullOptions& options) {
  std::vector<culler::CoverWitness> covers;
  culler.append_covers(result, camera, options, kMostCoverVertices, covers);
  return covers;
}

/// Appends one line, without line break, for each culled subtree of a frame. If the leaves of the tree are not of the size
/// that is best for frusta, each line has their size: the order of the triangles depends on it. REQUIRES: `camera` is
/// that of the frame, which was culled with these options; `covers` are covers_of() it. Of a frame that is held, `region` is
/// the camera of its region: what hides is proved for all its eyes, and so are half-spaces beyond the camera's own.
void append_witnesses(std::vector<std::string>& lines, std::size_t frame, const AnyCamera& camera,
                      const culler::Culler& culler, const culler::CullResult& result, const culler::CullOptions& options,
                      std::span<const culler::CoverWitness> covers, const culler::Camera* region = nullptr);

/// The same for each culled object of a scene. REQUIRES: `view` is that of the frame, `objects` has the polygons of each
/// object by its slot, and meshes of occluders are the soup of the tree.
void append_witnesses(std::vector<std::string>& lines, std::size_t frame, const AnyCamera& camera,
                      const culler::Hierarchy& hierarchy, std::span<const culler::HalfSpace> view,
                      std::span<const culler::ObjectWitness> witnesses, std::span<const culler::PolygonRange> objects);

}  // namespace occlude::render
