// SPDX-License-Identifier: MIT
#include "scene/welded_mesh.h"

#include <algorithm>
#include <cstddef>

#include "cover/placed.h"
#include "cover/prepared_mesh.h"
#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// Adds the polygons of a part. One whose placement is a mirror turns them around, so that what looks counter-clockwise
/// where it stands is what did in its mesh; fans begin at the same corner.
void add(PolygonSoup& soup, std::vector<WeldedMesh::Polygon>& polygons, const WeldedPart& part) {
  const auto& tree = prepared_of(*part.mesh).tree;
  if (!tree) return;
  const SoupView from = tree->soup();
  const bool is_turned = is_mirrored(*part.placement), is_there = *part.placement == Placement{};
  const std::uint32_t first = PolygonSoup::narrowed(soup.vertices.size());
  for (const glm::dvec3& v : from.vertices) {
    soup.add_vertex(is_there ? v : to_glm(placed(*part.placement, to_kernel(v))));
  }
  std::vector<std::uint32_t> loop;
  for (std::size_t p = 0; p < from.size(); ++p) {
    if (!from.is_opaque(p)) continue;  // it hides nothing
    loop.clear();
    for (const std::uint32_t v : from.loop(p)) loop.push_back(first + v);
    if (is_turned) std::reverse(loop.begin() + 1, loop.end());
    soup.add_polygon(loop);
    polygons.push_back({part.id, tree->original(p), is_turned});
  }
}

PolygonSoup soup_of(std::span<const WeldedPart> parts, std::vector<WeldedMesh::Polygon>& polygons) {
  PolygonSoup soup;
  for (const WeldedPart& part : parts) add(soup, polygons, part);
  return soup;
}

}  // namespace

WeldedMesh::WeldedMesh(std::span<const WeldedPart> parts, const Executor& executor)
    : mesh_(soup_of(parts, polygons_), Checkpoint(executor)) {}

}  // namespace occlude::culler
