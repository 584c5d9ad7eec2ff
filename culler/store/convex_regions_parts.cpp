// SPDX-License-Identifier: MIT
// The parts of convex regions, and the checks of parts that are said to be those.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "base/part_checks.h"
#include "frusta/convex_regions.h"
#include "model/part_list.h"

namespace occlude::culler {
namespace {

constexpr std::string_view kRegionVertices = "region corners", kRegionFirstVertex = "region first corner",
                           kRegionPolygons = "region polygons", kRegionFirstPolygon = "region first polygon",
                           kRegionWhole = "whole", kRegionRuns = "pieces";

/// How much more often the sides of some loops run from one corner of a region to another than back.
class Traversals {
 public:
  /// REQUIRES: the region has at most ConvexRegions::kMostJoined corners.
  Traversals(SoupView soup, std::span<const std::uint32_t> corners) : soup_(soup), corners_(corners) {
    std::ranges::fill(used(), 0);
  }

  /// Counts the sides of the loop, each as so many. Says whether all its corners are corners of the region.
  bool add(std::span<const std::uint32_t> loop, int many) {
    std::size_t from = number(loop.back());
    for (const std::uint32_t v : loop) {
      const std::size_t to = number(v);
      if (from == corners_.size() || to == corners_.size()) return false;
      more_[from * corners_.size() + to] += many;
      more_[to * corners_.size() + from] -= many;
      from = to;
    }
    return true;
  }
  [[nodiscard]] bool are_none() {
    return std::ranges::all_of(used(), [](std::int64_t more) { return more == 0; });
  }

 private:
  [[nodiscard]] std::span<std::int64_t> used() { return std::span(more_).first(corners_.size() * corners_.size()); }
  /// The first corner in the same place; corners_.size() if there is none.
  [[nodiscard]] std::size_t number(std::uint32_t vertex) const {
    const glm::dvec3& point = soup_.vertices[vertex];
    const auto is_there = [&](std::uint32_t corner) { return soup_.vertices[corner] == point; };
    return static_cast<std::size_t>(std::ranges::find_if(corners_, is_there) - corners_.begin());
  }

  SoupView soup_;
  std::span<const std::uint32_t> corners_;
  std::array<std::int64_t, std::size_t{ConvexRegions::kMostJoined} * ConvexRegions::kMostJoined> more_;  ///< in rows
};

/// Whether the polygons, joined, have this loop: both properties of the parts of a region.
bool is_joined(SoupView soup, std::span<const std::uint32_t> loop, std::span<const std::uint32_t> polygons) {
  if (loop.size() > ConvexRegions::kMostJoined) return false;
  Traversals traversals(soup, loop);
  if (!traversals.add(loop, -1)) return false;
  return std::ranges::all_of(polygons, [&](std::uint32_t p) { return traversals.add(soup.loop(p), 1); }) &&
         traversals.are_none();
}

bool is_piece(SoupView soup, std::span<const std::uint32_t> loop, std::size_t polygon, const FanRun& run) {
  const auto whole = soup.loop(polygon);
  if (run.count == 0 || std::uint64_t{run.first} + run.count > soup.triangles(polygon)) return false;
  return loop.size() == run.count + std::size_t{2} && loop[0] == whole[0] &&
         std::ranges::equal(loop.subspan(1), whole.subspan(run.first + std::size_t{1}, run.count + std::size_t{1}));
}

}  // namespace

void ConvexRegions::append_parts(PartWriter& parts) const {
  parts.put(kRegionVertices, vertices_);
  parts.put(kRegionFirstVertex, first_vertex_);
  parts.put(kRegionPolygons, polygons_);
  parts.put(kRegionFirstPolygon, first_polygon_);
  parts.put(kRegionWhole, whole_);
  parts.put(kRegionRuns, runs_);
}

bool ConvexRegions::is_sound(std::size_t r, SoupView soup) const {
  const auto corners = loop(r), polygons = parts(r);
  if (r < soup.size()) {
    return polygons.size() == 1 && polygons[0] == r && std::ranges::equal(corners, corners_of_region(soup, r));
  }
  const auto is_vertex = [&](std::uint32_t v) { return v < soup.vertices.size(); };
  if (corners.size() < 3 || !std::ranges::all_of(corners, is_vertex)) return false;
  if (polygons.empty() || !are_ascending_below(polygons, soup.size())) return false;
  if (!std::ranges::all_of(polygons, [&](std::uint32_t p) { return soup.is_opaque(p); })) return false;
  if (r >= first_piece_) return polygons.size() == 1 && is_piece(soup, corners, polygons[0], runs_[r - first_piece_]);
  const auto is_of = [&](std::uint32_t p) { return whole_[p] == r; };
  return std::ranges::all_of(polygons, is_of) && is_joined(soup, corners, polygons);
}

bool ConvexRegions::is_whole_sound(std::uint32_t polygon, std::size_t polygons) const {
  const std::uint32_t region = whole_[polygon];
  if (region == polygon) return true;
  return region >= polygons && region < first_piece_ && std::ranges::binary_search(parts(region), polygon);
}

ConvexRegions ConvexRegions::from_parts(const PartReader& parts, SoupView soup, const Checkpoint& checkpoint) {
  ConvexRegions result;
  result.vertices_ = parts.get<std::uint32_t>(kRegionVertices);
  result.first_vertex_ = parts.get<std::uint32_t>(kRegionFirstVertex);
  result.polygons_ = parts.get<std::uint32_t>(kRegionPolygons);
  result.first_polygon_ = parts.get<std::uint32_t>(kRegionFirstPolygon);
  result.whole_ = parts.get<std::uint32_t>(kRegionWhole);
  result.runs_ = parts.get<FanRun>(kRegionRuns);
  if (!are_starts(result.first_vertex_, result.vertices_.size(), checkpoint) ||
      !are_starts(result.first_polygon_, result.polygons_.size(), checkpoint) ||
      result.first_vertex_.size() != result.first_polygon_.size() || result.size() < soup.size() + result.runs_.size() ||
      result.whole_.size() != soup.size()) {
    refuse_part(kRegionFirstVertex, "the regions are not of these polygons");
  }
  result.first_piece_ = result.size() - result.runs_.size();
  const auto is_region = [&](std::size_t r) { return result.is_sound(r, soup); };
  if (!are_all(result.size(), is_region, checkpoint)) refuse_part(kRegionVertices, "a region is not made of its polygons");
  const auto is_whole = [&](std::size_t p) { return result.is_whole_sound(static_cast<std::uint32_t>(p), soup.size()); };
  if (!are_all(soup.size(), is_whole, checkpoint)) refuse_part(kRegionWhole, "a polygon is not in its region");
  return result;
}

}  // namespace occlude::culler
