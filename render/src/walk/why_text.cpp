// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <variant>

#include "occlude/render/why.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

/// As append_view_frustum orders them.
constexpr std::array<const char*, 6> kViewPlanes{"left", "right", "bottom", "top", "near", "far"};

std::string text_of(const kernel::Vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }

Json json_of(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

/// The polygons of the model that the occluder is drawn as.
std::vector<std::uint32_t> polygons_of(const culler::Culler& culler, std::uint32_t occluder) {
  std::vector<std::uint32_t> polygons;
  for (const std::uint32_t part : culler.occluders().parts(occluder)) {
    polygons.push_back(culler.hierarchy().original(part));
  }
  std::sort(polygons.begin(), polygons.end());
  return polygons;
}

/// An occluder among PotentialOccluders, in words.
std::string text_of_occluder(const culler::Culler& culler, std::uint32_t occluder) {
  constexpr std::size_t kListed = 6;
  const std::vector<std::uint32_t> polygons = polygons_of(culler, occluder);
  std::string text = polygons.size() == 1 ? "polygon" : "polygons";
  for (std::size_t i = 0; i < std::min(polygons.size(), kListed); ++i) text += fmt::format(" {}", polygons[i]);
  if (polygons.size() > kListed) text += fmt::format(" and {} more", polygons.size() - kListed);
  if (culler.occluders().is_shell(occluder)) return text + ", a closed convex shell";
  if (polygons.size() > 1) return text + ", flat together";
  return culler.occluders().regions().piece(occluder) ? "a convex piece of " + text : text;
}

Json json_of_occluder(const culler::Culler& culler, std::uint32_t occluder) {
  return {{"polygons", polygons_of(culler, occluder)}, {"shell", culler.occluders().is_shell(occluder)}};
}

/// The edge of the silhouette that plane `plane` of the shadow is through; none of the near side.
std::optional<std::array<kernel::Vec3, 2>> edge_of(const kernel::ShadowFrustum& shadow, std::size_t plane) {
  if (plane < shadow.near_count()) return std::nullopt;
  const auto corners = shadow.silhouette();
  const std::size_t side = plane - shadow.near_count();
  return std::array{corners[side], corners[(side + 1) % corners.size()]};
}

std::string text_of_plane(const kernel::ShadowFrustum& shadow, std::size_t plane) {
  const auto edge = edge_of(shadow, plane);
  return edge ? fmt::format("the side through its edge {} - {}", text_of((*edge)[0]), text_of((*edge)[1]))
              : std::string("its near side");
}

const char* why_missed(culler::Missed reason) {
  switch (reason) {
    case culler::Missed::coarse_node:
      return "its own box is in that shadow, the box of its leaf is not: the leaf is too coarse";
    case culler::Missed::straddling_box:
      return "it is in that shadow, its box is not: the box straddles";
    case culler::Missed::several:
      return "each of its corners is in the shadow of an occluder, and no shadow has all of them: several hide it together";
    case culler::Missed::not_chosen:
      return "it is in the shadow of an occluder that was listed, and not chosen";
    case culler::Missed::no_single_one:
      return "no listed occluder hides it alone";
  }
  return "";
}

/// Of how many of the shadows that a drawn polygon is not in one learns.
constexpr std::size_t kNearest = 3;

}  // namespace

std::string to_text(const ReplayedFrame& frame, const Account& a) {
  const culler::Culler& culler = frame.culler();
  const culler::CullResult& result = frame.result();
  const culler::HierarchyNode& node = culler.hierarchy().nodes()[a.node];
  const char* fate = !a.cull                                  ? "drawn"
                     : a.cull->by == culler::Culled::By::view ? "culled: out of view"
                                                              : "culled: in shadow";
  std::string text = fmt::format("frame {}, polygon {}: {}\n", frame.number(), culler.hierarchy().original(a.polygon), fate);
  text += a.pixels == 0
              ? fmt::format("  it shows in no pixel of {}x{}, were nothing culled\n", frame.options().width,
                            frame.options().height)
              : fmt::format("  it shows in {} pixels of {}x{}\n", a.pixels, frame.options().width, frame.options().height);
  text += fmt::format("  {} {}: {} polygons in the box {} - {}\n", a.cull ? "culled with node" : "drawn with leaf", a.node,
                      node.count, text_of(node.box.min), text_of(node.box.max));
  if (a.cull && a.cull->by == culler::Culled::By::view) {
    return text + fmt::format("  by the {} plane of the view: the box is beyond it by {:.6g}\n", kViewPlanes[a.cull->index],
                              a.beyond_view);
  }
  if (a.cull) {
    for (const AgainstShadow& s : a.shadows) {
      const culler::Occluder& occluder = result.occluders[s.occluder];
      text += fmt::format("  by occluder {}: {}; it hides {} polygons in this frame\n", s.occluder,
                          text_of_occluder(culler, occluder.index), occluder.hidden);
      text += a.shadows.size() == 1
                  ? fmt::format("  the box is in its shadow by {:.6g}, where it is nearest to {}\n", s.clearance.distance,
                                text_of_plane(occluder.frustum, s.clearance.plane))
                  : fmt::format("  the box is in its shadow but for {:.6g} beyond {}, and all of it in both together\n",
                                -s.clearance.distance, text_of_plane(occluder.frustum, s.clearance.plane));
    }
    return text;
  }
  if (a.missed) {
    text += "  it is hidden, and was not culled: ";
    text += why_missed(a.missed->reason);
    text += "\n";
    if (a.missed->occluder != culler::Culled::kNone) {
      text += fmt::format("  what hides it alone: {}\n", text_of_occluder(culler, a.missed->occluder));
    }
  }
  if (a.shadows.empty()) return text + "  the frame has no occluders\n";
  text += "  its own box to the shadows that it is nearest to:\n";
  for (std::size_t i = 0; i < std::min(a.shadows.size(), kNearest); ++i) {
    const culler::Occluder& occluder = result.occluders[a.shadows[i].occluder];
    const auto& [distance, at_least, plane] = a.shadows[i].clearance;
    text += fmt::format("    occluder {} ({}): {} {:.6g} {} {}\n", a.shadows[i].occluder,
                        text_of_occluder(culler, occluder.index), distance < 0 ? "sticks out by" : "inside by",
                        std::abs(distance), distance < 0 ? "of" : "from", text_of_plane(occluder.frustum, plane));
  }
  return text;
}

std::string to_json(const ReplayedFrame& frame, const Account& a) {
  const culler::Culler& culler = frame.culler();
  const culler::CullResult& result = frame.result();
  const culler::HierarchyNode& node = culler.hierarchy().nodes()[a.node];
  Json json = {{"frame", frame.number()},
               {"polygon", culler.hierarchy().original(a.polygon)},
               {"fate", !a.cull                                  ? "drawn"
                        : a.cull->by == culler::Culled::By::view ? "out_of_view"
                                                                 : "in_shadow"},
               {"pixels", a.pixels},
               {"node",
                {{"index", a.node},
                 {"polygons", node.count},
                 {"box", {{"min", json_of(node.box.min)}, {"max", json_of(node.box.max)}}}}}};
  if (a.cull && a.cull->by == culler::Culled::By::view) {
    const culler::HalfSpace& h = result.view[a.cull->index];
    json["plane"] = {{"name", kViewPlanes[a.cull->index]},
                     {"coefficients", {h.normal.x, h.normal.y, h.normal.z, h.offset}},
                     {"distance", a.beyond_view}};
    return json.dump(2) + "\n";
  }
  json["shadows"] = Json::array();
  for (const AgainstShadow& s : a.shadows) {
    const culler::Occluder& occluder = result.occluders[s.occluder];
    const auto edge = edge_of(occluder.frustum, s.clearance.plane);
    json["shadows"].push_back({{"occluder", json_of_occluder(culler, occluder.index)},
                               {"hidden_polygons", occluder.hidden},
                               {"distance", s.clearance.distance},
                               {"plane", edge ? "side" : "near"},
                               {"edge", edge ? Json{json_of((*edge)[0]), json_of((*edge)[1])} : Json()}});
  }
  if (a.missed) {
    json["missed"] = {
        {"reason", to_string(a.missed->reason)},
        {"occluder", a.missed->occluder == culler::Culled::kNone ? Json() : json_of_occluder(culler, a.missed->occluder)}};
  }
  return json.dump(2) + "\n";
}

}  // namespace occlude::render
