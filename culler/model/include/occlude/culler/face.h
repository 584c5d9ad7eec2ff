// SPDX-License-Identifier: MIT
// Faces of any shape, as what a soup draws: the fan of a loop, or triangles. Reading order: 1.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace occlude::culler {

// A face is a loop of vertices, its corners: each is joined to the next by an edge, and the last to the first. It lies in a
// plane, or nearly. It may be concave, and its edges may touch. An opening is joined to the outline by an edge that is
// passed twice, a keyhole. Corners may repeat or lie on a line with their neighbours.
//
// What is said of a face below holds in its picture: the face as it is seen along the coordinate axis that is closest to its
// normal. A corner there is where it is in the file, so all of this is exact. A face whose corners do not lie in a plane is
// the surface of its triangles.
//
// REQUIRES, here and below: all indices of the loop are below vertices.size(); legal coordinates, and rounding to nearest
// (occlude/kernel/validity.h).

/// The vertices of a triangle.
using FaceTriangle = std::array<std::uint32_t, 3>;

/// Triangles that are the face:
/// 1. their corners are the face's;
/// 2. none is turned over;
/// 3. their directed edges are those of the loop, once each, and others, once in each direction (but for triangles without
///    area and edges without length, which are left out).
/// So they cover each point as often as the loop winds round it: once inside of a face, not at all outside and in openings.
/// None where the loop winds round a point the other way, as it does where a face crosses itself; for some loops that cross
/// themselves and wind one way everywhere; and where finding them would take more than kFaceWork steps a corner.
[[nodiscard]] std::optional<std::vector<FaceTriangle>> triangles_of_face(std::span<const glm::dvec3> vertices,
                                                                         std::span<const std::uint32_t> loop);

/// Whether the fan (v0, vi, vi+1) of the loop is the face in the same sense. It always has properties 1 and 3.
[[nodiscard]] bool fan_is_face(std::span<const glm::dvec3> vertices, std::span<const std::uint32_t> loop);

/// Enough for faces with a hundred concave corners of any shape, and for outlines of 100,000 corners like those of coasts. A
/// step takes some three nanoseconds, so a face costs at most about 10 us a corner.
inline constexpr std::uint64_t kFaceWork = 4096;

}  // namespace occlude::culler
