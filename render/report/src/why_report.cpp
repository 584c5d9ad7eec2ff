// SPDX-License-Identifier: MIT
#include "occlude/render/why_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "frame/culler_access.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/missed_report.h"
#include "occlude/render/plates.h"
#include "occlude/render/view_planes.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const kernel::Vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }

Json json_of(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

Json json_of(const kernel::Aabb& box) { return {{"min", json_of(box.min)}, {"max", json_of(box.max)}}; }

double distance(const glm::dvec3& eye, const kernel::Aabb& box) {
  const glm::dvec3 low{box.min.x, box.min.y, box.min.z}, high{box.max.x, box.max.y, box.max.z};
  return glm::distance(eye, glm::clamp(eye, low, high));
}

/// The numbers of polygons in the model file, ascending.
std::vector<std::uint32_t> numbers_of(const culler::Culler& culler, std::span<const std::uint32_t> polygons) {
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t p : polygons) numbers.push_back(culler.hierarchy().face(p));
  std::ranges::sort(numbers);
  const auto repeated = std::ranges::unique(numbers);  // pieces of one polygon
  numbers.erase(repeated.begin(), repeated.end());
  return numbers;
}

/// The polygons of the model that form the occluder.
std::vector<std::uint32_t> polygons_of(const culler::Culler& culler, std::uint32_t occluder) {
  return numbers_of(culler, occluders_of(culler).parts(occluder));
}

/// An occluder in words.
std::string text_of_occluder(const culler::Culler& culler, std::uint32_t occluder) {
  constexpr std::size_t kListed = 6;
  const std::vector<std::uint32_t> polygons = polygons_of(culler, occluder);
  std::string text = polygons.size() == 1 ? "polygon" : "polygons";
  for (std::size_t i = 0; i < std::min(polygons.size(), kListed); ++i) text += fmt::format(" {}", polygons[i]);
  if (polygons.size() > kListed) text += fmt::format(" and {} more", polygons.size() - kListed);
  if (occluders_of(culler).is_shell(occluder)) return text + ", a closed convex shell";
  if (polygons.size() > 1) return text + ", flat together";
  return occluders_of(culler).regions().piece(occluder) ? "a convex piece of " + text : text;
}

Json json_of_occluder(const culler::Culler& culler, std::uint32_t occluder) {
  return {{"polygons", polygons_of(culler, occluder)}, {"shell", occluders_of(culler).is_shell(occluder)}};
}

/// The silhouette edge of plane `plane` of the shadow; none for the near side.
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

/// Where a box is, with the plane of the shadow that decides it.
std::string text_of_clearance(const kernel::ShadowFrustum& shadow, const kernel::Clearance& clearance) {
  const std::string plane = text_of_plane(shadow, clearance.plane);
  return clearance.distance < 0
             ? fmt::format("the box sticks out of its shadow by {:.6g}, at {}", -clearance.distance, plane)
             : fmt::format("the box is inside its shadow by {:.6g}, nearest to {}", clearance.distance, plane);
}

/// The number of nearest shadows listed for a drawn polygon.
constexpr std::size_t kNearest = 3;

enum class Became { drawn, out_of_view, in_shadow };

Became became(const Account& a) {
  if (!a.cull) return Became::drawn;
  return a.cull->by == culler::Culled::By::view ? Became::out_of_view : Became::in_shadow;
}

class Text {
 public:
  Text(const ReplayedFrame& frame, const Account& account)
      : frame_(frame), account_(account), culler_(frame.culler()), became_(became(account)) {
    add_polygon();
    add_node();
    if (became_ == Became::out_of_view) {
      add("  by the {} plane of the view: the box is beyond it by {:.6g}",
          name_of_plane(account.cull->index, frame.camera()), account.beyond_view);
    } else if (account_.cull && account_.cull->by == culler::Culled::By::cover) {
      add_cover();
    } else if (became_ == Became::in_shadow) {
      for (const AgainstShadow& s : account.shadows) add_culling(s);
    } else {
      if (account.missed) add_missed(*account.missed);
      add_nearest();
    }
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  template <class... Parts>
  void add(fmt::format_string<Parts...> line, Parts&&... parts) {
    fmt::format_to(std::back_inserter(text_), line, std::forward<Parts>(parts)...);
    text_ += '\n';
  }

  void add_polygon() {
    constexpr std::array<const char*, 3> kFates{"drawn", "culled: out of view", "culled: in shadow"};
    const culler::SoupView soup = culler_.hierarchy().soup();
    const kernel::Aabb box = soup.box(account_.polygon);
    add("frame {}, polygon {}: {}", frame_.number(), culler_.hierarchy().face(account_.polygon),
        kFates[static_cast<std::size_t>(became_)]);
    const auto pieces = std::ranges::count(culler_.hierarchy().faces(), culler_.hierarchy().face(account_.polygon));
    if (pieces > 1) add("  drawn in {} pieces; of that which shows most:", pieces);
    if (!soup.is_opaque(account_.polygon)) add("  see-through: it hides nothing");
    add("  {} sides, in the box {} - {}, {:.6g} from the eye", soup.loop(account_.polygon).size(), text_of(box.min),
        text_of(box.max), distance(frame_.camera().eye, box));
    const std::string size = fmt::format("{}x{}", frame_.options().width, frame_.options().height);
    if (account_.pixels == 0) add("  without culling it is visible in no pixel of {}", size);
    if (account_.pixels != 0) add("  without culling it is visible in {} pixels of {}", account_.pixels, size);
  }

  void add_node() {
    const culler::HierarchyNode& node = culler_.hierarchy().nodes()[account_.node];
    add("  {} {}: {} polygons in the box {} - {}", became_ == Became::drawn ? "drawn with leaf" : "culled with node",
        account_.node, node.count, text_of(node.box.min), text_of(node.box.max));
  }

  void add_culling(const AgainstShadow& s) {
    const culler::Occluder& occluder = frame_.result().occluders[s.occluder];
    add("  by occluder {}: {}; it hides {} polygons in this frame", s.occluder, text_of_occluder(culler_, occluder.index),
        occluder.hidden);
    const bool is_alone = account_.shadows.size() == 1;
    add("  {}{}", text_of_clearance(occluder.frustum, s.clearance),
        is_alone ? "" : "; the two shadows together contain the box");
  }

  void add_cover() {
    constexpr std::size_t kNamed = 8;
    const std::vector<std::uint32_t> cover = numbers_of(culler_, account_.cover);
    std::string named;
    for (std::size_t i = 0; i < std::min(cover.size(), kNamed); ++i) {
      named += fmt::format("{}{}", i == 0 ? "" : ", ", cover[i]);
    }
    add("  by {} polygons together: {}{}", cover.size(), named, cover.size() <= kNamed ? "" : ", ...");
  }

  void add_missed(const culler::MissedReasons::Answer& missed) {
    add("  it was not culled: {}", render::text_of(missed.reason));
    if (missed.occluder != culler::Culled::kNone) {
      add("  an occluder that hides it alone: {}", text_of_occluder(culler_, missed.occluder));
    }
  }

  void add_nearest() {
    if (frame_.result().method == culler::Method::cover) return;
    if (account_.shadows.empty()) return add("  the frame has no occluders");
    add("  its own box against the nearest shadows:");
    for (std::size_t i = 0; i < std::min(account_.shadows.size(), kNearest); ++i) {
      const AgainstShadow& s = account_.shadows[i];
      const culler::Occluder& occluder = frame_.result().occluders[s.occluder];
      add("    occluder {} ({}): {}", s.occluder, text_of_occluder(culler_, occluder.index),
          text_of_clearance(occluder.frustum, s.clearance));
    }
  }

  const ReplayedFrame& frame_;
  const Account& account_;
  const culler::Culler& culler_;
  Became became_;
  std::string text_;
};

Json json_of_shadow(const culler::Culler& culler, const culler::Occluder& occluder, const kernel::Clearance& clearance) {
  const auto edge = edge_of(occluder.frustum, clearance.plane);
  return {{"occluder", json_of_occluder(culler, occluder.index)},
          {"hidden_polygons", occluder.hidden},
          {"distance", clearance.distance},
          {"plane", edge ? "side" : "near"},
          {"edge", edge ? Json{json_of((*edge)[0]), json_of((*edge)[1])} : Json()}};
}

Json json_of_plane(const ReplayedFrame& frame, const Account& a) {
  const culler::HalfSpace& h = frame.result().view[a.cull->index];
  return {{"name", name_of_plane(a.cull->index, frame.camera())},
          {"coefficients", {h.normal.x, h.normal.y, h.normal.z, h.offset}},
          {"distance", a.beyond_view}};
}

Json json_of_missed(const culler::Culler& culler, const culler::MissedReasons::Answer& missed) {
  const bool is_one = missed.occluder != culler::Culled::kNone;
  return {{"reason", to_string(missed.reason)}, {"occluder", is_one ? json_of_occluder(culler, missed.occluder) : Json()}};
}

}  // namespace

std::string to_text(const ReplayedFrame& frame, const Account& account) { return Text(frame, account).text(); }

std::string to_json(const ReplayedFrame& frame, const Account& a) {
  constexpr std::array<const char*, 3> kFates{"drawn", "out_of_view", "in_shadow"};
  const culler::Culler& culler = frame.culler();
  const culler::HierarchyNode& node = culler.hierarchy().nodes()[a.node];
  Json json = {{"frame", frame.number()},
               {"polygon", culler.hierarchy().face(a.polygon)},
               {"box", json_of(culler.hierarchy().soup().box(a.polygon))},
               {"fate", kFates[static_cast<std::size_t>(became(a))]},
               {"pixels", a.pixels},
               {"node", {{"index", a.node}, {"polygons", node.count}, {"box", json_of(node.box)}}}};
  json["plane"] = became(a) == Became::out_of_view ? json_of_plane(frame, a) : Json();
  json["shadows"] = Json::array();
  for (const AgainstShadow& s : a.shadows) {
    json["shadows"].push_back(json_of_shadow(culler, frame.result().occluders[s.occluder], s.clearance));
  }
  json["cover"] = numbers_of(culler, a.cover);
  json["missed"] = a.missed ? json_of_missed(culler, *a.missed) : Json();
  return json.dump(2) + "\n";
}

WhyFiles::WhyFiles(const std::filesystem::path& folder)
    : folder_(folder), json_(folder / "why.json"), view_(folder / "view.png"), outside_(folder / "outside.png") {}

void WhyFiles::write(const ReplayedFrame& frame, const Account& account) {
  const WhyPlates plates = draw_why(frame, account);
  write_png(view_, plates.view);
  write_png(outside_, plates.outside);
  json_.write(to_json(frame, account));
  for (OutputFile* file : {&view_, &outside_, &json_}) file->close();
  const Uninterrupted together;
  for (OutputFile* file : {&view_, &outside_, &json_}) file->commit();
}

}  // namespace occlude::render
