// SPDX-License-Identifier: MIT
#include "occlude/render/witness.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <variant>

#include "camera/frame_view.h"
#include "frame/culler_access.h"
#include "model/bounds.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/view_planes.h"
#include "witness_text.h"

namespace occlude::render {
namespace {

const char* near_word(kernel::Near near) { return near == kernel::Near::farthest ? R"("farthest")" : R"("surface")"; }

std::string near_member(const kernel::ShadowFrustum& frustum, kernel::Near near) {
  const auto& plane = frustum.support_plane();
  if (!plane) return near_word(near);
  return fmt::format(R"({{"normal":{},"point":{}}})", text::triple(plane->normal), text::triple(plane->point));
}

/// For an occluder that is not one polygon of the model: the triangles of its parts.
std::string parts_member(const culler::Culler& culler, std::uint32_t occluder) {
  const auto parts = occluders_of(culler).parts(occluder);
  const auto piece = occluders_of(culler).regions().piece(occluder);
  if (parts.size() == 1 && !piece) return "";
  return R"(,"parts":)" + text::list(parts, [&](std::uint32_t part) {
           const std::size_t first = culler.hierarchy().first_triangle(part);
           return piece ? fmt::format("[{},{}]", first + piece->first, piece->count)
                        : fmt::format("[{},{}]", first, culler.hierarchy().first_triangle(part + 1) - first);
         });
}

/// The members of an occluder, without braces.
std::string geometry_members(const culler::Culler& culler, std::uint32_t occluder) {
  const auto geometry = occluders_of(culler).geometry(occluder);
  if (const auto* polygon = std::get_if<std::vector<kernel::Vec3>>(&geometry)) {
    return fmt::format(R"("polygon":{}{})", text::list(*polygon, text::triple<kernel::Vec3>),
                       parts_member(culler, occluder));
  }
  const auto& [vertices, faces] = std::get<kernel::Polytope>(geometry);
  const auto face = [](const std::vector<std::uint32_t>& loop) {
    return text::list(loop, [](std::uint32_t i) { return std::to_string(i); });
  };
  return fmt::format(R"("vertices":{},"faces":{})", text::list(vertices, text::triple<kernel::Vec3>),
                     text::list(faces, face));
}

std::string view_member(const culler::HalfSpace& h) {
  return fmt::format(R"("by":"view","plane":[{},{},{},{}])", h.normal.x, h.normal.y, h.normal.z, h.offset);
}

/// What culled a subtree, in JSON. Occluders and half-spaces recur, so their text is made once per frame.
class Reasons {
 public:
  Reasons(const culler::Culler& culler, const culler::CullResult& result, kernel::Near near)
      : common_near_(near_word(near)) {
    for (const culler::Occluder& occluder : result.occluders) {
      geometry_.push_back(geometry_members(culler, occluder.index));
      near_.push_back(near_member(occluder.frustum, near));
    }
    for (const culler::HalfSpace& h : result.view) view_.push_back(view_member(h));
  }

  std::string of(const culler::Culled& culled) const {
    if (culled.by == culler::Culled::By::view) return view_[culled.index];
    if (culled.second == culler::Culled::kNone) return by_one(culled.index);
    return by_two(culled.index, culled.second);
  }

 private:
  std::string by_one(std::uint32_t i) const {
    return fmt::format(R"("by":"shadow","occluders":[{{{}}}],"near":{})", geometry_[i], near_[i]);
  }

  /// If a near plane is given in numbers, each occluder has its own.
  std::string by_two(std::uint32_t i, std::uint32_t j) const {
    const bool is_common = near_[i] == common_near_ && near_[j] == common_near_;
    const auto own_near = [&](std::uint32_t k) { return is_common ? "" : R"(,"near":)" + near_[k]; };
    return fmt::format(R"("by":"shadow","occluders":[{{{}{}}},{{{}{}}}],"near":{})", geometry_[i], own_near(i), geometry_[j],
                       own_near(j), common_near_);
  }

  std::string common_near_;
  std::vector<std::string> geometry_, near_;  ///< of the occluders
  std::vector<std::string> view_;             ///< of each half-space, complete
};

/// Where the culler cuts what hides from the eyes of a region, which looks in another direction than a frame's camera.
std::string drawn_member(const culler::Camera& region, const culler::Hierarchy& hierarchy) {
  const culler::FrameView view(region, culler::depth(hierarchy.nodes()[0].box, region.eye));
  const glm::dvec3& forward = view.axes.forward;
  return fmt::format(R"("drawn":[{},{},{},{}],)", forward.x, forward.y, forward.z, -glm::dot(forward, view.eye) - view.near);
}

/// Writes the lines of a frame.
class Lines {
 public:
  Lines(std::vector<std::string>& lines, std::size_t frame, const AnyCamera& camera, const culler::Hierarchy& hierarchy)
      : lines_(lines),
        hierarchy_(hierarchy),
        frame_(std::visit(
            [&](const auto& c) {
              return fmt::format(R"({{"frame":{},{},)", frame, text::sight_member(c.viewpoint(), c.eyes));
            },
            camera)),
        leaf_(hierarchy.leaf_size() == culler::leaf_size_for(culler::Method::frusta)
                  ? ""
                  : fmt::format(R"("leaf":{},)", hierarchy.leaf_size())) {}

  void append(const culler::PolygonRange& range, const culler::Box& box, const std::string& reason) {
    const std::size_t first = hierarchy_.first_triangle(range.first);
    const std::size_t count = hierarchy_.first_triangle(range.first + range.count) - first;
    lines_.push_back(fmt::format(R"({}"box":{},{}"triangles":[{},{}],{}}})", frame_,
                                 std::visit([](const auto& b) { return text::box(b); }, box), leaf_, first, count, reason));
  }

  /// `drawn` is a member that says where sheets count, if it is not where the frame's camera draws.
  void append_cover(const culler::CoverWitness& cover, const std::string& drawn = "") {
    append(cover.range, cover.box, R"("by":"cover",)" + drawn + text::cover_members(hierarchy_, cover));
  }

 private:
  std::vector<std::string>& lines_;
  const culler::Hierarchy& hierarchy_;
  std::string frame_, leaf_;
};

}  // namespace

void append_witnesses(std::vector<std::string>& lines, std::size_t frame, const AnyCamera& camera,
                      const culler::Culler& culler, const culler::CullResult& result, const culler::CullOptions& options,
                      std::span<const culler::CoverWitness> covers, const culler::Camera* region) {
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  const Reasons reasons(culler, result, options.shadow_near);
  Lines of_frame(lines, frame, camera, hierarchy), of_region(lines, frame, region ? *region : camera, hierarchy);
  const std::size_t own_planes = region ? view_planes_of(std::get<culler::Camera>(camera)) : result.view.size();
  // The margins of shadows are from the eye in the middle.
  const bool has_margins = !region && std::visit([](const auto& c) { return c.eyes.is_point(); }, camera);
  std::vector<culler::Witness> witnesses;
  culler.append_witnesses(result, witnesses);
  for (const auto& [culled, margin] : witnesses) {
    if (culled.by == culler::Culled::By::cover) continue;
    const culler::HierarchyNode& node = hierarchy.nodes()[culled.node];
    const std::string beyond = has_margins ? fmt::format(R"(,"margin":{})", margin) : "";
    Lines& its = culled.by == culler::Culled::By::view && culled.index < own_planes ? of_frame : of_region;
    its.append({node.first, node.count}, hierarchy.volume(culled.node), reasons.of(culled) + beyond);
  }
  const std::string drawn = region ? drawn_member(*region, hierarchy) : "";
  for (const culler::CoverWitness& cover : covers) of_region.append_cover(cover, drawn);
}

void append_witnesses(std::vector<std::string>& lines, std::size_t frame, const AnyCamera& camera,
                      const culler::Hierarchy& hierarchy, std::span<const culler::HalfSpace> view,
                      std::span<const culler::ObjectWitness> witnesses, std::span<const culler::PolygonRange> objects) {
  Lines of_frame(lines, frame, camera, hierarchy);
  for (const auto& [object, box, fate] : witnesses) {
    const culler::PolygonRange& range = objects[object.slot()];
    if (fate.reason == culler::ObjectFate::Reason::out_of_view) {
      of_frame.append(range, box, view_member(view[fate.plane]));
      continue;
    }
    culler::CoverWitness cover;
    cover.range = range;
    cover.box = std::get<kernel::Aabb>(box);
    for (const culler::ObjectFate::Hiding& hiding : fate.by) cover.polygons.push_back(hiding.polygon);
    of_frame.append_cover(cover);
  }
}

}  // namespace occlude::render
