// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "any_case.h"
#include "cases/to_oracle.h"
#include "experiment.h"
#include "nudge.h"
#include "occlude/fuzz/neighbours.h"
#include "occlude/kernel/cover.h"
#include "occlude/oracle/cover.h"
#include "occlude/oracle/visibility.h"
#include "rows.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using kernel::Vec3;

struct Question {
  kernel::Viewpoint viewpoint;
  std::vector<Polygon> polygons;
  std::optional<kernel::HalfSpace> drawn;
  Box box;
};

/// The oracle would take long for more triangles.
constexpr std::size_t kMostTriangles = 8;

std::size_t triangles_of(const std::vector<Polygon>& polygons) {
  std::size_t sum = 0;
  for (const Polygon& polygon : polygons) sum += polygon.size() - 2;
  return sum;
}

Vec3 between(const Vec3& a, const Vec3& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

/// Adds the polygon in two pieces that meet at a point of an edge. If the point is rounded, or if another polygon has that
/// edge without the point, the pieces leave a gap of some ulps or overlap by as much.
void add_halves(Random& random, const Polygon& whole, std::vector<Polygon>& pieces) {
  const std::size_t count = whole.size(), across = random.index(count);
  const auto corner = [&](std::size_t i) { return whole[(across + i) % count]; };
  const std::size_t edge = 1 + random.index(count - 2);
  const Vec3 middle = between(corner(edge), corner(edge + 1), random.chance(0.7) ? 0.5 : random.real(0, 1));
  Polygon first, second;
  for (std::size_t i = 0; i <= edge; ++i) first.push_back(corner(i));
  first.push_back(middle);
  second = {corner(0), middle};
  for (std::size_t i = edge + 1; i < count; ++i) second.push_back(corner(i));
  pieces.push_back(std::move(first));
  pieces.push_back(std::move(second));
}

void spoil(Random& random, std::vector<Polygon>& pieces) {
  Polygon& one = pieces[random.index(pieces.size())];
  switch (random.index(5)) {
    case 0:
      nudge(random, one);
      break;
    case 1:  // the same piece twice
      pieces.push_back(Polygon(one));
      break;
    case 2:  // a hole
      one = {one[0], one[1], one[0]};
      break;
    case 3:  // an edge that three polygons have, and a flap
      pieces.push_back({one[0], one[1], between(one[0], pieces[0][0], random.real(-1, 1))});
      break;
    default:  // turned over
      one = Polygon(one.rbegin(), one.rend());
      break;
  }
}

/// An occluder of any family in pieces, and the box of its case.
std::optional<Question> pieces_of_a_polygon(Random& random) {
  Case whole = any_case(random);
  auto* const polygon = std::get_if<Polygon>(&whole.occluder);
  if (!polygon || polygon->size() < 3 || polygon->size() > kMostTriangles) return std::nullopt;
  std::vector<Polygon> pieces{std::move(*polygon)};
  while (triangles_of(pieces) + 2 <= kMostTriangles && random.chance(0.7)) {
    const std::size_t i = random.index(pieces.size());
    const Polygon one = pieces[i];
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
    add_halves(random, one, pieces);
  }
  if (random.chance(0.5)) spoil(random, pieces);
  return Question{whole.viewpoint, std::move(pieces), {}, whole.box};
}

Vec3 lattice_point(Random& random, int low_x, int reach) {
  return {static_cast<double>(random.integer(low_x, reach)), static_cast<double>(random.integer(-reach, reach)),
          static_cast<double>(random.integer(-reach, reach))};
}

Box lattice_box(Random& random, int low_x, int reach) {
  Vec3 at = lattice_point(random, 1, 1);
  at.x = random.integer(low_x, 2 * reach);
  const auto half = [&] { return 0.5 * random.integer(-1, 1); };
  if (random.chance(0.6)) {
    return kernel::Aabb{at, {at.x + random.integer(0, 2), at.y + random.integer(0, 1), at.z + random.integer(0, 1)}};
  }
  kernel::Obb box{at, {}};
  for (Vec3& edge : box.half_edges) {
    if (random.chance(0.75)) edge = {half(), half(), half()};
  }
  return box;
}

/// A few polygons on a small lattice. Some share edges, some are edge-on, and some are around the eye or behind it.
std::optional<Question> lattice_polygons(Random& random) {
  const int reach = random.integer(1, 4), low_x = random.chance(0.3) ? -1 : 1;
  Question question;
  question.viewpoint = random.chance(0.25)  ? kernel::Viewpoint::direction({1, 1.0 * random.integer(-1, 1), 0})
                       : random.chance(0.2) ? kernel::Viewpoint::eye(lattice_point(random, -1, 1))
                                            : kernel::Viewpoint::eye({0, 0, 0});
  std::vector<Polygon>& polygons = question.polygons;
  for (std::size_t count = 1 + random.index(5); polygons.size() < count;) {
    Polygon polygon;
    for (std::size_t corners = random.chance(0.25) ? 4 : 3; polygon.size() < corners;) {
      polygon.push_back(lattice_point(random, low_x, reach));
    }
    if (!polygons.empty() && random.chance(0.5)) {
      polygon[0] = polygons.back()[1];
      polygon[1] = polygons.back()[2];
    }
    if (random.chance(0.12)) {
      for (Vec3& v : polygon) v.z = 0;
    }
    polygons.push_back(std::move(polygon));
  }
  if (random.chance(0.25)) {
    question.drawn = kernel::HalfSpace{{1, 1.0 * random.integer(-1, 1), 0}, -1.0 * random.integer(0, 2)};
  }
  question.box = lattice_box(random, low_x, reach);
  return question;
}

std::optional<Question> some_question(Random& random) {
  auto question = random.chance(0.5) ? pieces_of_a_polygon(random) : lattice_polygons(random);
  if (!question || triangles_of(question->polygons) > kMostTriangles + 2) return std::nullopt;
  const bool is_legal = kernel::Cover::make(question->viewpoint, question->polygons, question->drawn).cover.has_value() &&
                        check(question->box) == kernel::Refusal::none;
  return is_legal ? question : std::nullopt;
}

std::optional<oracle::HalfSpaceCoefficients> coefficients(const std::optional<kernel::HalfSpace>& drawn) {
  if (!drawn) return std::nullopt;
  return oracle::HalfSpaceCoefficients{drawn->normal.x, drawn->normal.y, drawn->normal.z, drawn->offset};
}

/// Whether the plane of the drawn half-space contains a triangle of the polygons. The kernel counts that triangle as hiding,
/// and exact visibility does not. Such triangles come from a lattice of small integers, where doubles are exact.
bool ends_in_a_triangle(const Question& question) {
  if (!question.drawn) return false;
  const auto is_on_plane = [&](const Vec3& v) {
    const auto& [n, offset] = *question.drawn;
    return n.x * v.x + n.y * v.y + n.z * v.z + offset == 0;
  };
  return std::ranges::any_of(question.polygons, [&](const Polygon& polygon) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      if (is_on_plane(polygon[0]) && is_on_plane(polygon[i]) && is_on_plane(polygon[i + 1])) return true;
    }
    return false;
  });
}

/// Checks a hidden box by exact visibility, which has no shadows: between the polygons nothing may show of the faces of the
/// box.
bool shows(const Question& question, const kernel::Aabb& box) {
  std::vector<oracle::Triangle> triangles;
  const auto add_fan = [&](const oracle::Loop& loop) {
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) triangles.push_back({loop[0], loop[i], loop[i + 1]});
  };
  const auto corner = [&](int bits) {
    return to_oracle(
        Vec3{(bits & 1 ? box.max : box.min).x, (bits & 2 ? box.max : box.min).y, (bits & 4 ? box.max : box.min).z});
  };
  for (const auto& [a, b] : {std::pair{1, 2}, {2, 4}, {4, 1}}) {
    const int other = 7 - a - b;
    add_fan({corner(0), corner(a), corner(a + b), corner(b)});
    add_fan({corner(other), corner(other + a), corner(7), corner(other + b)});
  }
  const auto faces = static_cast<std::ptrdiff_t>(triangles.size());
  for (const Polygon& polygon : question.polygons) add_fan(to_oracle(polygon));
  oracle::Picture picture;
  if (const auto drawn = coefficients(question.drawn)) picture.depth.push_back(*drawn);
  const std::vector<bool> visible = oracle::visible_triangles(to_oracle(question.viewpoint), triangles, picture);
  return std::find(visible.begin(), visible.begin() + faces, true) != visible.begin() + faces;
}

}  // namespace

void run_covers(std::uint64_t seed, Report& report) {
  Random random(seed);
  const Question question = first_legal([&] { return some_question(random); });
  const kernel::Cover cover = *kernel::Cover::make(question.viewpoint, question.polygons, question.drawn).cover;
  const std::vector<oracle::Loop> polygons = to_oracle(question.polygons);
  const bool is_unlike = ends_in_a_triangle(question);
  for (std::uint64_t i = 0; i < kGroup; ++i) {
    const Box box = i == 0 ? question.box : legal_neighbour(random, question.box);
    const kernel::Decision decision =
        std::visit([&](const auto& kind) { return kernel::overlap_certified(cover, kind); }, box);
    judge(report, "box " + std::to_string(i), decision.relation, decision.stage,
          oracle::relation_to_cover(to_oracle(question.viewpoint), polygons, to_oracle(box), coefficients(question.drawn)));
    const auto* const aabb = std::get_if<kernel::Aabb>(&box);
    if (aabb == nullptr || is_unlike || decision.relation != kernel::Relation::inside || !is_judged_twice(seed * kGroup + i))
      continue;
    ++report.tally.judged_twice;
    if (shows(question, *aabb)) add_finding(report, "second oracle", "box " + std::to_string(i) + " shows");
  }
}

}  // namespace occlude::fuzz
