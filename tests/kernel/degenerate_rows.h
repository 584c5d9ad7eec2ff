// SPDX-License-Identifier: MIT
// Degenerate positions worked out by hand: the answer, and the cheapest stage that can give it.
//
// The filter decides what lies farther from every plane that matters than its error bound, a few ulps of the coordinates;
// what touches, or misses by an ulp, is for the exact stage. Where the stage is not obvious from that, the row says why.
#pragma once

#include <cmath>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "kernel/cube.h"
#include "occlude/fuzz/cases.h"
#include "occlude/kernel/types.h"

namespace occlude {

struct DegenerateRow {
  std::string name;
  fuzz::Case scene;
  kernel::Relation relation;
  kernel::Stage stage;

  friend void PrintTo(const DegenerateRow& row, std::ostream* out) { *out << row.name; }
};

namespace degenerate {

using kernel::Aabb, kernel::Near, kernel::Obb, kernel::Polytope, kernel::Vec3, kernel::Viewpoint;
using enum kernel::Near;
using enum kernel::Relation;
using enum kernel::Stage;
using Rows = std::vector<DegenerateRow>;
using Loop = std::vector<Vec3>;

/// What the rows of a group share, and its name.
struct Setting {
  std::string name;
  Viewpoint viewpoint;
  fuzz::Occluder occluder;
  Near near;
};

/// What is a row's own.
struct Entry {
  const char* name;
  fuzz::Box box;
  kernel::Relation relation;
  kernel::Stage stage;
};

inline Rows rows_of(const Setting& setting, const std::vector<Entry>& entries) {
  const auto& [name, viewpoint, occluder, near] = setting;
  Rows rows;
  for (const Entry& entry : entries) {
    rows.push_back({name + "_" + entry.name, {viewpoint, occluder, near, entry.box}, entry.relation, entry.stage});
  }
  return rows;
}

inline Aabb point(const Vec3& p) { return {p, p}; }
inline double up(double x) { return std::nextafter(x, HUGE_VAL); }
inline double down(double x) { return std::nextafter(x, -HUGE_VAL); }

inline const Viewpoint kOrigin = Viewpoint::eye({0, 0, 0});

/// A square wall at x = 2, seen from the origin: its shadow is |y|, |z| <= x / 2, and for `surface` x >= 2.
inline const Loop kWall{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}};

inline Rows wall_rows() {
  return rows_of({"wall", kOrigin, kWall, surface},
                 {
                     {"hides", Aabb{{4, -1, -1}, {5, 1, 1}}, inside, filter},
                     {"beside_the_shadow", Aabb{{4, 9, 9}, {5, 10, 10}}, outside, filter},
                     {"before_it", Aabb{{0.5, -0.1, -0.1}, {1, 0.1, 0.1}}, outside, filter},
                     {"across_a_side", Aabb{{4, 1, -1}, {5, 6, 1}}, partial, filter},
                     {"corner_on_side", Aabb{{4, 0, 0}, {5, 2, 1}}, inside, exact},
                     {"corner_one_ulp_beyond_side", Aabb{{4, 0, 0}, {5, up(2), 1}}, partial, exact},
                     {"corner_one_ulp_within_side", Aabb{{4, 0, 0}, {5, down(2), 1}}, inside, exact},
                     {"edge_touches_side_from_outside", Aabb{{3, 2, 0}, {4, 3, 1}}, partial, exact},
                     {"edge_one_ulp_outside_side", Aabb{{3, up(2), 0}, {4, 3, 1}}, outside, exact},
                     {"vertex_touches_corner_ray", Aabb{{3, 2, 2}, {4, 3, 3}}, partial, exact},
                     {"face_on_near_plane", Aabb{{2, -0.5, -0.5}, {3, 0.5, 0.5}}, inside, exact},
                     {"face_on_near_plane_from_before", Aabb{{1, -0.5, -0.5}, {2, 0.5, 0.5}}, partial, exact},
                     {"one_ulp_before_near_plane", Aabb{{1, -0.5, -0.5}, {down(2), 0.5, 0.5}}, outside, exact},
                     {"box_holds_the_eye", Aabb{{-1, -1, -1}, {1, 1, 1}}, outside, filter},
                     {"box_holds_eye_and_wall", Aabb{{-9, -9, -9}, {9, 9, 9}}, partial, filter},
                     {"box_holds_eye_and_touches", Aabb{{-1, -1, -1}, {2, 1, 1}}, partial, exact},
                     {"box_has_a_corner_at_the_eye", Aabb{{0, 0, 0}, {1, 1, 1}}, outside, filter},
                     {"flat_box_inside", Aabb{{4, -1, -1}, {4, 1, 1}}, inside, filter},
                     {"flat_box_is_the_wall", Aabb{{2, -1, -1}, {2, 1, 1}}, inside, exact},
                     {"flat_box_spans_the_shadow", Aabb{{4, -2, -2}, {4, 2, 2}}, inside, exact},
                     {"flat_box_on_side_from_outside", Aabb{{3, 2, -1}, {4, 2, 1}}, partial, exact},
                     {"point_inside", point({4, 0, 0}), inside, filter},
                     {"point_on_corner_ray", point({4, 2, 2}), inside, exact},
                     {"point_one_ulp_off_corner_ray", point({4, up(2), 2}), outside, exact},
                     {"point_at_its_corner", point({2, 1, 1}), inside, exact},
                     {"point_at_the_eye", point({0, 0, 0}), outside, filter},
                     {"needle_past_a_side", Aabb{{8, 4.75, -9}, {9, 5, 9}}, outside, filter},
                     {"needle_touches_a_side", Aabb{{8, 4.5, -9}, {9, 5, 9}}, partial, exact},
                     {"shadow_passes_through_face", Aabb{{10, -50, -50}, {11, 50, 50}}, partial, filter},
                 });
}

/// All four corners of the wall are equally far: the first counts, and the near plane is 2x - y - z = 6.
inline Rows tie_rows() {
  return rows_of({"tie", kOrigin, kWall, farthest},
                 {
                     {"touching", Aabb{{4, -1, -1}, {5, 1, 1}}, inside, exact},
                     {"beyond", Aabb{{4.5, -1, -1}, {5, 1, 1}}, inside, filter},
                     {"cuts_other_corner", Aabb{{2.5, 0.9, 0.9}, {2.6, 1, 1}}, outside, filter},
                     {"corner_itself", point({2, -1, -1}), inside, exact},
                     {"point_on_near_plane", point({3, 0, 0}), inside, exact},
                     {"point_one_ulp_before", point({down(3), 0, 0}), outside, exact},
                 });
}

/// The wall with vertex (2, 1, -1) alone farthest: |(3, 1.5, -1.5)|; the near plane is 6x + 3y - 3z = 27.
inline Rows farthest_rows() {
  return rows_of({"farthest", kOrigin, Loop{{2, -1, -1}, {3, 1.5, -1.5}, {2, 1, 1}, {2, -1, 1}}, farthest},
                 {
                     {"point_on_near_plane", point({4.5, 0, 0}), inside, exact},
                     {"point_one_ulp_before_it", point({down(4.5), 0, 0}), outside, exact},
                     {"edge_reaches_it", Aabb{{2, -0.5, 0}, {4, 0.5, 0.5}}, outside, filter},
                     {"corner_touches_it_from_before", Aabb{{2, -0.5, -1}, {4, 0, 0}}, partial, exact},
                     {"vertex_itself", point({3, 1.5, -1.5}), inside, exact},
                 });
}

/// A wall in the plane x + y + z = 4 with a side along x + y + 5z = 0, and points a hair off them, beyond what twice the
/// precision of a double can tell.
inline Rows hair_rows() {
  constexpr double kHair = 0x1p-100;
  return rows_of({"hair", kOrigin, Loop{{6, -1, -1}, {-1, 6, -1}, {-1, -1, 6}}, surface},
                 {
                     {"on_near_plane", point({2, 2, 0}), inside, exact},
                     {"beyond_near_plane", point({2, 2, kHair}), inside, exact},
                     {"before_near_plane", point({2, 2, -kHair}), outside, exact},
                     {"across_near_plane", Aabb{{2, 2, -kHair}, {2, 2, kHair}}, partial, exact},
                     {"on_side", point({10, 0, -2}), inside, exact},
                     {"within_side", point({10, kHair, -2}), inside, exact},
                     {"beside_side", point({10, -kHair, -2}), outside, exact},
                     {"across_side", Aabb{{10, -kHair, -2}, {10, 0, -2}}, partial, exact},
                 });
}

/// At powers of two the same decisions in the same stages: nothing in the filter has a unit.
inline Rows scaled_rows() {
  Rows rows;
  for (const auto& [name, s] : {std::pair{"scale_2_to_minus_60", 0x1p-60},
                                {"scale_2_to_60", 0x1p60},
                                {"scale_least", 0x1p-100},
                                {"scale_greatest", 0x1p97}}) {
    Loop wall = kWall;
    for (Vec3& v : wall) v = {s * v.x, s * v.y, s * v.z};
    const Rows scaled = rows_of({name, kOrigin, wall, surface},
                                {
                                    {"hides", Aabb{{4 * s, -s, -s}, {5 * s, s, s}}, inside, filter},
                                    {"touches", Aabb{{4 * s, 0, 0}, {5 * s, 2 * s, s}}, inside, exact},
                                    {"one_ulp_beyond", Aabb{{4 * s, 0, 0}, {5 * s, up(2 * s), s}}, partial, exact},
                                    {"one_ulp_outside", Aabb{{3 * s, up(2 * s), 0}, {4 * s, 3 * s, s}}, outside, exact},
                                    {"beside", Aabb{{3 * s, 3 * s, 0}, {4 * s, 4 * s, s}}, outside, filter},
                                });
    rows.insert(rows.end(), scaled.begin(), scaled.end());
  }
  return rows;
}

/// At 4e9 an ulp is 2^-21. Differences to the eye are exact there: the filter is as sharp as at the origin, and an ulp of
/// the coordinates is far more than its bound.
inline Rows offset_rows() {
  constexpr double o = 4e9;
  Loop wall = kWall;
  for (Vec3& v : wall) v = {v.x + o, v.y + o, v.z + o};
  return rows_of({"offset_4e9", Viewpoint::eye({o, o, o}), wall, surface},
                 {
                     {"touches", Aabb{{o + 4, o, o}, {o + 5, o + 2, o + 1}}, inside, exact},
                     {"one_ulp_beyond", Aabb{{o + 4, o, o}, {o + 5, up(o + 2), o + 1}}, partial, filter},
                     {"one_ulp_within", Aabb{{o + 4, o, o}, {o + 5, down(o + 2), o + 1}}, inside, filter},
                     {"one_ulp_outside", Aabb{{o + 3, up(o + 2), o}, {o + 4, o + 3, o + 1}}, outside, filter},
                     {"point_on_corner_ray", point({o + 4, o + 2, o + 2}), inside, exact},
                 });
}

/// Vertices (i, i^2), i = -31 .. 32, of a parabola at x = 2: at x = 4 the shadow is bounded by the chords of z = y^2 / 2
/// between (2i, 2i^2) and (2i + 2, 2(i + 1)^2). Their middles are at y = 2i + 1, z = 2i^2 + 2i + 1, the parabola there at
/// z - 1/2: what lies between a chord and the parabola is hidden by no approximation with fewer sides and is not hidden.
inline Rows many_sided_rows(const std::vector<int>& sides) {
  Loop parabola;
  for (int i = -31; i <= 32; ++i) parabola.push_back({2, static_cast<double>(i), static_cast<double>(i * i)});
  Rows rows;
  for (const int i : sides) {
    const double y = 2 * i + 1, z = 2 * i * i + 2 * i + 1;
    const Rows at_side = rows_of({"side_" + std::to_string(i + 32) + "_of_64", kOrigin, parabola, surface},
                                 {
                                     {"touched", point({4, y, z}), inside, exact},
                                     {"touched_from_outside", Aabb{{4, y, z - 0.5}, {4, y, z}}, partial, exact},
                                     {"and_parabola", point({4, y, z - 0.25}), outside, filter},
                                     {"within", point({4, y, z + 0.25}), inside, filter},
                                 });
    rows.insert(rows.end(), at_side.begin(), at_side.end());
  }
  // The last side, z = y + 992 at x = 2, closes the loop.
  const Rows last =
      rows_of({"side_64_of_64", kOrigin, parabola, surface}, {
                                                                 {"touched", point({4, 0, 1984}), inside, exact},
                                                                 {"beyond", point({4, 0, 1984.25}), outside, filter},
                                                             });
  rows.insert(rows.end(), last.begin(), last.end());
  return rows;
}

/// The corner (1, 1) of the wall cut off by d: the shadow ends at y + z = x (2 - d) / 2. The short edge's plane is scaled
/// to its own size, so the filter tells a part of d at once.
inline Rows short_edge_rows(const std::string& name, double d, bool is_sum_exact) {
  const double c = 1 - d;
  Rows rows = rows_of({name, kOrigin, Loop{{2, -1, -1}, {2, 1, -1}, {2, 1, c}, {2, c, 1}, {2, -1, 1}}, surface},
                      {
                          // It is on two other sides as well, and these come first.
                          {"cut_off_corner", point({4, 2, 2}), outside, exact},
                          {"cut_off", point({4, 2 - d / 2, 2 - d / 2}), outside, filter},
                          {"one_end", point({4, 2, 2 * c}), inside, exact},
                          {"other_end", point({4, 2 * c, 2}), inside, exact},
                          {"within", point({4, 2 * c, 2 * c}), inside, filter},
                          {"crossed", Aabb{{4, 2 * c, 2 * c}, {4, 2, 2}}, partial, exact},
                      });
  if (!is_sum_exact) return rows;
  const Rows middle = rows_of({name, kOrigin, Loop{{2, -1, -1}, {2, 1, -1}, {2, 1, c}, {2, c, 1}, {2, -1, 1}}, surface},
                              {
                                  {"middle", point({4, 2 - d, 2 - d}), inside, exact},
                                  {"middle_one_ulp_out", point({4, 2 - d, up(2 - d)}), outside, exact},
                              });
  rows.insert(rows.end(), middle.begin(), middle.end());
  return rows;
}

/// The first vertex lies on an edge: it is no corner.
inline Rows collinear_rows() {
  const Loop wall{{2, 0, -1}, {2, 0, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}, {2, -1, -1}};
  Rows rows = rows_of({"collinear_first_vertex", kOrigin, wall, surface},
                      {
                          {"itself", point({2, 0, -1}), inside, exact},
                          {"side_touched_behind_it", Aabb{{4, -1, -2}, {5, 1, 0}}, inside, exact},
                          {"one_ulp_beyond_behind_it", Aabb{{4, -1, down(-2)}, {5, 1, 0}}, partial, exact},
                          {"touched_behind_it_from_outside", Aabb{{3, -1, -3}, {4, 1, -2}}, partial, exact},
                      });
  // The loop of farthest_rows() from the middle of an edge: the near plane stays 6x + 3y - 3z = 27.
  const Loop bent{{2.5, 0.25, -1.25}, {3, 1.5, -1.5}, {2, 1, 1}, {2, -1, 1}, {2, -1, -1}};
  const Rows by_farthest = rows_of({"collinear_first_vertex_farthest", kOrigin, bent, farthest},
                                   {
                                       {"itself", point({2.5, 0.25, -1.25}), outside, filter},
                                       {"point_on_near_plane", point({4.5, 0, 0}), inside, exact},
                                       {"point_one_ulp_before_it", point({down(4.5), 0, 0}), outside, exact},
                                   });
  rows.insert(rows.end(), by_farthest.begin(), by_farthest.end());
  return rows;
}

/// The shadow of a diamond is |y| + |z| <= x / 2. At x = 4 the box lies beyond the corner at y = 2, but each of the two
/// planes through that corner has a corner of the box on its inner side: only an edge of the shadow can part them.
inline Rows edge_rows() {
  return rows_of({"diamond", kOrigin, Loop{{2, 1, 0}, {2, 0, 1}, {2, -1, 0}, {2, 0, -1}}, surface},
                 {
                     {"parted_by_no_plane", Aabb{{4, 2.125, -1}, {4, 3, 1}}, outside, filter},
                     {"edge_touches_edge", Aabb{{4, 2, -1}, {4, 3, 1}}, partial, exact},
                     {"edge_one_ulp_from_edge", Aabb{{4, up(2), -1}, {4, 3, 1}}, outside, exact},
                     {"edge_crosses_face", Aabb{{4, 1.5, -1}, {4, 3, 1}}, partial, filter},
                 });
}

/// A ceiling that surrounds the vertical: rays to its corners leave in all directions, and its near plane, through
/// (-100, -100, 1), is -100 x - 100 y + z = 20001.
inline Rows ceiling_rows() {
  const Loop loop{{-100, -100, 1}, {100, -100, 1}, {100, 100, 1}, {-100, 100, 1}};
  return rows_of({"ceiling", kOrigin, loop, farthest},
                 {
                     {"below_near_plane", point({0, 0, 20000}), outside, filter},
                     {"on_near_plane", point({0, 0, 20001}), inside, exact},
                     {"column_from_the_eye", Aabb{{0, 0, 0}, {1, 1, 30000}}, partial, exact},
                     {"far_behind", Aabb{{-30000, -30000, 400}, {-29999, -29999, 401}}, inside, filter},
                 });
}

/// Oriented boxes behind the wall, about (c, 0, 0) unless said otherwise. The half edges (3, 4) and (-4, 3) make corners
/// (7, 1), (-1, 7), (-7, -1), (1, -7) about the centre: y - x / 2 gains 7.5, and all is hidden from c = 15 on.
inline Rows rotated_box_rows() {
  const auto box = [](double x, double y) { return Obb{{x, y, 0}, {Vec3{3, 4, 0}, Vec3{-4, 3, 0}, Vec3{0, 0, 1}}}; };
  return rows_of(
      {"rotated_box", kOrigin, kWall, surface},
      {
          {"inside", box(16, 0), inside, filter},
          {"corner_on_side", box(15, 0), inside, exact},
          {"corner_one_ulp_beyond_side", box(down(15), 0), partial, exact},
          // Its upright edges lie along two sides of the shadow: that they do is for the exact stage to see.
          {"across_a_side", box(14, 0), partial, exact},
          {"corner_touches_side_from_outside", box(15, 15), partial, exact},
          {"corner_one_ulp_outside_side", box(15, up(15)), outside, exact},
          {"beside_the_shadow", box(15, 16), outside, filter},
          {"corner_touches_near_plane_from_before", box(-5, 0), partial, exact},
          {"corner_one_ulp_before_near_plane", box(down(-5), 0), outside, exact},
          {"holds_the_eye", Obb{{0, 0, 0}, {Vec3{0.75, 1, 0}, Vec3{-1, 0.75, 0}, Vec3{0, 0, 1}}}, outside, filter},
          {"holds_the_eye_and_touches", Obb{{0, 0, 0}, {Vec3{1, 1, 0}, Vec3{1, -1, 0}, Vec3{0, 0, 1}}}, partial, exact},
          {"holds_eye_and_wall", Obb{{0, 0, 0}, {Vec3{9, 12, 0}, Vec3{-12, 9, 0}, Vec3{0, 0, 9}}}, partial, exact},
      });
}

/// Corners (a + b + g, b + g, g): -y - x / 2 gains 3.5 at (-3, -2, -1), y - x / 2 loses 1.5 at (1, -2, -1).
inline Rows skew_box_rows() {
  const auto box = [](double x, double y) { return Obb{{x, y, 0}, {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{1, 1, 1}}}; };
  return rows_of({"skew_box", kOrigin, kWall, surface},
                 {
                     {"inside", box(8, 0), inside, filter},
                     {"corner_on_side", box(7, 0), inside, exact},
                     {"corner_one_ulp_beyond_side", box(down(7), 0), partial, exact},
                     {"across_a_side", box(6, 0), partial, filter},
                     {"corner_touches_side_from_outside", box(4, 3.5), partial, exact},
                     {"corner_one_ulp_outside_side", box(4, up(3.5)), outside, exact},
                     {"corner_touches_near_plane_from_before", box(-1, -1.5), partial, exact},
                     {"corner_one_ulp_before_near_plane", box(down(-1), -1.5), outside, exact},
                 });
}

/// Boxes with half edges that are zero or depend on each other.
inline Rows thin_box_rows() {
  const auto flat = [](double x, double z) { return Obb{{x, 0, z}, {Vec3{3, 4, 0}, Vec3{-4, 3, 0}, Vec3{}}}; };
  const auto needle = [](double x) { return Obb{{x, 0, 0}, {Vec3{3, 4, 0}, Vec3{}, Vec3{}}}; };
  const auto across_ray = [](double y) { return Obb{{4, y, 2}, {Vec3{}, Vec3{0, 1, -1}, Vec3{}}}; };
  const auto spot = [](double y, double z) { return Obb{{4, y, z}, {}}; };
  // {(3, 6) a, b} in (x, y) and z: the segments of both half edges along (1, 2) add up.
  const auto plate = [](double x) { return Obb{{x, 0, 0}, {Vec3{1, 2, 0}, Vec3{2, 4, 0}, Vec3{0, 0, 1}}}; };
  const auto line = [](double x) { return Obb{{x, 1, 0}, {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{2, 0, 0}}}; };
  return rows_of({"thin_box", kOrigin, kWall, surface},
                 {
                     {"flat_inside", flat(16, 0), inside, filter},
                     {"flat_corner_on_two_sides", flat(15, 4), inside, exact},
                     {"flat_corner_one_ulp_beyond", flat(15, up(4)), partial, exact},
                     {"flat_outside", flat(16, 12), outside, filter},
                     {"flat_touches_from_outside", flat(15, 11), partial, exact},
                     {"needle_inside", needle(12), inside, filter},
                     {"needle_end_on_side", needle(11), inside, exact},
                     {"needle_end_one_ulp_beyond", needle(down(11)), partial, exact},
                     // Its ends are (4, 3, 1) and (4, 1, 3), its middle is on the ray through (4, 2, 2).
                     {"needle_across_ray_touches", across_ray(2), partial, exact},
                     {"needle_across_ray_one_ulp_off", across_ray(up(2)), outside, exact},
                     {"point_inside", spot(0, 0), inside, filter},
                     {"point_on_corner_ray", spot(2, 2), inside, exact},
                     {"point_one_ulp_off_corner_ray", spot(2, up(2)), outside, exact},
                     {"dependent_plate_inside", plate(16), inside, filter},
                     {"dependent_plate_on_side", plate(15), inside, exact},
                     {"dependent_plate_one_ulp_beyond", plate(down(15)), partial, exact},
                     {"dependent_line_from_wall_edge", line(6), inside, exact},
                     {"dependent_line_one_ulp_before", line(down(6)), partial, exact},
                     {"dependent_line_ends_at_wall_edge", line(-2), partial, exact},
                 });
}

/// [2, 4] x [-1, 1]^2: from the origin only the face at x = 2 is turned to the eye, so its shadow is the wall's.
inline Rows cube_rows(const std::string& form_name, CubeForm form) {
  const Polytope ahead = cube({2, -1, -1}, form);
  Rows rows = rows_of(
      {form_name + "_ahead", kOrigin, ahead, surface},
      {
          {"itself", Aabb{{2, -1, -1}, {4, 1, 1}}, inside, exact},
          {"within_it", Aabb{{2.5, -1, -1}, {3, 1, 1}}, inside, filter},
          {"corner_on_side", Aabb{{4, 0, 0}, {5, 2, 1}}, inside, exact},
          {"corner_one_ulp_beyond_side", Aabb{{4, 0, 0}, {5, up(2), 1}}, partial, exact},
          {"touches_front_from_before", Aabb{{1, -0.5, -0.5}, {2, 0.5, 0.5}}, partial, exact},
          {"one_ulp_before_front", Aabb{{1, -0.5, -0.5}, {down(2), 0.5, 0.5}}, outside, exact},
          {"beside_it_in_its_shadow", Aabb{{4, 1, 1}, {5, 1.5, 1.5}}, inside, filter},
          {"rotated_box_corner_on_side", Obb{{15, 0, 0}, {Vec3{3, 4, 0}, Vec3{-4, 3, 0}, Vec3{0, 0, 1}}}, inside, exact},
      });
  const auto add = [&](const Setting& setting, const std::vector<Entry>& entries) {
    const Rows more = rows_of(setting, entries);
    rows.insert(rows.end(), more.begin(), more.end());
  };
  // As for the wall, the first of four equally far vertices of the silhouette counts: 2x - y - z = 6.
  add({form_name + "_ahead_farthest", kOrigin, ahead, farthest},
      {
          {"touching", Aabb{{4, -1, -1}, {5, 1, 1}}, inside, exact},
          {"part_of_the_cube_before_it", point({2, 1, 1}), outside, filter},
      });

  // [2, 4]^2 x [-1, 1]: the faces at x = 2 and y = 2 are turned to the eye; the shadow is |z| <= x / 2, |z| <= y / 2,
  // x / 2 <= y <= 2x, x >= 2, y >= 2, its silhouette a hexagon.
  const Polytope corner = cube({2, 2, -1}, form);
  add({form_name + "_across", kOrigin, corner, surface},
      {
          {"within_it", Aabb{{3, 3, -1}, {4, 4, 1}}, inside, filter},
          {"both_tops_touched", Aabb{{4, 4, -2}, {6, 6, 2}}, inside, exact},
          {"top_one_ulp_beyond", Aabb{{4, 4, -2}, {6, 6, up(2)}}, partial, exact},
          {"front_edge_touched", Aabb{{1, 1, 0}, {2, 2, 0.5}}, partial, exact},
          {"front_edge_one_ulp_missed", Aabb{{1, 1, 0}, {down(2), down(2), 0.5}}, outside, exact},
          {"front_face_touched", Aabb{{1, 3, 0}, {2, 4, 0.5}}, partial, exact},
          {"corner_nearest_the_eye", point({2, 2, 1}), inside, exact},
          {"before_one_front_face", point({1.5, 2.5, 0}), outside, filter},
          {"side_touched_from_outside", Aabb{{5, 1, 0}, {6, 3, 0.5}}, partial, exact},
      });
  // Of the silhouette (2, 4, -1) and (4, 2, -1) come first, by the order of the vertices (4, 2, -1): 4x + 2y - z = 21.
  add({form_name + "_across_farthest", kOrigin, corner, farthest},
      {
          {"farthest_vertex", point({4, 2, -1}), inside, exact},
          {"point_on_near_plane", point({4, 3, 1}), inside, exact},
          {"point_one_ulp_before", point({4, 3, up(1)}), outside, exact},
          {"cube_reaches_across", Aabb{{2, 2, -1}, {4, 4, 1}}, partial, exact},
      });

  // The eye in the plane of the face at y = 1, which is then not turned to it: 1 - x <= y <= 1, |z| <= x / 2.
  add({form_name + "_eye_on_face_plane", Viewpoint::eye({0, 1, 0}), ahead, surface},
      {
          {"touched_inside", Aabb{{3, 0, 0}, {4, 1, 1}}, inside, exact},
          {"touched_outside", Aabb{{3, 1, 0}, {4, 2, 1}}, partial, exact},
          {"one_ulp_outside", Aabb{{3, up(1), 0}, {4, 2, 1}}, outside, exact},
          {"other_side_touched", Aabb{{3, -2, -1}, {4, 0, 1}}, inside, exact},
      });
  // For `farthest` the first of the front face's farthest vertices is (2, -1, -1), 2x - 2y - z = 7; the face seen edge-on
  // would have farther ones.
  add({form_name + "_eye_on_face_plane_farthest", Viewpoint::eye({0, 1, 0}), ahead, farthest},
      {
          {"point_on_near_plane", point({4, 0.5, 0}), inside, exact},
          {"point_one_ulp_before", point({down(4), 0.5, 0}), outside, exact},
      });
  // The eye on the line of the edge y = z = 1, between two faces seen edge-on: 1 - x <= y <= 1, 1 - x <= z <= 1.
  add({form_name + "_eye_on_edge_line", Viewpoint::eye({0, 1, 1}), ahead, surface},
      {
          {"edge_prolonged", Aabb{{3, 1, 1}, {9, 1, 1}}, inside, exact},
          {"touched_along_the_edge", Aabb{{3, 1, 1}, {4, 2, 2}}, partial, exact},
          {"one_ulp_outside", Aabb{{3, up(1), 1}, {4, 2, 2}}, outside, exact},
          {"inside", Aabb{{3, 0, 0}, {4, 0.5, 0.5}}, inside, filter},
      });

  // Seen along x four faces are edge-on and the shadow is the prism of the front face; along (1, 1, 0) the faces at x = 2
  // and y = -1 are turned: -5 <= y - x <= -1, |z| <= 1, x >= 2, y >= -1.
  add({form_name + "_along_x", Viewpoint::direction({1, 0, 0}), ahead, surface},
      {
          {"itself", Aabb{{2, -1, -1}, {4, 1, 1}}, inside, exact},
          {"touched_outside", Aabb{{3, 1, -1}, {4, 2, 1}}, partial, exact},
          {"one_ulp_outside", Aabb{{3, up(1), -1}, {4, 2, 1}}, outside, exact},
      });
  add({form_name + "_along_x_farthest", Viewpoint::direction({1, 0, 0}), ahead, farthest},
      {
          {"itself", Aabb{{2, -1, -1}, {4, 1, 1}}, inside, exact},
          {"one_ulp_before_front", Aabb{{1, -0.5, -0.5}, {down(2), 0.5, 0.5}}, outside, exact},
      });
  add({form_name + "_along_a_diagonal", Viewpoint::direction({1, 1, 0}), ahead, surface},
      {
          {"itself", Aabb{{2, -1, -1}, {4, 1, 1}}, inside, exact},
          {"both_sides_touched", Aabb{{5, 1, -1}, {6, 4, 1}}, inside, exact},
          {"side_one_ulp_beyond", Aabb{{5, 1, -1}, {6, up(4), 1}}, partial, exact},
          {"front_edge_touched", Aabb{{0, -3, -1}, {2, -1, 1}}, partial, exact},
          {"front_edge_one_ulp_missed", Aabb{{0, -3, -1}, {2, down(-1), 1}}, outside, exact},
      });
  return rows;
}

/// Long to both sides, along the rays: its values at the planes are small differences of numbers as large as it is long, of
/// planes whose coefficients round. The middle is just beside the shadow.
inline Rows long_box_rows() {
  const Vec3 along{-41943040, -41943040, 58720256};
  const auto box = [](const Vec3& a, const Vec3& b, const Vec3& c) { return Obb{{-496.25, -491, 696}, {a, b, c}}; };
  return rows_of({"long_box", Viewpoint::direction({-5, -5, 7}),
                  Loop{{7.000000000000002, 8.000000000000002, -4}, {3, 8, -4}, {6, 12, -3.9999999999999996}}, surface},
                 {
                     {"beside_the_shadow_by_its_first_half_edge", box(along, {}, {}), outside, exact},
                     {"beside_the_shadow_by_its_second_half_edge", box({}, along, {}), outside, exact},
                     {"beside_the_shadow_by_its_third_half_edge", box({}, {}, along), outside, exact},
                 });
}

/// The wall seen along x: the prism |y|, |z| <= 1; along (1, 1, 0): -3 <= y - x <= -1, |z| <= 1, for `farthest` from
/// (2, 1, -1) on: x + y >= 3.
inline Rows direction_rows() {
  const auto rotated = [](double y) { return Obb{{4, y, 0}, {Vec3{0, 0.375, 0.5}, Vec3{0, -0.5, 0.375}, Vec3{1, 0, 0}}}; };
  Rows rows = rows_of({"along_x", Viewpoint::direction({1, 0, 0}), kWall, surface},
                      {
                          {"touches_four_sides", Aabb{{1e6, -1, -1}, {2e6, 1, 1}}, inside, exact},
                          {"inside", Aabb{{3, -0.5, -0.5}, {4, 0.5, 0.5}}, inside, filter},
                          {"one_ulp_beyond", Aabb{{3, -1, -1}, {4, up(1), 1}}, partial, exact},
                          {"touches_from_outside", Aabb{{3, 1, -1}, {4, 2, 1}}, partial, exact},
                          {"one_ulp_before", Aabb{{1, -1, -1}, {down(2), 1, 1}}, outside, exact},
                          {"point_on_its_edge", point({3, 1, 1}), inside, exact},
                          {"rotated_box_corner_on_side", rotated(0.125), inside, exact},
                          {"rotated_box_one_ulp_beyond", rotated(up(0.125)), partial, exact},
                          {"rotated_box_touches_from_outside", rotated(1.875), partial, exact},
                      });
  const auto add = [&](const Setting& setting, const std::vector<Entry>& entries) {
    const Rows more = rows_of(setting, entries);
    rows.insert(rows.end(), more.begin(), more.end());
  };
  add({"along_a_diagonal", Viewpoint::direction({1, 1, 0}), kWall, surface},
      {
          {"point_on_side", point({3, 2, 1}), inside, exact},
          {"point_one_ulp_off_side", point({3, up(2), 1}), outside, exact},
          {"flat_box_touches_four_sides", Aabb{{4, 1, -1}, {4, 3, 1}}, inside, exact},
          {"flat_box_beyond_a_corner", Aabb{{4, 1, -1}, {4, 3.5, 1}}, partial, exact},
      });
  add({"along_a_diagonal_farthest", Viewpoint::direction({1, 1, 0}), kWall, farthest},
      {
          {"point_on_near_plane", point({3, 0, 0}), inside, exact},
          {"point_one_ulp_before", point({down(3), 0, 0}), outside, exact},
          {"wall_reaches_it", Aabb{{2, -1, -1}, {2, 1, 1}}, partial, exact},
          {"wall_without_its_edge", Aabb{{2, -1, -1}, {2, 0.5, 1}}, outside, filter},
      });
  return rows;
}

}  // namespace degenerate

inline std::vector<DegenerateRow> degenerate_rows() {
  using namespace degenerate;
  Rows rows;
  for (const Rows& group : {wall_rows(),
                            tie_rows(),
                            farthest_rows(),
                            hair_rows(),
                            scaled_rows(),
                            offset_rows(),
                            many_sided_rows({-31, -1, 0, 20, 31}),
                            short_edge_rows("edge_of_1e_9", 1e-9, false),
                            short_edge_rows("edge_of_2_to_minus_30", 0x1p-30, true),
                            collinear_rows(),
                            edge_rows(),
                            ceiling_rows(),
                            rotated_box_rows(),
                            skew_box_rows(),
                            thin_box_rows(),
                            cube_rows("cube", CubeForm::quadrilaterals),
                            cube_rows("triangulated_cube", CubeForm::triangles),
                            cube_rows("cube_with_t_junction", CubeForm::with_t_junction),
                            long_box_rows(),
                            direction_rows()}) {
    rows.insert(rows.end(), group.begin(), group.end());
  }
  return rows;
}

}  // namespace occlude
