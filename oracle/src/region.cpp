// SPDX-License-Identifier: MIT
// The lines from the eyes E through a window P fill the hull of E and P up to the focus plane, and P + cone(P - E) beyond
// it: p + t (p' - e) with t >= 0 is (1 + t) q - t e for some q of P. A polygon does not meet such a set when some plane
// separates the two strictly, which is a question about its normal n (separation.h). For all corners q of the polygon,
// corners p of the window and eyes e it asks
//   up to the focus plane   n . (q - p) > 0 and n . (q - e) > 0,
//   beyond it               n . (q - p) > 0 and n . (e - p) > 0.
// The last may be asked without equality because n may be turned a little towards the eyes, which are strictly before P.
#include "occlude/oracle/region.h"

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <span>
#include <utility>

#include "box.h"
#include "clipped.h"
#include "eyes.h"
#include "half_spaces.h"
#include "rectangles.h"
#include "region_faults.h"
#include "separation.h"
#include "sheet.h"

namespace occlude::oracle {
namespace {

/// The half-spaces by which polygons are cut. `drawn` is that of the sheet, `nearer` is before the nearest corner of the
/// box.
enum class Cut { drawn, undrawn, nearer, farther, before_focus, beyond_focus };

/// The set that a polygon may meet: the eyes, or lines through a window up to the focus plane or beyond it.
enum class Part { eyes, before, beyond };

/// What a layer is about, in one number type.
template <class N>
struct Setting {
  Eyes<N> eyes;
  Vector<N> origin, right, up, forward;  ///< of the focus plane
  std::vector<Vector<N>> box;            ///< its corners
  std::vector<Vector<N>> seen;           ///< the corners of what is seen through the layer: a box or a window

  [[nodiscard]] Vector<N> at(const N& x, const N& y) const { return origin + x * right + y * up; }
};

constexpr HalfSpaceCoefficients kEverywhere{0, 0, 0, 1};

/// A unit of work is a corner or a triangle that is compared with one plane or one line. It takes up to a tenth of a
/// microsecond, and what separates two sets in exact numbers takes a millisecond. The limit is about half a minute.
constexpr std::size_t kMostWork = std::size_t{1} << 28U, kWorkOfSeparation = std::size_t{1} << 13U;

/// A normal n, and a number that n . x does not exceed at any point x of a part.
struct Bound {
  Point normal;
  double most;
};

template <class N>
struct Sightline {
  Vector<N> eye, along;
};

/// Corners of a polygon, and by what it is cut.
struct Obstacle {
  std::span<const Point> corners;
  std::span<const Cut> cuts;
};

constexpr const char* words(RegionFault fault) {
  constexpr std::array kWords{"",
                              "the windows take too much work",
                              "the eyes reach the focus plane",
                              "the eyes reach the depth of the box",
                              "the windows do not cover what the box is seen through",
                              "the eyes touch the sheet",
                              "the border of the sheet shows before the focus plane",
                              "the border of the sheet shows beyond the focus plane",
                              "the sheet reaches the depth of the box",
                              "the sheet is met an even number of times"};
  return kWords[static_cast<std::size_t>(fault)];
}

/// Judges a layer of a witness with sound numbers.
class Judge {
 public:
  /// The lines of sight are those to the box, or to the window at which the judge of another layer is. `work` is what has
  /// been done so far.
  Judge(const RegionWitness& witness, const Layer& layer, Judge* of_window, std::size_t& work)
      : witness_(witness), layer_(layer), of_window_(of_window), work_(work), approximate_(setting<Interval>()) {
    for (std::size_t i = 1; i < approximate_.box.size(); ++i) {
      const auto farther_by = [&]<class N>() -> N { return in<N>().forward * (in<N>().box[i] - in<N>().box[nearest_]); };
      if (sign_of(farther_by) == CGAL::NEGATIVE) nearest_ = i;
    }
  }

  [[nodiscard]] RegionVerdict verdict() {
    const auto is = [](RegionFault fault) { return RegionVerdict{fault, 0, words(fault)}; };
    if (least_side_of_eyes(Cut::before_focus) != CGAL::POSITIVE) return is(RegionFault::eyes_at_focus);
    if (least_side_of_eyes(Cut::nearer) != CGAL::POSITIVE || !are_eyes_before_seen()) return is(RegionFault::eyes_at_box);
    if (!is_shadow_covered()) return is(RegionFault::uncovered);
    for (std::size_t i = 0; i < layer_.windows.size(); ++i) {
      const RegionVerdict found = verdict_on(layer_.windows[i]);
      if (!found.is_proved()) return {found.fault, i, "window " + std::to_string(i) + ": " + found.reason};
    }
    return {};
  }

 private:
  template <class N>
  Setting<N> setting() {
    const Vector<N> right = vector_of<N>(layer_.focus.right);
    const Vector<N> up = CGAL::cross_product(right, vector_of<N>(layer_.focus.normal));
    const auto box = std::visit([](const auto& kind) { return corners_of<N>(kind); }, witness_.box);
    return {eyes_of<N>(witness_.eyes),
            vector_of<N>(layer_.focus.point),
            right,
            up,
            CGAL::cross_product(up, right),
            box,
            of_window_ ? of_window_->corners<N>() : box};
  }

  template <class N>
  const Setting<N>& in() {
    if constexpr (std::is_same_v<N, Interval>) {
      return approximate_;
    } else {
      if (!exact_) exact_ = setting<N>();
      return *exact_;
    }
  }

  template <class N>
  HalfSpace<N> half_space(Cut cut) {
    const Setting<N>& setting = in<N>();
    if (cut == Cut::before_focus) return {-setting.forward, setting.origin};
    if (cut == Cut::beyond_focus) return {setting.forward, setting.origin};
    if (cut == Cut::nearer) return {-setting.forward, setting.box[nearest_]};
    if (cut == Cut::farther) return {setting.forward, setting.box[nearest_]};
    const HalfSpace<N> h = CoefficientPlane{sheet_->drawn.value_or(kEverywhere)}.operator()<N>();
    return cut == Cut::drawn ? h : HalfSpace<N>{-h.normal, h.point, -h.offset};
  }

  CGAL::Sign least_side_of_eyes(Cut cut) {
    return decide([&]<class N>() { return least_side(in<N>().eyes, half_space<N>(cut)); });
  }

  bool are_eyes_before_seen() {
    for (std::size_t i = 0; i < approximate_.seen.size(); ++i) {
      const CGAL::Sign side = decide([&]<class N>() {
        return least_side(in<N>().eyes, HalfSpace<N>{-in<N>().forward, in<N>().seen[i]});
      });
      if (side != CGAL::POSITIVE) return false;
    }
    return true;
  }

  /// Whether all lines of sight cross the focus plane where sign * coordinate `k` <= sign * bound. Let b be a corner of what
  /// is seen and m the normal of the plane through b and the points with that coordinate. An eye e sees b at bound + m . (e
  /// - b) over a positive number. For one eye the coordinate has its extremes at corners.
  bool is_shadow_within(std::size_t k, double bound, int sign) {
    for (std::size_t i = 0; i < approximate_.seen.size(); ++i) {
      const CGAL::Sign side = decide([&]<class N>() {
        const Setting<N>& s = in<N>();
        const Vector<N>& b = s.seen[i];
        const Vector<N> to_b = b - s.at(k == 0 ? N(bound) : N(0), k == 0 ? N(0) : N(bound));
        const Vector<N> m = k == 0 ? CGAL::cross_product(to_b, s.up) : CGAL::cross_product(s.right, to_b);
        return least_side(s.eyes, HalfSpace<N>{N(-sign) * m, b});
      });
      if (side == CGAL::NEGATIVE) return false;
    }
    return true;
  }

  /// The windows cover a rectangle when they cover the smallest one around it whose sides lie on sides of windows.
  bool is_shadow_covered() {
    std::vector<Rectangle> windows;
    for (const auto& [x0, y0, x1, y1, to] : layer_.windows) windows.push_back({{x0, y0}, {x1, y1}});
    Rectangle shadow{};
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<double> sides;
      for (const Rectangle& window : windows) sides.insert(sides.end(), {window.low[k], window.high[k]});
      std::ranges::sort(sides);
      const auto high = std::ranges::partition_point(sides, [&](double x) { return !is_shadow_within(k, x, 1); });
      const auto beyond_low = std::ranges::partition_point(sides, [&](double x) { return is_shadow_within(k, x, -1); });
      if (high == sides.end() || beyond_low == sides.begin()) return false;
      shadow.low[k] = *std::prev(beyond_low);
      shadow.high[k] = *high;
    }
    return is_covered(shadow, std::move(windows));
  }

  RegionVerdict verdict_on(const Window& window) {
    window_ = &window;
    if (const Layer* layer = std::get_if<Layer>(&window.to)) return Judge(witness_, *layer, this, work_).verdict();
    const RegionFault fault = fault_of(std::get<Sheet>(window.to).prepared());
    const RegionFault known = work_ > kMostWork ? RegionFault::refused : fault;
    return {known, 0, words(known)};
  }

  /// What the sheet of the window fails to show.
  RegionFault fault_of(const Sheet::Prepared& sheet) {
    for (const Part part : {Part::before, Part::beyond}) {
      for (Bound& bound : bounds(part)) bound.most = most(bound.normal, part);
    }
    if (sheet_ != &sheet) take(sheet);
    const auto meet = [&](const std::vector<Obstacle>& obstacles, Part part) {
      return std::ranges::any_of(obstacles, [&](const Obstacle& obstacle) { return meets(obstacle, part); });
    };
    if (meet(at_eyes_, Part::eyes)) return RegionFault::eyes_at_sheet;
    if (meet(border_, Part::before)) return RegionFault::border_before;
    if (meet(border_, Part::beyond)) return RegionFault::border_beyond;
    if (meet(deep_, Part::before) || meet(deep_, Part::beyond)) return RegionFault::not_nearer;
    return is_odd() ? RegionFault::none : RegionFault::even;
  }

  /// Finds what of a sheet lines through a window must not meet, but for what is cut away for certain.
  void take(const Sheet::Prepared& sheet) {
    using enum Cut;
    static constexpr std::array kBorder{nearer, drawn};
    static constexpr std::array kCut{nearer, drawn, undrawn};
    static constexpr std::array kDepth{nearer, farther, drawn};
    static constexpr std::array kDrawn{drawn};
    sheet_ = &sheet;
    const auto add = [&](std::vector<Obstacle>& obstacles, const auto& polygons, std::span<const Cut> cuts) {
      for (const auto& polygon : polygons) {
        const auto cuts_away = [&](Cut cut) { return is_cut_away(polygon, cut); };
        if (std::ranges::none_of(cuts, cuts_away)) obstacles.push_back({polygon, cuts});
      }
    };
    for (std::vector<Obstacle>* obstacles : {&border_, &deep_, &at_eyes_}) obstacles->clear();
    add(border_, sheet.border, kBorder);
    add(border_, sheet.cut, kCut);
    add(deep_, sheet.triangles, kDepth);
    if (least_side_of_eyes(undrawn) != CGAL::POSITIVE) add(at_eyes_, sheet.triangles, kDrawn);
  }

  bool is_cut_away(std::span<const Point> polygon, Cut cut) {
    const HalfSpace<Interval> h = half_space<Interval>(cut);
    return std::ranges::all_of(polygon, [&](const Point& q) { return CGAL::certainly(h.height(q) < 0); });
  }

  /// Also true when there was too much work.
  bool meets(const Obstacle& obstacle, Part part) {
    const auto is_beyond = [&](const Bound& bound) {
      return std::ranges::all_of(obstacle.corners, [&](const Point& q) {
        return Interval(vector_of<Interval>(bound.normal) * vector_of<Interval>(q)).inf() > bound.most;
      });
    };
    work_ += obstacle.corners.size() * (bounds(part).size() + 1);
    if (work_ > kMostWork) return true;
    if (std::ranges::any_of(bounds(part), is_beyond)) return false;
    if (part != Part::eyes && is_cut_away(obstacle.corners, cut_of(part))) return false;
    work_ += kWorkOfSeparation;
    const Separation separation = decide([&]<class N>() {
      std::vector<Homogeneous<N>> rest;
      for (const Point& q : obstacle.corners) rest.push_back({vector_of<N>(q), N(1)});
      for (const Cut cut : obstacle.cuts) rest = clipped(rest, half_space<N>(cut));
      if (part != Part::eyes) rest = clipped(rest, half_space<N>(cut_of(part)));
      return rest.empty() ? Separation{true, {}} : separate(differences(rest, part));
    });
    if (separation.normal) bounds(part).push_back({*separation.normal, most(*separation.normal, part)});
    return !separation.exists;
  }

  static Cut cut_of(Part part) { return part == Part::before ? Cut::before_focus : Cut::beyond_focus; }
  std::vector<Bound>& bounds(Part part) { return bounds_[static_cast<std::size_t>(part)]; }

  /// The corners of the window.
  template <class N>
  std::vector<Vector<N>> corners() {
    std::vector<Vector<N>> result;
    for (const double x : {window_->x0, window_->x1}) {
      for (const double y : {window_->y0, window_->y1}) result.push_back(in<N>().at(N(x), N(y)));
    }
    return result;
  }

  /// What a normal must be positive at if it is to separate the polygon from the part.
  template <class N>
  std::vector<Around<N>> differences(const std::vector<Homogeneous<N>>& polygon, Part part) {
    const std::vector<Vector<N>> window = part == Part::eyes ? std::vector<Vector<N>>{} : corners<N>();
    const Eyes<N>& region = in<N>().eyes;
    std::vector<Around<N>> result;
    for (const auto& [q, w] : polygon) {
      for (const Vector<N>& p : window) result.push_back({q - w * p, N(0)});
      if (part == Part::beyond) continue;
      for (const Vector<N>& e : region.corners) result.push_back({q - w * e, w * region.radius});
    }
    if (part != Part::beyond) return result;
    for (const Vector<N>& p : window) {
      for (const Vector<N>& e : region.corners) result.push_back({e - p, region.radius});
    }
    return result;
  }

  /// A bound on normal . x at the points x of the part. Infinite where there may be none.
  double most(const Point& normal, Part part) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Vector<Interval> n = vector_of<Interval>(normal);
    double of_window = -kInfinity, of_eyes = -kInfinity, least_of_eyes = kInfinity;
    const Interval reach = approximate_.eyes.radius * CGAL::sqrt(n * n);
    for (const Vector<Interval>& e : approximate_.eyes.corners) {
      of_eyes = std::max(of_eyes, Interval(n * e + reach).sup());
      least_of_eyes = std::min(least_of_eyes, Interval(n * e - reach).inf());
    }
    if (part == Part::eyes) return of_eyes;
    for (const Vector<Interval>& p : corners<Interval>()) of_window = std::max(of_window, Interval(n * p).sup());
    if (part == Part::before) return std::max(of_eyes, of_window);
    return of_window < least_of_eyes ? of_window : kInfinity;
  }

  /// Whether a line through the window meets the sheet an odd number of times before the depth of the box. Nearly every line
  /// is in general position.
  bool is_odd() {
    constexpr int kLines = 100;
    std::minstd_rand random(1);
    for (int i = 0; i < kLines; ++i) {
      const auto share = [&] { return static_cast<double>(random() >> 1U) * 0x1p-30; };
      const double x = share(), y = share();
      if (const std::optional<std::size_t> count = crossings(x, y)) return *count % 2 == 1;
    }
    return false;
  }

  /// How many triangles the line crosses. Empty where it meets an edge.
  std::optional<std::size_t> crossings(double x, double y) {
    const auto [eye, along] = line<Interval>(x, y);
    std::array<HalfSpace<Interval>, 2> through{HalfSpace<Interval>{CGAL::cross_product(along, approximate_.right), eye},
                                               {CGAL::cross_product(along, approximate_.up), eye}};
    work_ += sheet_->triangles.size();
    std::size_t count = 0;
    for (const Triangle& triangle : sheet_->triangles) {
      const auto is_aside = [&](const HalfSpace<Interval>& plane) {
        const std::array heights{plane.height(triangle[0]), plane.height(triangle[1]), plane.height(triangle[2])};
        return std::ranges::all_of(heights, [](const Interval& h) { return h.inf() > 0; }) ||
               std::ranges::all_of(heights, [](const Interval& h) { return h.sup() < 0; });
      };
      if (std::ranges::any_of(through, is_aside)) continue;
      const std::optional<bool> crosses = decide([&]<class N>() { return is_crossed(triangle, line<N>(x, y)); });
      if (!crosses) return std::nullopt;
      if (*crosses) ++count;
    }
    return count;
  }

  /// The line from the middle of the eyes through a point of the window, whose place is given by two shares of its sides.
  template <class N>
  Sightline<N> line(double x, double y) {
    const auto between = [](double low, double high, double share) { return N(N(low) + N(share) * (N(high) - N(low))); };
    const Vector<N> eye = vector_of<N>(middle());
    return {eye, in<N>().at(between(window_->x0, window_->x1, x), between(window_->y0, window_->y1, y)) - eye};
  }

  const Point& middle() const {
    return std::visit([](const auto& kind) -> const Point& { return kind.center; }, witness_.eyes);
  }

  /// Whether the line crosses the triangle, where it is drawn, before the depth of the box. Empty if it meets an edge.
  template <class N>
  std::optional<bool> is_crossed(const Triangle& triangle, const Sightline<N>& line) {
    const auto& [eye, along] = line;
    std::array<Vector<N>, 3> to;
    for (std::size_t i = 0; i < 3; ++i) to[i] = vector_of<N>(triangle[i]) - eye;
    std::array<CGAL::Sign, 3> turns{};
    N speed(0);  // by which the line goes through the plane of the triangle
    for (std::size_t i = 0; i < 3; ++i) {
      const N turn = along * CGAL::cross_product(to[i], to[(i + 1) % 3]);
      turns[i] = certain_sign(turn);
      speed += turn;
    }
    if (std::ranges::count(turns, CGAL::POSITIVE) > 0 && std::ranges::count(turns, CGAL::NEGATIVE) > 0) return false;
    if (std::ranges::count(turns, CGAL::ZERO) > 0) return std::nullopt;
    const CGAL::Sign sign = turns[0];
    const N distance = to[0] * CGAL::cross_product(to[1], to[2]);  // of that plane, as a multiple of `speed`
    if (certain_sign(distance) != sign) return false;
    // What is on the plane of `drawn` is a triangle in that plane. Anything else would be border.
    for (const Cut cut : {Cut::drawn, Cut::nearer}) {
      const HalfSpace<N> h = half_space<N>(cut);
      if (certain_sign(N(h.height(eye) * speed + distance * (h.normal * along))) == -sign) return false;
    }
    return true;
  }

  const RegionWitness& witness_;
  const Layer& layer_;
  Judge* of_window_;
  std::size_t& work_;
  Setting<Interval> approximate_;
  std::optional<Setting<Exact>> exact_;
  std::size_t nearest_ = 0;  ///< the corner of the box
  const Window* window_ = nullptr;
  const Sheet::Prepared* sheet_ = nullptr;
  std::vector<Obstacle> border_, deep_, at_eyes_;  ///< of the sheet, those that no line, and no eye, may meet
  std::array<std::vector<Bound>, 3> bounds_;       ///< of each part, with normals that were found for other windows, too
};

}  // namespace

RegionVerdict judge(const RegionWitness& witness) {
  const RoundUpward rounding;
  if (std::string reason = fault_of(witness); !reason.empty()) return {RegionFault::refused, 0, std::move(reason)};
  std::size_t work = 0;
  return Judge(witness, witness.layer, nullptr, work).verdict();
}

}  // namespace occlude::oracle
