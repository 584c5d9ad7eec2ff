// SPDX-License-Identifier: MIT
#include "mesh_data.h"

#include <cstdint>
#include <stdexcept>
#include <string>

#include "arrays.h"
#include "executors.h"
#include "status.h"

namespace occlude::c {
namespace {

using culler::PolygonSoup;

void add_vertices(const occlude_points& points, PolygonSoup& soup) {
  const Points vertices(points.data, points.count, points.stride, points.type, "data of vertices");
  soup.vertices.reserve(points.count);
  for (std::size_t i = 0; i < points.count; ++i) {
    const auto [x, y, z] = vertices[i];
    soup.add_vertex({x, y, z});
  }
}

void add_triangles(std::size_t indices, PolygonSoup& soup) {
  if (indices % 3 != 0) throw std::invalid_argument("triangles: index_count is not a multiple of 3");
  soup.first.reserve(indices / 3 + 1);
  for (std::size_t end = 3; end <= indices; end += 3) soup.first.push_back(PolygonSoup::narrowed(end));
}

void add_polygons(const occlude_mesh_data& data, PolygonSoup& soup) {
  soup.first.reserve(data.polygon_count + 1);
  std::size_t end = 0;
  for (std::size_t p = 0; p < data.polygon_count; ++p) {
    const std::uint32_t size = data.polygon_sizes[p];
    if (size > data.index_count - end) {
      throw std::invalid_argument("polygon " + std::to_string(p) + ": its corners are not among the indices");
    }
    end += size;
    soup.first.push_back(PolygonSoup::narrowed(end));
  }
  if (end != data.index_count) throw std::invalid_argument("the mesh has indices after its last polygon");
}

}  // namespace

PolygonSoup soup_of(const occlude_mesh_data& data) {
  PolygonSoup soup;
  add_vertices(data.vertices, soup);
  if (data.index_count != 0) require(data.indices, "indices");
  if (data.polygon_sizes == nullptr && data.polygon_count != 0) require(data.polygon_sizes, "polygon_sizes");
  if (data.polygon_sizes != nullptr) {
    add_polygons(data, soup);
  } else {
    add_triangles(data.index_count, soup);
  }
  if (data.index_count != 0) soup.indices.assign(data.indices, data.indices + data.index_count);
  if (data.see_through == nullptr) return soup;
  for (std::size_t p = 0; p < soup.size(); ++p) soup.see_through.push_back(data.see_through[p] != 0 ? 1 : 0);
  return soup;
}

culler::Checkpoint checkpoint_of(const occlude_mesh_data& data) {
  using culler::Executor;
  const auto ask = [should_stop = data.should_stop, context = data.context] {
    if (should_stop != nullptr && should_stop(context) != 0) throw Stopped();
  };
  return {ask, data.executor == nullptr ? Executor::own_threads() : to_executor(data.executor)};
}

}  // namespace occlude::c
