// SPDX-License-Identifier: MIT
// Cameras near, in and beside their occluders: where other cullers let things vanish.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <vector>

#include "frame/culler_access.h"
#include "frames.h"
#include "occlude/culler/culler.h"
#include "scenes.h"

namespace near_plane_test {

using namespace occlude;
using namespace occlude::culler;

TEST(NearPlane, WhatTheNearPlaneClipsAwayDoesNotHide) {
  PolygonSoup soup;
  add_wall(soup, 0.05, -10, 10, -10, 10);  // nearer than the near plane at 0.1: not drawn, must not hide
  add(soup, {{0.05, -3, -3}, {3, -3, -3}, {3, -3, 3}, {0.05, -3, 3}});  // reaches through the near plane
  add_wall(soup, 5, -1, 1, -1, 1);
  const Culler culler = one_polygon_leaves(soup);
  const CullResult frame = look(culler);
  EXPECT_TRUE(is_drawn(culler, frame, 2));
  for (const Occluder& o : frame.occluders) EXPECT_EQ(original(culler, o), 2U);
}

TEST(NearPlane, EyeWithinAnOccluderPlaneOrBoxIsHarmless) {
  PolygonSoup soup;
  add(soup, {{-1, -1, 0}, {9, -1, 0}, {9, 1, 0}, {-1, 1, 0}});    // the eye lies on it
  add(soup, {{-1, -1, -1}, {9, 1, -1}, {9, 1, 1}, {-1, -1, 1}});  // the eye lies in its box
  add_wall(soup, 20, -1, 1, -1, 1);
  const Culler culler = one_polygon_leaves(soup);
  EXPECT_TRUE(is_drawn(culler, look(culler), 0));
  EXPECT_TRUE(is_drawn(culler, look(culler), 2));
}

/// For each polygon of the input, whether it is drawn.
std::vector<bool> drawn_of(const Culler& culler, const CullResult& frame) {
  const std::vector<bool> in_order = drawn_polygons(culler, frame);
  std::vector<bool> drawn(in_order.size());
  for (std::uint32_t p = 0; p < drawn.size(); ++p) drawn[culler.hierarchy().original(p)] = in_order[p];
  return drawn;
}

Culler far_reaching(const PolygonSoup& soup) {
  return Culler(soup, {.hierarchy = {.leaf_size = 1}, .lists = {.threshold = 1e-6, .regions = 1}});
}

std::size_t shells_in_use(const Culler& culler, const CullResult& frame) {
  return static_cast<std::size_t>(
      std::ranges::count_if(frame.occluders, [&](const Occluder& o) { return occluders_of(culler).is_shell(o.index); }));
}

/// OpenSceneGraph culls what is seen through the part of an occluder that the near plane cuts away. One corner is enough.
TEST(NearPlane, APolygonThatItCutsHidesNothing) {
  for (const double corner : {0.05, 0.0999, -3.0}) {
    PolygonSoup soup;
    add(soup, {{2, -2, -2}, {2, 2, -2}, {2, 2, 2}, {corner, -2, 2}});
    add_wall(soup, 9, -1, 1, -1, 1);
    const Culler culler = far_reaching(soup);
    EXPECT_TRUE(is_drawn(culler, look(culler), 1)) << "corner at " << corner;
  }
  PolygonSoup soup;  // and it hides as soon as it is whole
  add(soup, {{2, -2, -2}, {2, 2, -2}, {2, 2, 2}, {0.11, -2, 2}});
  add_wall(soup, 9, -1, 1, -1, 1);
  const Culler culler = far_reaching(soup);
  EXPECT_FALSE(is_drawn(culler, look(culler), 1));
}

/// Whether a renderer clips a corner that is far beside the eye and almost on the near plane depends on its rounding.
TEST(NearPlane, APolygonThatRoundingMayCutHidesNothing) {
  const auto hides = [](double depth) {
    PolygonSoup soup;
    add(soup, {{2, -2, -2}, {2, 2, -2}, {2, 2, 2}, {depth, -3e4, 2}});
    add_wall(soup, 9, -1, 1, -1, 1);
    const Culler culler = far_reaching(soup);
    return !is_drawn(culler, look(culler), 1);
  };
  EXPECT_FALSE(hides(0.12));
  EXPECT_TRUE(hides(0.13)) << "2^-20 of the depth beyond the near plane";
}

/// A renderer in single precision moves vertices by a share of the model's depth, here by 1e-4 or more. What is so little
/// before the near plane may be drawn, and what is so little beyond it may be clipped.
TEST(NearPlane, RoundingGrowsWithTheModel) {
  for (const double off : {1e-6, 1e-5, 1e-4}) {
    PolygonSoup soup;
    add_wall(soup, 0.1 - off, -0.01, 0.01, -0.01, 0.01);
    add_wall(soup, -1000, -1, 1, -1, 1);
    EXPECT_TRUE(is_drawn(far_reaching(soup), look(far_reaching(soup)), 0)) << off << " before the near plane";
    add_wall(soup, 0.1 + off, -5, 5, -5, 5);
    add_wall(soup, 5, -1, 1, -1, 1);
    EXPECT_TRUE(is_drawn(far_reaching(soup), look(far_reaching(soup)), 3)) << off << " beyond the near plane";
  }
}

/// A prism along y over a triangle in x and z that has one corner at (tip, tip).
void add_prism(PolygonSoup& soup, double tip) {
  std::array<std::uint32_t, 6> v{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double y = i == 0 ? -4 : 4;
    v[3 * i] = soup.add_vertex({tip, y, tip});
    v[3 * i + 1] = soup.add_vertex({3, y, -3});
    v[3 * i + 2] = soup.add_vertex({3, y, -1.5});
  }
  soup.add_polygon(std::array{v[0], v[1], v[2]});
  soup.add_polygon(std::array{v[5], v[4], v[3]});
  for (std::size_t i = 0; i < 3; ++i) soup.add_polygon(std::array{v[i], v[i + 3], v[(i + 1) % 3 + 3], v[(i + 1) % 3]});
}

/// A tetrahedron with one corner near the eye.
void add_needle(PolygonSoup& soup, double tip) {
  const std::array v{soup.add_vertex({tip, 0, tip}), soup.add_vertex({5, -2, -4}), soup.add_vertex({5, 2, -4}),
                     soup.add_vertex({5, 0, -3})};
  for (const std::array<std::size_t, 3>& face : {std::array<std::size_t, 3>{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}) {
    soup.add_polygon(std::array{v[face[0]], v[face[1]], v[face[2]]});
  }
}

/// Torque leaves this to be done. A ray upwards passes the shell only near its tip, before the near plane, and reaches what
/// is behind.
TEST(NearPlane, APolytopeThatItCutsHidesNothing) {
  for (const auto add_shell : {add_prism, add_needle}) {
    for (const bool is_cut : {false, true}) {
      PolygonSoup soup;
      add_shell(soup, is_cut ? 0.05 : 0.2);
      const auto behind = static_cast<std::uint32_t>(soup.size());
      add_wall(soup, 30, -0.3, 0.3, 26.8, 27.2);
      const Culler culler = far_reaching(soup);
      ASSERT_EQ(occluders_of(culler).shells().size(), 1U);
      Camera camera;
      camera.fov_y_deg = 120;
      const CullResult frame = culler.cull(camera, {.method = Method::frusta});
      EXPECT_EQ(shells_in_use(culler, frame), is_cut ? 0U : 1U);
      EXPECT_EQ(is_drawn(culler, frame, behind), is_cut);
    }
  }
}

/// In the Third Person Shooter demo of Godot everything disappears when the camera enters an occluder.
TEST(NearPlane, NothingDisappearsForACameraInAShell) {
  PolygonSoup soup;
  soup.add_box({-3, -3, -3}, {3, 3, 3});
  for (int i = 0; i < 8; ++i) add_wall(soup, -2 + 0.5 * i, -0.5, 0.5, -0.5, 0.5);
  const auto outside = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 9, -1, 1, -1, 1);
  const Culler culler = far_reaching(soup);
  View view;
  std::size_t seen = 0;
  for (int step = 0; step <= 400; ++step) {  // from in front of the shell through its walls and out behind
    Camera camera;
    camera.eye = {-6 + 0.03 * step, 0.01, 0.02};
    camera.target = camera.eye + glm::dvec3{1, 0, 0};
    const CullResult& frame = culler.cull(camera, {.method = Method::frusta}, view);
    const std::vector<bool> drawn = drawn_of(culler, frame);
    const bool is_inside = std::fabs(camera.eye.x) < 3;
    if (camera.eye.x < -3) {
      const bool is_clipped = camera.eye.x > -3.11;
      EXPECT_TRUE(is_clipped || shells_in_use(culler, frame) == 1) << "eye at " << camera.eye.x;
      continue;
    }
    EXPECT_EQ(shells_in_use(culler, frame), 0U) << "eye at " << camera.eye.x;
    // The first thing in front of the camera is seen: a wall in the shell, the far wall of the shell, or what is outside.
    const double depth = camera.eye.x + camera.near_plane;
    std::size_t first = is_inside ? 1 : outside;
    for (std::size_t p = outside; p-- > 6;) {
      if (soup.vertices[soup.loop(p)[0]].x > depth) first = p;
    }
    EXPECT_TRUE(drawn[first] || soup.vertices[soup.loop(first)[0]].x <= depth) << "eye at " << camera.eye.x;
    ++seen;
  }
  EXPECT_GT(seen, 250U);
}

/// The eye is in front of the slope that cuts off a corner of the shell's box: inside the box, and outside the shell.
TEST(NearPlane, NothingDisappearsForACameraInTheBoxOfAShell) {
  PolygonSoup soup;
  const std::array v{soup.add_vertex({2, -4, 0}), soup.add_vertex({10, -4, 0}), soup.add_vertex({10, -4, 8}),
                     soup.add_vertex({2, 4, 0}),  soup.add_vertex({10, 4, 0}),  soup.add_vertex({10, 4, 8})};
  soup.add_polygon(std::array{v[0], v[1], v[2]});
  soup.add_polygon(std::array{v[5], v[4], v[3]});
  soup.add_polygon(std::array{v[0], v[3], v[4], v[1]});
  soup.add_polygon(std::array{v[1], v[4], v[5], v[2]});
  soup.add_polygon(std::array{v[2], v[5], v[3], v[0]});  // the slope, z = x - 2
  add(soup, {{6, -1, 6.5}, {7, -1, 7.5}, {7, 1, 7.5}, {6, 1, 6.5}});
  add_wall(soup, 13, -1, 1, -3, -2);
  const Culler culler = far_reaching(soup);
  ASSERT_EQ(occluders_of(culler).shells().size(), 1U);
  Camera camera;
  camera.eye = {3, 0, 7.5};
  camera.target = {4, 0, 6.5};
  camera.fov_y_deg = 120;
  const CullResult frame = culler.cull(camera, {.method = Method::frusta});
  EXPECT_EQ(shells_in_use(culler, frame), 1U);
  EXPECT_TRUE(is_drawn(culler, frame, 4)) << "the slope";
  EXPECT_TRUE(is_drawn(culler, frame, 5)) << "what is before it";
  EXPECT_FALSE(is_drawn(culler, frame, 6)) << "what is behind";
}

/// Other cullers decide by the camera's forward vector which side of an occluder is its front. A wall beside the line of
/// sight that turns away from it shows the eye its front, and the forward vector its back.
TEST(Facing, IsDecidedByTheSideOfTheEye) {
  for (const double sign : {1.0, -1.0}) {
    PolygonSoup soup;
    add(soup, {{3, sign * 4, -9}, {9, sign * 6, -9}, {9, sign * 6, 9}, {3, sign * 4, 9}});
    add(soup, {{6, sign * 6, -1}, {6.5, sign * 6.5, -1}, {6.5, sign * 6.5, 1}, {6, sign * 6, 1}});
    add(soup, {{3.5, sign * 3.5, -1}, {3.6, sign * 3.6, -1}, {3.6, sign * 3.6, 1}, {3.5, sign * 3.5, 1}});
    const glm::dvec3 &p = soup.vertices[0], &q = soup.vertices[1];
    const glm::dvec3 away = glm::cross(q - p, glm::dvec3{0, 0, 1});
    ASSERT_LT(glm::dot(away, p) * glm::dot(away, glm::dvec3{1, 0, 0}), 0);
    const Culler culler = far_reaching(soup);
    Camera camera;
    camera.fov_y_deg = 120;
    const CullResult frame = culler.cull(camera, {.method = Method::frusta, .occluders = 1});
    ASSERT_EQ(frame.occluders.size(), 1U);
    ASSERT_EQ(original(culler, frame.occluders[0]), 0U);
    EXPECT_FALSE(is_drawn(culler, frame, 1)) << "behind the wall, side " << sign;
    EXPECT_TRUE(is_drawn(culler, frame, 2)) << "before it, side " << sign;
  }
}

/// A shell beside the line of sight shows the eye faces that point forward, as the camera does.
TEST(Facing, OfAShellBesideTheLineOfSight) {
  PolygonSoup soup;
  soup.add_box({1, 3, -5}, {2, 6, 5});
  const auto beyond = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 5, 14, 15, -1, 1);  // seen through the side at y = 3 and that at x = 1
  const auto beside = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 5, 7, 7.4, -1, 1);  // just before the ray through (2, 3)
  const Culler culler = far_reaching(soup);
  Camera camera;
  camera.fov_y_deg = 160;
  const CullResult frame = culler.cull(camera, {.method = Method::frusta, .occluders = 1});
  EXPECT_EQ(shells_in_use(culler, frame), 1U);
  EXPECT_FALSE(is_drawn(culler, frame, beyond));
  EXPECT_TRUE(is_drawn(culler, frame, beside));
}

/// In Godot an object vanishes when an opening touches the edge of the picture, or a large occluder is near that.
TEST(PictureEdge, AnOpeningThatTouchesItStaysOpen) {
  // The left border of the picture is y = x; the wall leaves a slit at it.
  for (const double slit : {0x1p-1, 0x1p-20, 0x1p-40}) {
    PolygonSoup soup;
    add_wall(soup, 4, -40, 4 - slit, -40, 40);
    const auto through = static_cast<std::uint32_t>(soup.size());
    add(soup, {{8, 7.9, -0.1}, {8, 8 - slit / 2, -0.1}, {8, 8 - slit / 2, 0.1}});
    const auto hidden = static_cast<std::uint32_t>(soup.size());
    add_wall(soup, 8, 0, 1, 0, 1);
    const Culler culler = far_reaching(soup);
    Camera camera;
    camera.fov_y_deg = 90;
    camera.aspect = 1;
    const CullResult frame = culler.cull(camera, {.method = Method::frusta});
    EXPECT_TRUE(is_drawn(culler, frame, through)) << "slit " << slit;
    EXPECT_FALSE(is_drawn(culler, frame, hidden)) << "slit " << slit;
  }
}

TEST(PictureEdge, ALargeOccluderAcrossItHidesWhatIsBehindAlone) {
  PolygonSoup soup;
  add_wall(soup, 4, 2, 4000, -1000, 1000);  // from the middle of the left half to far beyond the picture
  const auto beside = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 8, 3.9, 3.99, -1, 1);
  const auto across = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 8, 3.9, 4.1, -1, 1);
  const auto behind = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 8, 4, 9, -1, 1);
  const Culler culler = far_reaching(soup);
  Camera camera;
  camera.fov_y_deg = 90;
  camera.aspect = 1;
  const CullResult frame = culler.cull(camera, {.method = Method::frusta});
  EXPECT_TRUE(is_drawn(culler, frame, 0));
  EXPECT_TRUE(is_drawn(culler, frame, beside));
  EXPECT_TRUE(is_drawn(culler, frame, across));
  EXPECT_FALSE(is_drawn(culler, frame, behind));
}

/// Godot 113329: with parallel rays, occluders that touch hid what is between them.
TEST(PictureEdge, OrthographicOccludersThatTouchHideNoMoreThanEach) {
  PolygonSoup soup;
  add_wall(soup, 4, -6, 0, -6, 6);
  add_wall(soup, 6, 0, 6, -6, 6);  // another depth; seen along x they touch
  const auto left = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 8, -2, 0, -1, 1);  // to the very border of the left shadow
  const auto across = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 8, -1, 1, -1, 1);
  const auto right = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 8, 0, 2, -1, 1);
  const auto between = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 5, 0, 2, -1, 1);  // behind the left wall's plane, before the right one
  const auto edge = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 8, 5, 5.5, -1, 1);  // at the border of the picture
  const Culler culler = far_reaching(soup);
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.height = 11;
  camera.aspect = 1;
  const CullResult frame = culler.cull(camera, {.method = Method::frusta});
  EXPECT_FALSE(is_drawn(culler, frame, left));
  EXPECT_FALSE(is_drawn(culler, frame, right));
  EXPECT_TRUE(is_drawn(culler, frame, across)) << "hidden by both together, by neither alone";
  EXPECT_TRUE(is_drawn(culler, frame, between));
  EXPECT_FALSE(is_drawn(culler, frame, edge));
}

/// In Panda3D comparisons with NaN cull everything behind the occluder.
TEST(FarPlane, AtInfinityIsNoPlane) {
  PolygonSoup soup;
  add_wall(soup, 2e4, -1e4, 1e4, -1e4, 1e4);
  const auto hidden = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 1e9, -1e8, 1e8, -1e8, 1e8);
  const auto beside = static_cast<std::uint32_t>(soup.size());
  add_wall(soup, 1e9, 5.0e8, 5.1e8, -1e8, 1e8);
  const Culler culler = far_reaching(soup);
  Camera camera;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    camera.projection = projection;
    camera.height = 2e9;
    const CullResult frame = culler.cull(camera, {.method = Method::frusta});
    EXPECT_EQ(frame.view.size(), 5U);
    for (const HalfSpace& h : frame.view) {
      EXPECT_TRUE(std::isfinite(h.normal.x) && std::isfinite(h.normal.y) && std::isfinite(h.normal.z) &&
                  std::isfinite(h.offset));
    }
    EXPECT_EQ(is_drawn(culler, frame, hidden), projection == Projection::orthographic);
    EXPECT_TRUE(is_drawn(culler, frame, beside));
  }
  camera.far_plane = 1e8;
  const CullResult frame = culler.cull(camera, {.method = Method::frusta});
  EXPECT_EQ(frame.view.size(), 6U);
  EXPECT_FALSE(is_drawn(culler, frame, beside));
}

/// A disc with this many corners, perpendicular to the line of sight.
std::vector<glm::dvec3> disc(double x, double radius, int corners) {
  std::vector<glm::dvec3> loop;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    loop.push_back({x, radius * std::cos(angle), radius * std::sin(angle)});
  }
  return loop;
}

/// OpenSceneGraph has one bit for each plane in 32 bits, so it culls what is beside a disc with 64 sides.
TEST(OccluderShape, AllOfMoreThanThirtyTwoSidesCount) {
  constexpr int kCorners = 64;
  PolygonSoup soup;
  add(soup, disc(4, 1, kCorners));
  for (int i = 0; i < kCorners; ++i) {  // one beside each side, one behind it
    const double angle = 2 * std::numbers::pi * (i + 0.5) / kCorners;
    for (const double radius : {2.1, 1.9}) {
      const double y = radius * std::cos(angle), z = radius * std::sin(angle);
      add_wall(soup, 8, y - 0.04, y + 0.04, z - 0.04, z + 0.04);
    }
  }
  const Culler culler = far_reaching(soup);
  const CullResult frame = look(culler, {.method = Method::frusta, .occluders = 1});
  ASSERT_EQ(original(culler, frame.occluders[0]), 0U);
  const std::vector<bool> drawn = drawn_of(culler, frame);
  for (std::size_t p = 1; p < drawn.size(); ++p) EXPECT_EQ(drawn[p], p % 2 == 1) << "polygon " << p;
}

/// Torque drops silhouette edges that are shorter than 0.16, so the shadow grows over the corners that they cut off.
TEST(OccluderShape, ShortEdgesCount) {
  for (const double cut : {0.1, 1e-3, 1e-9}) {
    for (const bool is_shell : {false, true}) {
      PolygonSoup soup;
      const std::vector<glm::dvec2> outline{{-1, -1}, {1, -1}, {1, 1 - cut}, {1 - cut, 1}, {-1, 1}};
      std::array<std::vector<std::uint32_t>, 2> caps;
      for (std::size_t i = 0; i < 2; ++i) {
        for (const glm::dvec2& p : outline) caps[i].push_back(soup.add_vertex({i == 0 ? 4.0 : 4.5, p}));
      }
      soup.add_polygon(std::vector<std::uint32_t>(caps[0].rbegin(), caps[0].rend()));
      if (is_shell) {
        soup.add_polygon(caps[1]);
        for (std::size_t i = 0; i < outline.size(); ++i) {
          const std::size_t next = (i + 1) % outline.size();
          soup.add_polygon(std::array{caps[0][i], caps[0][next], caps[1][next], caps[1][i]});
        }
      }
      const auto cut_off = static_cast<std::uint32_t>(soup.size());
      const double corner = 2 - 0.9 * cut;  // in the shadow of the corner before it was cut off
      add(soup, {{8, corner, corner}, {8, 2, corner}, {8, 2, 2}});
      const auto hidden = static_cast<std::uint32_t>(soup.size());
      add_wall(soup, 8, 1, 1.8, 1, 1.8);
      const Culler culler = far_reaching(soup);
      const CullResult frame = look(culler);
      EXPECT_EQ(shells_in_use(culler, frame), is_shell ? 1U : 0U);
      EXPECT_TRUE(is_drawn(culler, frame, cut_off)) << "cut " << cut;
      EXPECT_FALSE(is_drawn(culler, frame, hidden)) << "cut " << cut;
    }
  }
}

/// In OpenSceneGraph an occluder stops working when its loop begins with a collinear corner, or the scene has another scale.
TEST(OccluderShape, CollinearFirstCornersAndAnyScale) {
  for (const double scale : {1.0, 1e-4, 1e-12, 1e12}) {
    for (const bool is_collinear : {false, true}) {
      PolygonSoup soup;
      std::vector<glm::dvec3> wall{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}};
      if (is_collinear) wall.insert(wall.begin(), {{2, -1, 0.5}, {2, -1, 0}, {2, -1, -0.5}});
      add(soup, wall);
      add_wall(soup, 4, -1.5, 1.5, -1.5, 1.5);
      add_wall(soup, 4.5, -1.5, 2.5, -1.5, 1.5);
      for (glm::dvec3& v : soup.vertices) v *= scale;
      const Culler culler = far_reaching(soup);
      Camera camera;
      camera.near_plane = 0.1 * scale;
      const CullResult frame = culler.cull(camera, {.method = Method::frusta, .occluders = 1});
      ASSERT_EQ(frame.occluders.size(), 1U) << "scale " << scale;
      EXPECT_EQ(original(culler, frame.occluders[0]), 0U);
      EXPECT_EQ(frame.occluders[0].frustum.silhouette().size(), 4U);
      EXPECT_FALSE(is_drawn(culler, frame, 1)) << "scale " << scale << (is_collinear ? ", collinear" : "");
      EXPECT_TRUE(is_drawn(culler, frame, 2)) << "scale " << scale;
    }
  }
}

}  // namespace near_plane_test
