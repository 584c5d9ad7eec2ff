// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "any_case.h"
#include "cases/to_oracle.h"
#include "experiment.h"
#include "occlude/culler/culler.h"
#include "occlude/fuzz/case.h"
#include "occlude/oracle/sight.h"
#include "proof.h"
#include "region_scenes.h"
#include "rows.h"
#include "sight_judge.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using culler::Camera;
using culler::CoverWindow;
using culler::CoverWitness;
using glm::dvec3;
using Json = nlohmann::json;

/// The number of lines about one scene.
constexpr std::size_t kLines = 4 * kGroup;

Json json(const dvec3& v) { return {v.x, v.y, v.z}; }
Json json(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

/// What a line says.
struct Claim {
  std::size_t frame;
  CoverWitness witness;
};

/// A frame for a region of eyes, what it culls, and other frames for which that need not be true.
class WindowForger {
 public:
  WindowForger(Random& random, RegionScene scene)
      : random_(random),
        culler_(std::move(scene.soup), {.hierarchy = {.leaf_size = 1}, .occluders = {}, .lists = {.regions = 1}}),
        cameras_(cameras_of(scene.camera)),
        prover_(culler_.hierarchy(), {cameras_.size(), [this](std::size_t frame) { return cameras_[frame]; }}) {
    const culler::CullResult result = culler_.cull(scene.camera, scene.options);
    culler_.append_covers(result, scene.camera, scene.options, kMostCorners, witnesses_);
    std::erase_if(witnesses_, [](const CoverWitness& witness) { return witness.windows.empty(); });
  }

  [[nodiscard]] bool has_witnesses() const { return !witnesses_.empty(); }

  struct Outcome {
    std::string line, failure;  ///< why the line is not taken
    bool is_honest, is_taken, is_refuted;
  };

  Outcome forge() {
    Claim claim{0, witnesses_[random_.index(witnesses_.size())]};
    const bool is_honest = random_.chance(0.1);
    if (!is_honest) bend(claim);
    if (!is_honest && random_.chance(0.2)) bend(claim);
    Outcome outcome{line_of(claim).dump(), "", is_honest, false, is_refuted(claim)};
    try {
      outcome.failure = prover_.prove(outcome.line).failure;
      outcome.is_taken = outcome.failure.empty();
    } catch (const cases::LineError& error) {  // it is not even a witness
      outcome.failure = error.what();
    }
    return outcome;
  }

 private:
  static constexpr std::size_t kMostCorners = 64;  // so few that some subtrees are proved in parts

  [[nodiscard]] double sign() { return random_.chance(0.5) ? 1 : -1; }
  /// A share of what something measures.
  [[nodiscard]] double share() { return std::ldexp(random_.real(0.5, 1), -random_.integer(0, 30)); }

  /// The frame's own camera, and those of a larger region, of one that is elsewhere, and of a farther near plane.
  std::array<Camera, 4> cameras_of(const Camera& camera) {
    std::array<Camera, 4> cameras{camera, camera, camera, camera};
    const double larger = 1 + share();
    cameras[1].eyes.radius *= larger;
    for (dvec3& half_edge : cameras[1].eyes.half_edges) half_edge *= larger;
    const double size = camera.eyes.reach({1, 0, 0}) + camera.eyes.reach({0, 1, 0}) + camera.eyes.reach({0, 0, 1});
    const dvec3 off = share() * size * dvec3(sign(), sign(), sign());
    cameras[2].eye += off;
    cameras[2].target += off;
    cameras[3].near_plane *= 1 + 4 * share();
    return cameras;
  }

  /// Of any plane, or of those with a sheet.
  CoverWindow& some_window(culler::CoverLayer& layer, bool has_sheet) {
    CoverWindow& window = layer.windows[random_.index(layer.windows.size())];
    if (window.windows.empty() || (!has_sheet && random_.chance(0.3))) return window;
    return some_window(window, has_sheet);
  }

  /// Any plane of the claim.
  culler::CoverLayer& some_layer(culler::CoverLayer& layer) {
    CoverWindow& window = layer.windows[random_.index(layer.windows.size())];
    return window.windows.empty() || random_.chance(0.3) ? layer : some_layer(window);
  }

  /// Makes the claim another one, which may be true by chance.
  void bend(Claim& claim) {
    if (claim.witness.windows.empty()) return;
    switch (random_.integer(0, 7)) {
      case 0:
        return take_away(some_layer(claim.witness).windows);
      case 1:
        return narrow(some_window(claim.witness, false));
      case 2:
        return thin_out(claim);
      case 3:
        return exchange_sheets(claim);
      case 4:
        return move_focus(some_layer(claim.witness).focus);
      case 5:
        claim.frame = 1 + random_.index(cameras_.size() - 1);
        return;
      case 6:
        return bring_nearer(claim);
      default:
        return claim_another(claim);
    }
  }

  template <class T>
  void take_away(std::vector<T>& list) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(random_.index(list.size())));
  }

  void narrow(CoverWindow& w) {
    const double x = share() * (w.x1 - w.x0), y = share() * (w.y1 - w.y0);
    switch (random_.integer(0, 3)) {
      case 0:
        w.x0 += x;
        return;
      case 1:
        w.x1 -= x;
        return;
      case 2:
        w.y0 += y;
        return;
      default:
        w.y1 -= y;
        return;
    }
  }

  /// Takes a polygon or a triangle from the sheet of a window, and from all that have the same one.
  void thin_out(Claim& claim) {
    const CoverWindow before = some_window(claim.witness, true);
    CoverWindow after = before;
    if (!after.polygons.empty() && (after.triangles.empty() || random_.chance(0.5))) {
      take_away(after.polygons);
    } else if (!after.triangles.empty()) {
      take_away(after.triangles);
    }
    exchange(claim.witness, before, after);
  }

  /// Gives all windows with one sheet another one.
  static void exchange(culler::CoverLayer& layer, const CoverWindow& before, const CoverWindow& after) {
    for (CoverWindow& w : layer.windows) {
      exchange(w, before, after);
      if (!w.windows.empty() || w.polygons != before.polygons || w.triangles != before.triangles) continue;
      w.polygons = after.polygons;
      w.triangles = after.triangles;
    }
  }

  void exchange_sheets(Claim& claim) {
    CoverWindow &a = some_window(claim.witness, true), &b = some_window(claim.witness, true);
    std::swap(a.polygons, b.polygons);
    std::swap(a.triangles, b.triangles);
  }

  void move_focus(culler::FocusPlane& focus) {
    const double distance = glm::dot(focus.point - cameras_[0].eye, focus.normal);
    switch (random_.integer(0, 2)) {
      case 0:
        focus.point += sign() * share() * distance * focus.normal;
        return;
      case 1:
        focus.point += sign() * share() * distance * focus.right;
        return;
      default:
        focus.normal += share() * dvec3(sign(), sign(), sign());
        return;
    }
  }

  /// Makes the box reach nearer to the eye, or farther aside.
  void bring_nearer(Claim& claim) {
    kernel::Aabb& box = claim.witness.box;
    const dvec3& eye = cameras_[0].eye;
    const double distance = std::fabs(box.min.x - eye.x) + std::fabs(box.min.y - eye.y) + std::fabs(box.min.z - eye.z);
    const int axis = random_.integer(0, 2);
    const double by = share() * distance;
    if (random_.chance(0.5)) {
      box.min[axis] -= by;
    } else {
      box.max[axis] += by;
    }
  }

  /// Says the same of any polygon.
  void claim_another(Claim& claim) {
    const auto p = static_cast<std::uint32_t>(random_.index(culler_.hierarchy().soup().size()));
    claim.witness.range = {p, 1};
    claim.witness.box = culler_.hierarchy().soup().box(p);
  }

  [[nodiscard]] Json names(const std::vector<std::uint32_t>& polygons) const {
    Json names = Json::array();
    for (const std::uint32_t p : polygons) names.push_back(culler_.hierarchy().face(p));
    return names;
  }

  [[nodiscard]] Json line_of(const Claim& claim) const {
    const culler::Hierarchy& hierarchy = culler_.hierarchy();
    const CoverWitness& witness = claim.witness;
    const Camera& camera = cameras_[claim.frame];
    Json eyes{{"center", json(camera.eye)}};
    if (camera.eyes.radius > 0) {
      eyes["radius"] = camera.eyes.radius;
    } else {
      for (const dvec3& half_edge : camera.eyes.half_edges) eyes["half_edges"].push_back(json(half_edge));
    }
    const std::size_t first = hierarchy.first_triangle(witness.range.first);
    const std::size_t end = hierarchy.first_triangle(witness.range.first + witness.range.count);
    Json line{{"frame", claim.frame},
              {"eyes", eyes},
              {"box", {{"min", json(witness.box.min)}, {"max", json(witness.box.max)}}},
              {"leaf", hierarchy.leaf_size()},
              {"triangles", {first, end - first}},
              {"by", "cover"}};
    line.update(layer(witness));
    return line;
  }

  [[nodiscard]] Json layer(const culler::CoverLayer& layer) const {
    const auto& [point, normal, right] = layer.focus;
    Json windows = Json::array();
    for (const CoverWindow& w : layer.windows) {
      Json window = w.windows.empty() ? Json{{"polygons", names(w.polygons)}} : this->layer(w);
      window["rect"] = {w.x0, w.y0, w.x1, w.y1};
      for (const culler::FanTriangle& t : w.triangles) {
        window["triangles"].push_back({culler_.hierarchy().face(t.polygon), t.corner});
      }
      windows.push_back(std::move(window));
    }
    return {{"focus", {{"point", json(point)}, {"normal", json(normal)}, {"right", json(right)}}}, {"windows", windows}};
  }

  [[nodiscard]] std::vector<oracle::Triangle> sheet_of(const CoverWindow& window) const {
    const culler::SoupView soup = culler_.hierarchy().soup();
    std::vector<oracle::Triangle> sheet;
    const auto add = [&](std::uint32_t p, std::size_t i) {
      const auto at = [&](std::size_t k) {
        const dvec3& v = soup.vertices[soup.loop(p)[k]];
        return oracle::Point{v.x, v.y, v.z};
      };
      sheet.push_back({at(0), at(i), at(i + 1)});
    };
    for (const std::uint32_t p : window.polygons) {
      for (std::size_t i = 1; i <= soup.triangles(p); ++i) add(p, i);
    }
    for (const culler::FanTriangle& t : window.triangles) add(t.polygon, t.corner);
    return sheet;
  }

  /// Where the line from an eye through a point crosses the focus plane, in its axes. None if it does not run towards the
  /// plane.
  static std::optional<std::array<double, 2>> crossing(const culler::FocusPlane& focus, const dvec3& eye,
                                                       const dvec3& point) {
    const dvec3 up = glm::cross(focus.right, focus.normal), forward = glm::cross(up, focus.right);
    const double along = glm::dot(forward, point - eye);
    if (!(along > 0)) return std::nullopt;
    const dvec3 p = eye + glm::dot(forward, focus.point - eye) / along * (point - eye) - focus.point;
    return std::array{glm::dot(p, focus.right) / glm::dot(focus.right, focus.right), glm::dot(p, up) / glm::dot(up, up)};
  }

  /// Whether a line of sight refutes the claim: one that crosses a focus plane beside all windows or, exactly, does not meet
  /// the sheet of a window through which it goes. What rounding cannot tell apart refutes nothing.
  bool is_refuted(const Claim& claim) {
    const Camera& camera = cameras_[claim.frame];
    const auto drawn = proof::drawn(camera, to_oracle(culler_.hierarchy().nodes()[0].box));
    std::map<const CoverWindow*, oracle::Sight> sights;
    const auto is_clear = [&](const CoverWindow& window, const oracle::Point& eye, const oracle::Point& point) {
      const auto known = sights.find(&window);
      oracle::Sight& sight =
          known != sights.end() ? known->second : sights.try_emplace(&window, sheet_of(window), drawn).first->second;
      return sight.is_clear(eye, point);
    };
    for (const oracle::Point& eye : some_eyes(random_, *proof::eyes_of(camera))) {
      for (int i = 0; i < 4; ++i) {
        if (is_refuted(claim.witness, eye, some_point(random_, claim.witness.box), is_clear)) return true;
      }
    }
    return false;
  }

  template <class IsClear>
  static bool is_refuted(const culler::CoverLayer& layer, const oracle::Point& eye, const oracle::Point& point,
                         const IsClear& is_clear) {
    const auto to_glm = [](const oracle::Point& p) { return dvec3(p[0], p[1], p[2]); };
    const auto at = crossing(layer.focus, to_glm(eye), to_glm(point));
    if (!at) return false;
    const auto [x, y] = *at;
    bool is_beside = true;
    for (const CoverWindow& window : layer.windows) {
      const double slack = 1e-9 * (std::fabs(x) + std::fabs(y) + window.x1 - window.x0 + window.y1 - window.y0);
      const double inside = std::min({x - window.x0, window.x1 - x, y - window.y0, window.y1 - y});
      is_beside = is_beside && inside < -slack;
      if (!(inside > slack)) continue;
      if (window.windows.empty() ? is_clear(window, eye, point) : is_refuted(window, eye, point, is_clear)) return true;
    }
    return is_beside;
  }

  Random& random_;
  culler::Culler culler_;
  std::array<Camera, 4> cameras_;
  std::vector<CoverWitness> witnesses_;
  proof::Prover prover_;
};

}  // namespace

void run_region_forgeries(std::uint64_t seed, Report& report) {
  Random random(seed);
  const auto forger = first_legal([&]() -> std::optional<std::unique_ptr<WindowForger>> {
    auto made = std::make_unique<WindowForger>(random, some_region_scene(random));
    return made->has_witnesses() ? std::optional(std::move(made)) : std::nullopt;
  });
  for (std::size_t i = 0; i < kLines; ++i) {
    const WindowForger::Outcome outcome = forger->forge();
    ++report.tally.cases;
    ++report.tally.relations[outcome.is_taken ? 0 : outcome.is_refuted ? 2 : 1];
    if (outcome.is_honest && !outcome.is_taken) {
      add_finding(report, "honest", "what the culler culls is not proved: " + outcome.failure + ": " + outcome.line);
    }
    if (outcome.is_taken && outcome.is_refuted) {
      add_finding(report, "proof", "a line of sight refutes what is proved: " + outcome.line);
    }
  }
}

}  // namespace occlude::fuzz
