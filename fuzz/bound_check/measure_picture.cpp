// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/rounded_float.h"
#include "cover/cover_tile.h"
#include "cover/projected_plane.h"
#include "measure_culler.h"
#include "true_picture.h"

namespace occlude::bound_check {
namespace {

using culler::BoundedPosition;
using culler::ConservativeViewport;
using culler::EyePoint;
using culler::PixelPosition;
using Share = std::optional<double>;

Exact off(double value, const Exact& truth) { return CGAL::abs(Exact(value) - truth); }
Exact largest(const Exact& a, const Exact& b) { return a < b ? b : a; }
Exact least(const Exact& a, const Exact& b) { return a < b ? a : b; }

/// Of a number that is lowered to a bound, the share by which the truth is below it. The truth may be above.
double share_lowered(const Exact& computed, const Exact& truth, const Exact& bound) {
  return share_used(largest(computed, truth) - bound, truth - bound);
}

/// The roundings of a bound that are left to rounded_down().
Exact left_to_rounding_down(const Exact& bound) { return Exact(0x1p-50) * CGAL::abs(bound); }

Vector exactly(const EyePoint& seen) { return {Exact(seen.right), Exact(seen.up), Exact(seen.forward)}; }
Exact distance(const EyePoint& seen, const Vector& truth) {
  const Vector d = exactly(seen) - truth;
  return largest(largest(CGAL::abs(d.x()), CGAL::abs(d.y())), CGAL::abs(d.z()));
}

/// As far as a point may be moved, in a direction between those of the axes.
Vector any_move(Choices& choices, const ConservativeViewport& picture) {
  const TruePicture truth(picture);
  const double turn = choices.real(-4, 4), tilt = choices.sign();
  const Vector across = choices.chance(0.5) ? truth.right() : truth.up();
  const Vector direction = Exact(std::cos(turn)) * across + Exact(tilt * std::sin(turn)) * truth.forward();
  return Exact(picture.rounding()) * unit(direction);
}

Share coordinates_of_points(Choices& choices) {
  const ConservativeViewport picture = any_picture(choices, false);
  const auto point = any_point(choices, picture);
  if (!point) return std::nullopt;
  return share(distance(picture.eye_point(*point), TruePicture(picture).see(vector_of(*point))), picture.error());
}

/// A point before the near plane.
std::optional<glm::dvec3> point_before(Choices& choices, const ConservativeViewport& picture) {
  glm::dvec3 v = picture.depth() * choices.scale(-20, -2) * choices.point();
  const double along = glm::dot(v, picture.forward());
  v += (picture.near() * choices.real(-2, 1) - along) * picture.forward();
  const glm::dvec3 point = picture.eye() + v;
  if (picture.eye_point(point).forward >= picture.near() ||
      std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z) > picture.depth() / 2)
    return std::nullopt;
  return point;
}

/// The cut of an edge, and where the edge exactly is at the share of it that was computed.
struct Cut {
  ConservativeViewport picture;
  EyePoint seen;
  Vector truth;
};
std::optional<Cut> any_cut(Choices& choices) {
  const ConservativeViewport picture = any_picture(choices, false);
  const auto before = point_before(choices, picture), beyond = any_point(choices, picture);
  if (!before || !beyond) return std::nullopt;
  const EyePoint a = picture.eye_point(*before), b = picture.eye_point(*beyond);
  if (b.forward < picture.near()) return std::nullopt;
  const Exact along((picture.near() - a.forward) / (b.forward - a.forward));
  const TruePicture truth(picture);
  const Vector from = truth.see(vector_of(*before)), to = truth.see(vector_of(*beyond));
  return Cut{picture, picture.cut(a, b), from + along * (to - from)};
}

Share coordinates_of_cuts(Choices& choices) {
  const auto cut = any_cut(choices);
  if (!cut) return std::nullopt;
  return share(distance(cut->seen, cut->truth), cut->picture.error());
}

Share place_share(const ConservativeViewport& picture, const EyePoint& seen, const Vector& truth) {
  const TruePicture exact(picture);
  const BoundedPosition corner = picture.corner(seen);
  return share(largest(off(corner.place.x, exact.x(truth)), off(corner.place.y, exact.y(truth))), corner.error);
}

Share positions_of_cuts(Choices& choices) {
  const auto cut = any_cut(choices);
  if (!cut || !cut->picture.is_perspective() || cut->truth.z() <= 0) return std::nullopt;
  return place_share(cut->picture, cut->seen, cut->truth);
}

/// A point as the picture sees it, and where it exactly is once it is moved.
struct SeenPoint {
  ConservativeViewport picture;
  EyePoint seen;
  Vector truth;
};
std::optional<SeenPoint> any_seen_point(Choices& choices, bool is_moved) {
  const ConservativeViewport picture = any_picture(choices, is_moved);
  const auto point = any_point(choices, picture);
  if (!point) return std::nullopt;
  return SeenPoint{picture, picture.eye_point(*point),
                   TruePicture(picture).see(vector_of(*point) + any_move(choices, picture))};
}

Share positions(Choices& choices, bool is_moved) {
  const auto point = any_seen_point(choices, is_moved);
  if (!point) return std::nullopt;
  return place_share(point->picture, point->seen, point->truth);
}

/// A point in the picture, on an edge that goes on from there.
std::optional<std::array<glm::dvec3, 2>> any_edge_in(Choices& choices, const ConservativeViewport& picture) {
  const auto from = any_point(choices, picture), beside = any_point(choices, picture);
  if (!from || !beside || !picture.is_perspective()) return std::nullopt;
  const PixelPosition slope = picture.slope(choices.real(0, 1) * picture.width(), choices.real(0, 1) * picture.height());
  const double forward = picture.eye_point(*beside).forward;
  const glm::dvec3 met = picture.eye() + forward * (picture.forward() + slope.x * picture.right() + slope.y * picture.up());
  const glm::dvec3 to = met + choices.scale(-10, 3) * (met - *from), y = to - picture.eye();
  const bool is_near = std::fabs(y.x) + std::fabs(y.y) + std::fabs(y.z) <= picture.depth() * (1 - 0x1p-50);
  if (!is_near || picture.eye_point(to).forward < picture.near()) return std::nullopt;
  return std::array{*from, to};
}

/// How far a position on an edge is from the one that divides another edge in the same ratio in the picture.
Exact distance_in_ratio(const std::array<Exact, 2>& at, const std::array<Vector, 2>& edge,
                        const std::array<Vector, 2>& found, const TruePicture& exact) {
  const Exact run_x = exact.x(edge[1]) - exact.x(edge[0]), run_y = exact.y(edge[1]) - exact.y(edge[0]);
  const bool is_level = CGAL::abs(run_x) > CGAL::abs(run_y);
  if (!is_level && run_y == 0) return largest(CGAL::abs(at[0] - exact.x(found[0])), CGAL::abs(at[1] - exact.y(found[0])));
  const Exact ratio = is_level ? Exact((at[0] - exact.x(edge[0])) / run_x) : Exact((at[1] - exact.y(edge[0])) / run_y);
  const auto between = [&](const Exact& from, const Exact& to) { return Exact(from + ratio * (to - from)); };
  return largest(CGAL::abs(at[0] - between(exact.x(found[0]), exact.x(found[1]))),
                 CGAL::abs(at[1] - between(exact.y(found[0]), exact.y(found[1]))));
}

/// A point of an edge that is in the picture once its ends are moved. It is no farther from the edge as that was found than
/// from those of its points that divide it in the same ratio, in space and in the picture.
Share positions_on_edges_in_the_picture(Choices& choices) {
  const ConservativeViewport picture = any_picture(choices, true);
  const auto edge = any_edge_in(choices, picture);
  if (!edge) return std::nullopt;
  const TruePicture exact(picture);
  std::array<EyePoint, 2> seen;
  std::array<Vector, 2> truth, found;
  for (std::size_t i = 0; i < 2; ++i) {
    seen[i] = picture.eye_point((*edge)[i]);
    found[i] = exactly(seen[i]);
    truth[i] = exact.see(vector_of((*edge)[i]) + any_move(choices, picture));
    if (truth[i].z() <= 0) return std::nullopt;
  }
  const Exact along(choices.chance(0.5) ? choices.scale(-60, 0) : choices.real(0, 1));
  const Vector here = truth[0] + along * (truth[1] - truth[0]), same = found[0] + along * (found[1] - found[0]);
  const std::array<Exact, 2> at{exact.x(here), exact.y(here)};
  if (at[0] < 0 || at[0] > picture.width() || at[1] < 0 || at[1] > picture.height()) return std::nullopt;
  const Exact in_space = largest(CGAL::abs(at[0] - exact.x(same)), CGAL::abs(at[1] - exact.y(same)));
  const double error = picture.edge_error(picture.corner(seen[0]), picture.corner(seen[1]));
  return share(least(in_space, distance_in_ratio(at, truth, found, exact)), error);
}

Share nearness_of_points(Choices& choices, bool is_moved) {
  const auto point = any_seen_point(choices, is_moved);
  if (!point) return std::nullopt;
  const auto& [picture, seen, truth] = *point;
  const Exact least(picture.least_nearness(seen.forward));
  return share_lowered(Exact(picture.nearness(seen.forward)), TruePicture(picture).nearness(truth),
                       least - left_to_rounding_down(least));
}

/// A triangle, its plane as the picture bounds it, and its corners where they exactly are once they are moved.
struct Triangle {
  ConservativeViewport picture;
  double reach;
  std::array<EyePoint, 3> seen;
  std::array<Vector, 3> truth;

  [[nodiscard]] culler::ProjectedPlane plane() const { return {picture, reach, seen[0], seen[1], seen[2]}; }
};

double reach_of(const ConservativeViewport& picture) {
  const PixelPosition low = picture.slope(0, 0), high = picture.slope(picture.width(), picture.height());
  return std::max(std::fabs(low.x), std::fabs(high.x)) + std::max(std::fabs(low.y), std::fabs(high.y));
}

std::optional<Triangle> any_triangle(Choices& choices, bool is_moved) {
  const ConservativeViewport picture = any_picture(choices, is_moved);
  Triangle triangle{picture, reach_of(picture), {}, {}};
  const auto first = any_point(choices, picture);
  if (!first) return std::nullopt;
  const double size = picture.depth() * choices.scale(-30, 0);
  std::array<glm::dvec3, 3> corners{*first, *first + size * choices.point(), *first + size * choices.point()};
  const Vector normal =
      CGAL::cross_product(vector_of(corners[1]) - vector_of(corners[0]), vector_of(corners[2]) - vector_of(corners[0]));
  if (normal == Vector(0, 0, 0)) return std::nullopt;
  const Vector away = Exact(picture.rounding()) * unit(normal);
  const TruePicture truth(picture);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 y = corners[i] - picture.eye();
    if (std::fabs(y.x) + std::fabs(y.y) + std::fabs(y.z) > picture.depth() * (1 - 0x1p-50)) return std::nullopt;
    triangle.seen[i] = picture.eye_point(corners[i]);
    triangle.truth[i] = truth.see(vector_of(corners[i]) + Exact(choices.sign()) * away);
  }
  return triangle;
}

/// The nearness of the plane along a ray without a margin, as ProjectedPlane computes its numbers.
Exact computed_nearness(const Triangle& triangle, const Exact& x, const Exact& y) {
  const auto& [a, b, c] = triangle.seen;
  const glm::dvec3 p{b.right - a.right, b.up - a.up, b.forward - a.forward};
  const glm::dvec3 q{c.right - a.right, c.up - a.up, c.forward - a.forward};
  const glm::dvec3 n = glm::cross(p, q);
  const Exact h(n.x * a.right + n.y * a.up + n.z * a.forward), along = Exact(n.x) * x + Exact(n.y) * y, nz(n.z);
  return triangle.picture.is_perspective() ? Exact((along + nz) / h) : Exact((along - h) / nz);
}

Exact bound_along(const culler::PlaneBound& bound, const Exact& x, const Exact& y) {
  const Exact value = (Exact(bound.constant) + Exact(bound.of_y) * y + Exact(bound.of_x) * x) * Exact(bound.scale);
  return value - left_to_rounding_down(value);
}

/// A position in the picture, from 0 to 1 across and up. The largest errors are in its corners.
double any_share(Choices& choices) { return std::clamp(choices.real(-0.5, 1.5), 0.0, 1.0); }

/// A ray that meets the triangle, and the nearness at which it does.
struct Met {
  Exact x, y, nearness;
};
std::optional<Met> any_met(Choices& choices, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.truth;
  const Exact p(any_share(choices)), q = (1 - p) * Exact(any_share(choices));
  const Vector met = p * a + q * b + (1 - p - q) * c;
  if (met.z() <= 0) return std::nullopt;
  const Exact nearer = triangle.picture.is_perspective() ? Exact(1 / met.z()) : Exact(1);
  const Exact x = met.x() * nearer, y = met.y() * nearer;
  if (CGAL::abs(x) + CGAL::abs(y) > Exact(triangle.reach)) return std::nullopt;
  return Met{x, y, TruePicture(triangle.picture).nearness(met)};
}

/// What moves the corners of a triangle from where they are computed to be.
enum class Moves { roundings, errors, renderer };

/// Along rays that meet the triangle: beside it nothing is said. Corners are where they are, anywhere within the errors of
/// what is computed, or moved by a renderer.
Share planes_along_rays(Choices& choices, Moves moves) {
  auto triangle = any_triangle(choices, moves == Moves::renderer);
  if (!triangle) return std::nullopt;
  if (moves == Moves::errors) {
    const Exact error(triangle->picture.error());
    const auto either = [&] { return Exact(Exact(choices.sign()) * error); };
    for (std::size_t i = 0; i < 3; ++i) {
      triangle->truth[i] = exactly(triangle->seen[i]) + Vector(either(), either(), either());
    }
  }
  const culler::ProjectedPlane plane = triangle->plane();
  const auto met = any_met(choices, *triangle);
  if (!plane.is_known() || !met) return std::nullopt;
  const Exact computed = computed_nearness(*triangle, met->x, met->y);
  return share_lowered(computed, met->nearness, bound_along(*plane.bounds(0).begin(), met->x, met->y));
}

/// The least nearness over a tile, as lower() finds it in doubles and rounds it to floats, at a ray of the tile.
Share planes_over_tiles(Choices& choices) {
  const auto triangle = any_triangle(choices, false);
  if (!triangle) return std::nullopt;
  const culler::ProjectedPlane plane = triangle->plane();
  const auto met = any_met(choices, *triangle);
  if (!plane.is_known() || !met) return std::nullopt;
  constexpr int kTile = culler::kTile;
  const ConservativeViewport& picture = triangle->picture;
  const TruePicture exact(picture);
  const auto tile_of = [](const Exact& ray, const auto& ray_at, int size) {
    int tile = 0;
    while (tile + kTile < size && ray > ray_at(tile + kTile)) tile += kTile;
    return tile;
  };
  const auto ray_x = [&](int x) { return exact.ray_x(x); };
  const auto ray_y = [&](int y) { return exact.ray_y(y); };
  const int x = tile_of(met->x, ray_x, picture.width()), y = tile_of(met->y, ray_y, picture.height());
  if (met->x < ray_x(x) || met->x > ray_x(x + kTile) || met->y < ray_y(y) || met->y > ray_y(y + kTile)) return std::nullopt;
  std::array<float, kTile + 1> nearness{std::numeric_limits<float>::infinity()};
  std::array<double, kTile + 2> slopes_x{picture.slope(x, 0).x, picture.slope(x + kTile, 0).x};
  const std::array<double, 2> slopes_y{picture.slope(0, y).y, picture.slope(0, y + kTile).y};
  culler::lower({nearness.data(), 1, slopes_x.data(), slopes_y.data()}, {0, 0, 1, 1}, *plane.bounds(0).begin(),
                -std::numeric_limits<float>::infinity());
  if (!std::isfinite(nearness[0])) return std::nullopt;
  std::optional<Exact> lowest;
  for (const auto& [at_x, at_y] : {std::pair{x, y}, {x + kTile, y}, {x, y + kTile}, {x + kTile, y + kTile}}) {
    const Exact here = bound_along(*plane.bounds(0).begin(), ray_x(at_x), ray_y(at_y));
    lowest = lowest ? least(*lowest, here) : here;
  }
  const Exact room = met->nearness - *lowest + Exact(0x1p-23) * CGAL::abs(*lowest) + Exact(0x1p-149);
  return share_used(room, met->nearness - Exact(nearness[0]));
}

/// A number rounded to a float, of what it is lowered by.
Share rounded_down(Choices& choices) {
  const double x = choices.sign() * choices.real(1, 2) * choices.scale(-140, 127);
  const Exact room = Exact(0x1p-23) * CGAL::abs(Exact(x)) + Exact(0x1p-149);
  return share_used(room, Exact(x) - Exact(culler::rounded_down(x)));
}

}  // namespace

std::vector<Measured> measure_picture(int cases, std::uint64_t seed) {
  const auto still = [](auto measure) { return [measure](Choices& choices) { return measure(choices, false); }; };
  const auto moved = [](auto measure) { return [measure](Choices& choices) { return measure(choices, true); }; };
  const auto planes = [](Moves moves) { return [moves](Choices& choices) { return planes_along_rays(choices, moves); }; };
  return {
      search("coordinates of points", "beam_picture", cases, seed, coordinates_of_points),
      search("coordinates of cuts at the near plane", "beam_picture", cases, seed, coordinates_of_cuts),
      search("positions of points", "beam_picture", cases, seed, still(positions)),
      search("positions of points that are moved", "beam_picture", cases, seed, moved(positions)),
      search("positions of cuts", "beam_picture", cases, seed, positions_of_cuts),
      search("positions on edges in the picture", "beam_picture", cases, seed, positions_on_edges_in_the_picture),
      search("nearness of points", "beam_picture", cases, seed, still(nearness_of_points)),
      search("nearness of points that are moved", "beam_picture", cases, seed, moved(nearness_of_points)),
      search("nearness of planes along rays", "seen_plane", cases, seed, planes(Moves::roundings)),
      search("the same, with corners off by their errors", "seen_plane", cases, seed, planes(Moves::errors)),
      search("the same of triangles that are moved", "seen_plane", cases, seed, planes(Moves::renderer)),
      search("nearness of planes over tiles, in floats", "cover_tile", cases, seed, planes_over_tiles),
      search("doubles rounded down to floats", "rounded_float", cases, seed, rounded_down),
  };
}

}  // namespace occlude::bound_check
