// SPDX-License-Identifier: MIT
#include <array>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

#include "cover_tile.h"
#include "measure_culler.h"
#include "rounded_float.h"
#include "seen_plane.h"
#include "true_picture.h"

namespace occlude::bound_check {
namespace {

using culler::BeamPicture;
using culler::Corner;
using culler::Place;
using culler::Seen;
using Share = std::optional<double>;

Exact off(double value, const Exact& truth) { return CGAL::abs(Exact(value) - truth); }
Exact largest(const Exact& a, const Exact& b) { return a < b ? b : a; }
Exact least(const Exact& a, const Exact& b) { return a < b ? a : b; }

Vector exactly(const Seen& seen) { return {Exact(seen.right), Exact(seen.up), Exact(seen.forward)}; }
Exact distance(const Seen& seen, const Vector& truth) {
  const Vector d = exactly(seen) - truth;
  return largest(largest(CGAL::abs(d.x()), CGAL::abs(d.y())), CGAL::abs(d.z()));
}

/// As far as a point may be moved, in a direction between those of the axes.
Vector any_move(Choices& choices, const BeamPicture& picture) {
  const TruePicture truth(picture);
  const double turn = choices.real(-4, 4), tilt = choices.sign();
  const Vector across = choices.chance(0.5) ? truth.right() : truth.up();
  const Vector direction = Exact(std::cos(turn)) * across + Exact(tilt * std::sin(turn)) * truth.forward();
  return Exact(picture.rounding()) * unit(direction);
}

Share coordinates_of_points(Choices& choices) {
  const BeamPicture picture = any_picture(choices, false);
  const auto point = any_point(choices, picture);
  if (!point) return std::nullopt;
  return share(distance(picture.see(*point), TruePicture(picture).see(vector_of(*point))), picture.error());
}

/// A point before the near plane.
std::optional<glm::dvec3> point_before(Choices& choices, const BeamPicture& picture) {
  glm::dvec3 v = picture.depth() * choices.scale(-20, -2) * choices.point();
  const double along = glm::dot(v, picture.forward());
  v += (picture.near() * choices.real(-2, 1) - along) * picture.forward();
  const glm::dvec3 point = picture.eye() + v;
  if (picture.see(point).forward >= picture.near() || std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z) > picture.depth() / 2)
    return std::nullopt;
  return point;
}

/// The cut of an edge, and where the edge exactly is at the share of it that was computed.
struct Cut {
  BeamPicture picture;
  Seen seen;
  Vector truth;
};
std::optional<Cut> any_cut(Choices& choices) {
  const BeamPicture picture = any_picture(choices, false);
  const auto before = point_before(choices, picture), beyond = any_point(choices, picture);
  if (!before || !beyond) return std::nullopt;
  const Seen a = picture.see(*before), b = picture.see(*beyond);
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

Share place_share(const BeamPicture& picture, const Seen& seen, const Vector& truth) {
  const TruePicture exact(picture);
  const Corner corner = picture.corner(seen);
  return share(largest(off(corner.place.x, exact.x(truth)), off(corner.place.y, exact.y(truth))), corner.error);
}

Share positions_of_cuts(Choices& choices) {
  const auto cut = any_cut(choices);
  if (!cut || !cut->picture.is_perspective() || cut->truth.z() <= 0) return std::nullopt;
  return place_share(cut->picture, cut->seen, cut->truth);
}

/// A point as the picture sees it, and where it exactly is once it is moved.
struct SeenPoint {
  BeamPicture picture;
  Seen seen;
  Vector truth;
};
std::optional<SeenPoint> any_seen_point(Choices& choices, bool is_moved) {
  const BeamPicture picture = any_picture(choices, is_moved);
  const auto point = any_point(choices, picture);
  if (!point) return std::nullopt;
  return SeenPoint{picture, picture.see(*point), TruePicture(picture).see(vector_of(*point) + any_move(choices, picture))};
}

Share positions(Choices& choices, bool is_moved) {
  const auto point = any_seen_point(choices, is_moved);
  if (!point) return std::nullopt;
  return place_share(point->picture, point->seen, point->truth);
}

Share nearness_of_points(Choices& choices, bool is_moved) {
  const auto point = any_seen_point(choices, is_moved);
  if (!point) return std::nullopt;
  const auto& [picture, seen, truth] = *point;
  return share(off(picture.nearness(seen.forward), TruePicture(picture).nearness(truth)),
               picture.nearness_error(seen.forward));
}

/// A triangle, its plane as the picture bounds it, and its corners where they exactly are once they are moved.
struct Triangle {
  BeamPicture picture;
  double reach;
  std::array<Seen, 3> seen;
  std::array<Vector, 3> truth;

  [[nodiscard]] culler::SeenPlane plane() const { return {picture, reach, seen[0], seen[1], seen[2]}; }
};

double reach_of(const BeamPicture& picture) {
  const Place low = picture.slope(0, 0), high = picture.slope(picture.width(), picture.height());
  return std::max(std::fabs(low.x), std::fabs(high.x)) + std::max(std::fabs(low.y), std::fabs(high.y));
}

std::optional<Triangle> any_triangle(Choices& choices, bool is_moved) {
  const BeamPicture picture = any_picture(choices, is_moved);
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
    triangle.seen[i] = picture.see(corners[i]);
    triangle.truth[i] = truth.see(vector_of(corners[i]) + Exact(choices.sign()) * away);
  }
  return triangle;
}

/// The nearness of the plane along a ray without a margin, as SeenPlane computes its numbers.
Exact computed_nearness(const Triangle& triangle, const Exact& x, const Exact& y) {
  const auto& [a, b, c] = triangle.seen;
  const glm::dvec3 p{b.right - a.right, b.up - a.up, b.forward - a.forward};
  const glm::dvec3 q{c.right - a.right, c.up - a.up, c.forward - a.forward};
  const glm::dvec3 n = glm::cross(p, q);
  const Exact h(n.x * a.right + n.y * a.up + n.z * a.forward), along = Exact(n.x) * x + Exact(n.y) * y, nz(n.z);
  return triangle.picture.is_perspective() ? Exact((along + nz) / h) : Exact((along - h) / nz);
}

Exact bound_along(const culler::PlaneBound& bound, const Exact& x, const Exact& y) {
  const Exact value = Exact(bound.constant) + Exact(bound.of_y) * y + Exact(bound.of_x) * x;
  return value * Exact(value > 0 ? bound.more : bound.less);
}

/// A position in the picture, from 0 to 1 across and up. The largest errors are in its corners.
double any_share(Choices& choices) { return std::clamp(choices.real(-0.5, 1.5), 0.0, 1.0); }

/// Along any ray of the picture, because tiles are larger than triangles. Corners are where they are computed to be, or
/// anywhere within their errors.
Share planes_along_rays(Choices& choices, bool has_errors) {
  auto triangle = any_triangle(choices, false);
  if (!triangle) return std::nullopt;
  if (has_errors) {
    const Exact error(triangle->picture.error());
    const auto either = [&] { return Exact(Exact(choices.sign()) * error); };
    for (std::size_t i = 0; i < 3; ++i) {
      triangle->truth[i] = exactly(triangle->seen[i]) + Vector(either(), either(), either());
    }
  }
  const culler::SeenPlane plane = triangle->plane();
  if (!plane.is_known()) return std::nullopt;
  const TruePicture exact(triangle->picture);
  const Exact x = exact.ray_x(Exact(any_share(choices) * triangle->picture.width())),
              y = exact.ray_y(Exact(any_share(choices) * triangle->picture.height()));
  const auto& [a, b, c] = triangle->truth;
  const Exact truth = exact.nearness(a, b, c, x, y), computed = computed_nearness(*triangle, x, y);
  return share(computed - truth, computed - bound_along(plane.bound(), x, y));
}

/// Along rays that meet the triangle with its corners moved: beside it, its plane may be anywhere.
Share planes_of_moved_triangles(Choices& choices) {
  const auto triangle = any_triangle(choices, true);
  if (!triangle) return std::nullopt;
  const culler::SeenPlane plane = triangle->plane();
  if (!plane.is_known()) return std::nullopt;
  const auto& [a, b, c] = triangle->truth;
  const Exact p(any_share(choices)), q = (1 - p) * Exact(any_share(choices));
  const Vector met = p * a + q * b + (1 - p - q) * c;
  if (met.z() <= 0) return std::nullopt;
  const Exact nearer = triangle->picture.is_perspective() ? Exact(1 / met.z()) : Exact(1);
  const Exact x = met.x() * nearer, y = met.y() * nearer;
  if (CGAL::abs(x) + CGAL::abs(y) > Exact(triangle->reach)) return std::nullopt;
  const Exact truth = TruePicture(triangle->picture).nearness(met), computed = computed_nearness(*triangle, x, y);
  return share(computed - truth, computed - bound_along(plane.bound(), x, y));
}

/// The least nearness over a tile, as lower() finds it in doubles and rounds it to floats.
Share planes_over_tiles(Choices& choices) {
  const auto triangle = any_triangle(choices, false);
  if (!triangle) return std::nullopt;
  const culler::SeenPlane plane = triangle->plane();
  if (!plane.is_known()) return std::nullopt;
  constexpr int kTile = culler::kTile;
  const BeamPicture& picture = triangle->picture;
  const int x = kTile * static_cast<int>(choices.index(static_cast<std::size_t>(picture.width() / kTile))),
            y = kTile * static_cast<int>(choices.index(static_cast<std::size_t>(picture.height() / kTile)));
  std::array<float, kTile + 1> nearness{std::numeric_limits<float>::infinity()};
  std::array<double, kTile + 2> slopes_x{picture.slope(x, 0).x, picture.slope(x + kTile, 0).x};
  const std::array<double, 2> slopes_y{picture.slope(0, y).y, picture.slope(0, y + kTile).y};
  culler::lower({nearness.data(), 1, slopes_x.data(), slopes_y.data()}, {0, 0, 1, 1}, plane.bound(),
                -std::numeric_limits<float>::infinity());
  const TruePicture exact(picture);
  const auto& [a, b, c] = triangle->truth;
  std::optional<Exact> truth, lowered;
  for (const auto& [at_x, at_y] : {std::pair{x, y}, {x + kTile, y}, {x, y + kTile}, {x + kTile, y + kTile}}) {
    const Exact ray_x = exact.ray_x(at_x), ray_y = exact.ray_y(at_y), here = exact.nearness(a, b, c, ray_x, ray_y);
    const Exact lowest = bound_along(plane.bound(), ray_x, ray_y);
    truth = truth ? least(*truth, here) : here;
    lowered = lowered ? least(*lowered, lowest) : lowest;
  }
  if (!std::isfinite(nearness[0])) return std::nullopt;
  const Exact room = *truth - *lowered + Exact(0x1p-23) * CGAL::abs(*lowered) + Exact(0x1p-149);
  return share_used(room, *truth - Exact(nearness[0]));
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
  return {
      search("coordinates of points", "beam_picture", cases, seed, coordinates_of_points),
      search("coordinates of cuts at the near plane", "beam_picture", cases, seed, coordinates_of_cuts),
      search("positions of points", "beam_picture", cases, seed, still(positions)),
      search("positions of points that are moved", "beam_picture", cases, seed, moved(positions)),
      search("positions of cuts", "beam_picture", cases, seed, positions_of_cuts),
      search("nearness of points", "beam_picture", cases, seed, still(nearness_of_points)),
      search("nearness of points that are moved", "beam_picture", cases, seed, moved(nearness_of_points)),
      search("nearness of planes along rays", "seen_plane", cases, seed, still(planes_along_rays)),
      search("the same, with corners off by their errors", "seen_plane", cases, seed, moved(planes_along_rays)),
      search("the same of triangles that are moved", "seen_plane", cases, seed, planes_of_moved_triangles),
      search("nearness of planes over tiles, in floats", "cover_tile", cases, seed, planes_over_tiles),
      search("doubles rounded down to floats", "rounded_float", cases, seed, rounded_down),
  };
}

}  // namespace occlude::bound_check
