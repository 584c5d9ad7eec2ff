// SPDX-License-Identifier: MIT
#include "cull_judge.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "border.h"
#include "cases/to_oracle.h"
#include "frame/culler_access.h"
#include "model/bounds.h"
#include "occlude/fuzz/case.h"
#include "occlude/oracle/cover.h"
#include "occlude/oracle/region.h"

namespace occlude::fuzz {
namespace {

using culler::Culled;
using culler::CullOptions;
using culler::CullResult;
using culler::Hierarchy;
using culler::to_kernel;
using glm::dvec3;
using proof::AnyCamera;

/// The bounding box of the soup, computed without the boxes of the tree.
oracle::Aabb box_of(culler::SoupView soup) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  oracle::Aabb box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (std::size_t p = 0; p < soup.size(); ++p) {
    for (const std::uint32_t index : soup.loop(p)) {
      const oracle::Point v = to_oracle(to_kernel(soup.vertices[index]));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::min(box.min[axis], v[axis]);
        box.max[axis] = std::max(box.max[axis], v[axis]);
      }
    }
  }
  return box;
}

class CullJudge {
 public:
  CullJudge(const culler::Culler& culler, const AnyCamera& camera, const CullOptions& options, const CullResult& result)
      : culler_(culler),
        hierarchy_(culler.hierarchy()),
        occluders_(occluders_of(culler)),
        camera_(camera),
        options_(options),
        result_(result),
        shadows_(result.occluders.size()),
        is_drawn_(hierarchy_.soup().size()),
        model_(box_of(hierarchy_.soup())) {}

  /// Must come first. It marks what is drawn, and the other checks assume that the ranges are sound.
  std::string fault_of_ranges() {
    std::vector<char> is_known(is_drawn_.size());
    const auto mark = [&](std::size_t first, std::size_t count, bool drawn) {
      if (count == 0 || first > is_known.size() || count > is_known.size() - first) return false;
      for (std::size_t p = first; p < first + count; ++p) {
        if (is_known[p] != 0) return false;
        is_known[p] = 1;
        is_drawn_[p] = drawn;
      }
      return true;
    };
    std::size_t end = 0;
    for (const auto [first, count] : result_.drawn) {
      if (!mark(first, count, true)) return "a polygon is drawn twice, or there is none";
      if (end != 0 && first <= end) return "what is drawn is not in order, or not merged";
      end = first + count;
    }
    for (const Culled& culled : result_.culled) {
      if (culled.node >= hierarchy_.nodes().size()) return "a node is culled that does not exist";
      const Hierarchy::Node& node = hierarchy_.nodes()[culled.node];
      if (!mark(node.first, node.count, false)) return "a polygon is drawn and culled, or culled twice";
    }
    return std::ranges::count(is_known, 0) == 0 ? "" : "a polygon is neither drawn nor culled";
  }

  std::string fault_of_counts() const {
    std::size_t by_view = 0, by_shadow = 0;
    for (const Culled& culled : result_.culled) {
      (culled.by == Culled::By::view ? by_view : by_shadow) += hierarchy_.nodes()[culled.node].count;
    }
    const culler::CullStats& stats = result_.stats;
    const bool right = stats.view_culled_polygons == by_view && stats.shadow_culled_polygons == by_shadow &&
                       stats.drawn_polygons == hierarchy_.soup().size() - by_view - by_shadow &&
                       result_.occluders.size() <= options_.occluders;
    return right ? "" : "the counts are wrong";
  }

  /// Compares with the same frame without occluders.
  std::string fault_against(const CullResult& without) const {
    std::size_t drawn = 0;
    for (const auto [first, count] : without.drawn) {
      for (std::size_t p = first; p < first + count; ++p) drawn += is_drawn_[p] != 0 ? 1 : 0;
    }
    return drawn == result_.stats.drawn_polygons ? "" : "a polygon is drawn with occluders and not without";
  }

  std::string fault_of_proofs() {
    if (options_.method == culler::Method::cover) {
      if (std::string fault = fault_of_covers(); !fault.empty()) return fault;
    }
    for (const Culled& culled : result_.culled) {
      if (culled.by == Culled::By::cover) continue;
      const std::size_t reasons = culled.by == Culled::By::view ? result_.view.size() : result_.occluders.size();
      if (culled.index >= reasons) return "a subtree is culled by what does not exist";
      if (culled.second != Culled::kNone && culled.second >= reasons) return "a subtree is culled by what does not exist";
      if (!holds_its_polygons(culled.node)) return "a polygon reaches out of the box of its node";
      const std::string fault = culled.by == Culled::By::view ? fault_of_view_cull(culled) : fault_of_shadow_cull(culled);
      if (!fault.empty()) return fault;
    }
    return "";
  }

 private:
  /// Checks that every polygon culled by cover is in a box for which the culler names polygons, and that those hide the box.
  std::string fault_of_covers() {
    constexpr std::size_t kMost = 64;  // so small that some subtrees are proved in parts
    std::vector<culler::CoverWitness> witnesses;
    std::visit([&](const auto& camera) { culler_.append_covers(result_, camera, options_, kMost, witnesses); }, camera_);
    std::vector<char> is_proved(is_drawn_.size());
    for (const culler::CoverWitness& witness : witnesses) {
      for (std::size_t p = witness.range.first; p < std::size_t{witness.range.first} + witness.range.count; ++p) {
        is_proved[p] = 1;
        for (const std::uint32_t index : hierarchy_.soup().loop(p)) {
          const oracle::Point vertex = to_oracle(to_kernel(hierarchy_.soup().vertices[index]));
          if (!oracle::contains(to_oracle(witness.box), vertex)) return "a polygon reaches out of the box of its cover";
        }
      }
      if (!witness.windows.empty()) {
        if (const std::string fault = fault_of_windows(witness); !fault.empty()) return "culled by cover: " + fault;
        continue;
      }
      const std::vector<oracle::Loop> cover = loops(witness.polygons);
      for (const oracle::Viewpoint& eye : eyes()) {
        const oracle::Answer answer =
            oracle::relation_to_cover(eye, cover, to_oracle(witness.box), proof::drawn(camera_, model_));
        if (answer.relation != oracle::Relation::inside || !answer.refusal.empty()) {
          return "culled by cover: the polygons do not hide the box";
        }
      }
    }
    for (const Culled& culled : result_.culled) {
      if (culled.by != Culled::By::cover) continue;
      const Hierarchy::Node& node = hierarchy_.nodes()[culled.node];
      const auto first = is_proved.begin() + node.first;
      if (std::find(first, first + node.count, 0) != first + node.count) return "culled by cover: nothing is named";
    }
    return "";
  }

  std::vector<oracle::Loop> loops(const std::vector<std::uint32_t>& polygons) const {
    std::vector<oracle::Loop> loops;
    for (const std::uint32_t p : polygons) loops.push_back(to_oracle(polygon(hierarchy_.soup().loop(p))));
    return loops;
  }

  const culler::EyeRegion& region() const {
    return std::visit([](const auto& camera) -> const culler::EyeRegion& { return camera.eyes; }, camera_);
  }

  oracle::Sheet sheet_of(const culler::CoverWindow& window, const oracle::HalfSpaceCoefficients& drawn) const {
    std::vector<oracle::Loop> sheet = loops(window.polygons);
    for (const auto& [p, corner] : window.triangles) {
      const oracle::Loop loop = to_oracle(polygon(hierarchy_.soup().loop(p)));
      sheet.push_back({loop[0], loop[corner], loop[corner + 1]});
    }
    return oracle::Sheet(sheet, drawn);
  }

  oracle::Layer layer_of(const culler::CoverLayer& layer, const oracle::HalfSpaceCoefficients& drawn) const {
    const auto point = [](const dvec3& v) { return oracle::Point{v.x, v.y, v.z}; };
    const auto& [at, normal, right] = layer.focus;
    oracle::Layer asked{{point(at), point(normal), point(right)}, {}};
    for (const culler::CoverWindow& w : layer.windows) {
      oracle::Window& window = asked.windows.emplace_back(oracle::Window{w.x0, w.y0, w.x1, w.y1, oracle::Layer{}});
      if (w.windows.empty()) {
        window.to = sheet_of(w, drawn);
      } else {
        window.to = layer_of(w, drawn);
      }
    }
    return asked;
  }

  /// Checks that the box is hidden from all eyes of the region, by windows.
  std::string fault_of_windows(const culler::CoverWitness& witness) const {
    const oracle::Layer layer = layer_of(witness, proof::drawn_of_sheets(camera_, model_));
    return oracle::judge({*proof::eyes_of(camera_), to_oracle(witness.box), layer}).reason;
  }

  /// The eye, or the direction. Of several eyes, the one in the middle, and corners of a box or those of a ball that are
  /// farthest along the axes.
  std::vector<oracle::Viewpoint> eyes() const {
    std::vector<oracle::Viewpoint> eyes{proof::viewpoint_of(camera_)};
    if (region().is_point() || eyes[0].at_infinity) return eyes;
    const auto add = [&](const dvec3& off) {
      eyes.push_back(eyes[0]);
      for (int axis = 0; axis < 3; ++axis) eyes.back().value[static_cast<std::size_t>(axis)] += 0.999 * off[axis];
    };
    const auto& [a, b, c] = region().half_edges;
    for (const double x : {-1.0, 1.0}) {
      if (region().radius > 0) {
        for (const dvec3& axis : {dvec3(x, 0, 0), dvec3(0, x, 0), dvec3(0, 0, x)}) add(region().radius * axis);
        continue;
      }
      for (const double y : {-1.0, 1.0}) {
        for (const double z : {-1.0, 1.0}) add(x * a + y * b + z * c);
      }
    }
    return eyes;
  }

  bool holds_its_polygons(std::uint32_t index_of_node) const {
    const Hierarchy::Node& node = hierarchy_.nodes()[index_of_node];
    const oracle::Box box = to_oracle(hierarchy_.volume(index_of_node));
    for (std::size_t p = node.first; p < std::size_t{node.first} + node.count; ++p) {
      for (const std::uint32_t index : hierarchy_.soup().loop(p)) {
        const oracle::Point vertex = to_oracle(to_kernel(hierarchy_.soup().vertices[index]));
        if (!oracle::contains(box, vertex)) return false;
      }
    }
    return true;
  }

  std::string fault_of_view_cull(const Culled& culled) const {
    const auto& [normal, offset] = result_.view[culled.index];
    const std::array<double, 4> plane{normal.x, normal.y, normal.z, offset};
    if (proof::may_draw_beyond(plane, camera_, model_)) return "a plane of the view cuts off what the camera shows";
    const std::string refuted = oracle::refute_view_cull(plane, to_oracle(hierarchy_.volume(culled.node)));
    return refuted.empty() ? "" : "culled by view: " + refuted;
  }

  std::string fault_of_shadow_cull(const Culled& culled) {
    for (const std::uint32_t index : {culled.index, culled.second}) {
      if (index == Culled::kNone) continue;
      if (std::string fault = fault_of_occluder(index, hierarchy_.nodes()[culled.node]); !fault.empty()) return fault;
    }
    const oracle::Box box = to_oracle(hierarchy_.volume(culled.node));
    oracle::Shadow& first = shadow(culled.index);
    const std::string refuted =
        culled.second == Culled::kNone ? first.refute_cull(box) : first.refute_union_cull(shadow(culled.second), box);
    return refuted.empty() ? "" : "culled by shadow: " + refuted;
  }

  std::string fault_of_occluder(std::uint32_t index, const Hierarchy::Node& node) const {
    const std::uint32_t occluder = result_.occluders[index].index;
    if (occluder >= occluders_.size()) return "there is no such occluder";
    for (const std::uint32_t part : occluders_.parts(occluder)) {
      if (part >= node.first && part - node.first < node.count) return "an occluder culls itself";
    }
    if (!is_drawn_as_its_parts(occluder)) return "an occluder is not what is drawn of it";
    return is_clipped(occluder) ? "the near plane clips an occluder" : "";
  }

  Polygon polygon(std::span<const std::uint32_t> loop) const {
    Polygon result;
    for (const std::uint32_t index : loop) result.push_back(to_kernel(hierarchy_.soup().vertices[index]));
    return result;
  }

  /// Whether the occluder hides what its parts hide. The faces of a shell are its parts, and the oracle checks that they
  /// enclose a solid. The parts of a piece are the triangles of its run, as the renderer makes them.
  bool is_drawn_as_its_parts(std::uint32_t occluder) const {
    if (occluders_.is_shell(occluder)) return true;
    const auto piece = occluders_.regions().piece(occluder);
    std::vector<Polygon> parts;
    for (const std::uint32_t part : occluders_.parts(occluder)) {
      const Polygon loop = polygon(hierarchy_.soup().loop(part));
      if (!piece) {
        parts.push_back(loop);
        continue;
      }
      if (piece->count == 0 || std::size_t{piece->first} + piece->count > loop.size() - 2) return false;
      for (std::size_t t = piece->first; t < std::size_t{piece->first} + piece->count; ++t) {
        parts.push_back({loop[0], loop[t + 1], loop[t + 2]});
      }
    }
    return proof::have_border(parts, polygon(occluders_.loop(occluder)));
  }

  bool is_clipped(std::uint32_t occluder) const {
    const auto piece = occluders_.is_shell(occluder) ? std::nullopt : occluders_.regions().piece(occluder);
    return std::ranges::any_of(occluders_.parts(occluder), [&](std::uint32_t part) {
      const auto loop = piece ? occluders_.loop(occluder) : hierarchy_.soup().loop(part);
      return proof::may_clip(camera_, model_, to_oracle(polygon(loop)));
    });
  }

  oracle::Shadow& shadow(std::uint32_t index) {
    if (shadows_[index]) return *shadows_[index];
    const culler::Occluder& occluder = result_.occluders[index];
    return shadows_[index].emplace(proof::viewpoint_of(camera_), to_oracle(occluders_.geometry(occluder.index)),
                                   to_oracle(options_.shadow_near, {occluder.frustum}));
  }

  const culler::Culler& culler_;
  const Hierarchy& hierarchy_;
  const culler::PotentialOccluders& occluders_;
  const AnyCamera& camera_;
  const CullOptions& options_;
  const CullResult& result_;
  std::vector<std::optional<oracle::Shadow>> shadows_;  ///< of the occluders, each made when it is first needed
  std::vector<char> is_drawn_;                          ///< for each polygon
  oracle::Aabb model_;
};

}  // namespace

std::string fault_of(const culler::Culler& culler, const AnyCamera& camera, const CullOptions& options,
                     const CullResult& result) {
  CullJudge judge(culler, camera, options, result);
  if (std::string fault = judge.fault_of_ranges(); !fault.empty()) return fault;
  if (std::string fault = judge.fault_of_counts(); !fault.empty()) return fault;
  CullOptions nothing_hides = options;
  nothing_hides.occluders = 0;
  nothing_hides.cover.work = 0;
  nothing_hides.cover.as_before = {};
  const CullResult without = std::visit([&](const auto& c) { return culler.cull(c, nothing_hides); }, camera);
  if (std::string fault = judge.fault_against(without); !fault.empty()) return fault;
  // `plain` does not promise more than this.
  return options.arithmetic == kernel::Arithmetic::certified ? judge.fault_of_proofs() : "";
}

}  // namespace occlude::fuzz
