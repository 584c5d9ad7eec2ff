// SPDX-License-Identifier: MIT
// The coarse picture of joined shadows: what it hides is hidden by the kernel's exact answer, and it finds most of what is
// hidden.
#include "cover/cover_buffer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "camera/single_precision.h"
#include "cover/cover_group.h"
#include "cover/cover_triangles.h"
#include "model/bounds.h"
#include "occlude/kernel/cover.h"
#include "scenes.h"

namespace cover_buffer_test {

using namespace occlude;
using namespace occlude::culler;
using Triangle = CoverMesh::Triangle;

constexpr int kWidth = 160, kHeight = 96;

Camera looking_along_x() {
  Camera camera;
  camera.fov_y_deg = 60;
  camera.aspect = 2;
  camera.height = 8;
  return camera;
}

/// Pieces of triangles over shared vertices. Each piece is drawn by itself.
struct Mesh {
  std::vector<glm::dvec3> vertices;
  std::vector<std::vector<Triangle>> pieces;

  std::uint32_t vertex(const glm::dvec3& v) {
    vertices.push_back(v);
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }
};

void add(CoverBuffer& buffer, const std::vector<glm::dvec3>& vertices, const std::vector<Triangle>& triangles,
         std::uint32_t id = 0) {
  PolygonSoup soup;
  soup.vertices = vertices;
  for (const Triangle& triangle : triangles) soup.add_polygon(triangle);
  const CoverTriangles all = CoverTriangles::find(soup);
  CoverGroup group;
  for (std::uint32_t p = 0; p < soup.size(); ++p) group.add(all, p);
  if (!group.is_empty()) buffer.add(group.mesh(all), id);
}

/// Asks the buffer, and the kernel for the exact answer.
class Judge {
 public:
  Judge(const Camera& camera, Mesh mesh, double depth, double margin = 0) : camera_(camera), mesh_(std::move(mesh)) {
    buffer_.begin(FrameView(camera, depth), kWidth, kHeight, margin);
    std::vector<kernel::Cover::Polygon> polygons;
    for (const auto& piece : mesh_.pieces) {
      add(buffer_, mesh_.vertices, piece);
      for (const Triangle& t : piece) {
        polygons.push_back(
            {to_kernel(mesh_.vertices[t[0]]), to_kernel(mesh_.vertices[t[1]]), to_kernel(mesh_.vertices[t[2]])});
      }
    }
    const glm::dvec3 forward = camera.axes().forward;
    const kernel::HalfSpace drawn{to_kernel(forward), -glm::dot(forward, camera.eye) - camera.near_plane};
    cover_ = kernel::Cover::make(camera.viewpoint(), polygons, drawn).cover;
  }

  [[nodiscard]] bool hides(const kernel::Aabb& box) const { return buffer_.hides(box); }
  [[nodiscard]] bool is_hidden(const kernel::Aabb& box) const {
    return kernel::overlap_certified(*cover_, box).relation == kernel::Relation::inside;
  }

 private:
  Camera camera_;
  Mesh mesh_;
  CoverBuffer buffer_;
  std::optional<kernel::Cover> cover_;
};

kernel::Aabb cube(const glm::dvec3& middle, double half) {
  return {to_kernel(middle - glm::dvec3(half)), to_kernel(middle + glm::dvec3(half))};
}

/// A square at x, perpendicular to the line of sight, of four triangles around its middle. EyePoint from the origin it
/// covers the slopes |y|, |z| <= half / x.
Mesh square(double x, double half, std::size_t triangles = 4) {
  Mesh mesh;
  std::array<std::uint32_t, 4> corner{};
  for (std::size_t i = 0; i < 4; ++i) {
    corner[i] = mesh.vertex({x, i == 0 || i == 3 ? -half : half, i < 2 ? -half : half});
  }
  const std::uint32_t middle = mesh.vertex({x, 0, 0});
  mesh.pieces.emplace_back();
  for (std::size_t i = 0; i < triangles; ++i) mesh.pieces[0].push_back({corner[i], corner[(i + 1) % 4], middle});
  return mesh;
}

TEST(CoverBuffer, HidesWhatIsBehindAMesh) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera = looking_along_x();
    camera.projection = projection;
    const Judge judge(camera, square(2, 1), 100);
    EXPECT_TRUE(judge.hides(cube({4, 0, 0}, 0.8))) << "across edges that two triangles share";
    EXPECT_TRUE(judge.hides(cube({2.5, 0.3, 0.4}, 0.4)));
    EXPECT_FALSE(judge.hides(cube({2.1, 0, 0}, 0.1))) << "it touches the mesh";
    EXPECT_FALSE(judge.hides(cube({1.5, 0, 0}, 0.1))) << "before it";
    EXPECT_FALSE(judge.hides(cube({4, 3, 0}, 0.1))) << "beside it";
    EXPECT_FALSE(judge.hides(cube({-4, 0, 0}, 0.1))) << "behind the eye";
    EXPECT_FALSE(judge.hides(cube({0, 0, 0}, 9))) << "about it";
  }
}

TEST(CoverBuffer, AHoleHidesNothing) {
  const Judge judge(looking_along_x(), square(2, 1, 3), 100);
  EXPECT_FALSE(judge.hides(cube({4, 0, 0}, 0.8)));
  EXPECT_TRUE(judge.hides(cube({4, 0, -1}, 0.2)));
}

/// Triangles that go once and an eighth round a corner are one sheet, of which three share an edge.
TEST(CoverBuffer, AnEdgeOfThreeTrianglesIsBorder) {
  constexpr int kRound = 8;
  Mesh mesh;
  const auto rim = [&](int i, double radius) {
    const double angle = 2 * std::numbers::pi * (i + 0.1) / kRound;
    return mesh.vertex({2, radius * std::cos(angle), radius * std::sin(angle)});
  };
  const std::uint32_t middle = mesh.vertex({2, 0, 0});
  std::array<std::uint32_t, kRound> corners{};
  for (int i = 0; i < kRound; ++i) corners[static_cast<std::size_t>(i)] = rim(i, 0.7);
  std::vector<Triangle>& piece = mesh.pieces.emplace_back();
  for (std::size_t i = 0; i < kRound; ++i) piece.push_back({middle, corners[i], corners[(i + 1) % kRound]});
  piece.insert(piece.begin() + 1, {middle, corners[0], rim(1, 1)});
  const Judge judge(looking_along_x(), mesh, 100);
  std::size_t hidden = 0;
  for (double y = -1.9; y < 2; y += 0.1) {
    for (double z = -1.9; z < 2; z += 0.1) {
      const kernel::Aabb box = cube({4, y, z}, 0.04);
      if (!judge.hides(box)) continue;
      ++hidden;
      EXPECT_TRUE(judge.is_hidden(box)) << y << " " << z;
    }
  }
  EXPECT_GT(hidden, 100U);
}

/// Layers add up whichever way they are turned and whatever edges they share.
TEST(CoverBuffer, LayersOfOneMeshDoNotCancel) {
  Mesh mesh = square(2, 1);
  std::vector<Triangle>& piece = mesh.pieces[0];
  piece.insert(piece.end(), piece.begin(), piece.begin() + 4);
  EXPECT_TRUE(Judge(looking_along_x(), mesh, 100).hides(cube({4, 0, 0}, 0.8))) << "each triangle twice";
  for (std::size_t i = 4; i < 8; ++i) std::swap(piece[i][0], piece[i][1]);
  EXPECT_TRUE(Judge(looking_along_x(), mesh, 100).hides(cube({4, 0, 0}, 0.8))) << "and turned over";
  piece.resize(4);
  std::swap(piece[1][0], piece[1][1]);
  std::swap(piece[2][0], piece[2][1]);
  EXPECT_TRUE(Judge(looking_along_x(), mesh, 100).hides(cube({4, 0, 0}, 0.8))) << "turned at random";
}

/// A picture that hangs in front of a wall has a border of its own, and the wall hides across that border.
TEST(CoverBuffer, APictureOnAWallOpensNothing) {
  Mesh mesh = square(2, 1);
  const Mesh picture = square(1.9, 0.4);
  for (const Triangle& t : picture.pieces[0]) {
    Triangle own{};
    for (std::size_t i = 0; i < 3; ++i) own[i] = mesh.vertex(picture.vertices[t[i]]);
    mesh.pieces[0].push_back(own);
  }
  EXPECT_TRUE(Judge(looking_along_x(), mesh, 100).hides(cube({4, 0, 0}, 0.8)));
}

/// The near side of a cube has its own depth, so it hides what is inside the cube.
TEST(CoverBuffer, OfAClosedSurfaceTheNearSideHides) {
  Mesh mesh;
  std::array<std::uint32_t, 8> v{};
  for (unsigned i = 0; i < 8; ++i) v[i] = mesh.vertex({i & 1U ? 6.0 : 4.0, i & 2U ? 1.0 : -1.0, i & 4U ? 1.0 : -1.0});
  mesh.pieces.emplace_back();
  for (const std::array<std::size_t, 4>& f :
       {std::array<std::size_t, 4>{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
    mesh.pieces[0].push_back({v[f[0]], v[f[1]], v[f[2]]});
    mesh.pieces[0].push_back({v[f[0]], v[f[2]], v[f[3]]});
  }
  const Judge judge(looking_along_x(), mesh, 100);
  EXPECT_TRUE(judge.hides(cube({4.5, 0, 0}, 0.3)));
  EXPECT_TRUE(judge.hides(cube({8, 0, 0}, 0.8)));
}

/// With a margin less is hidden, by that much in the picture.
/// Two walls, one a little behind the other, that overlap by less than what the eyes move their borders by as seen from the
/// layer of the box. No eye sees between them.
TEST(CoverBuffer, LayersTakeOverWhatNearerOnesClose) {
  Camera camera = looking_along_x();
  camera.eyes = EyeRegion::ball(0.3);
  CoverBuffer buffer;
  buffer.begin(FrameView(camera, 100), kWidth, kHeight, 0);
  const auto add_wall = [&](double x, double from, double to) {
    add(buffer, {{x, from, -20}, {x, to, -20}, {x, to, 20}, {x, from, 20}}, {{0, 1, 2}, {0, 2, 3}});
  };
  const kernel::Aabb behind = cube({30, 0, 0}, 1), before = cube({3, 0, 0}, 0.1);
  add_wall(5, -20, 0.2);
  buffer.join_layers();
  EXPECT_FALSE(buffer.hides(behind)) << "it shows beside the one wall";
  add_wall(5.05, -0.2, 20);
  EXPECT_FALSE(buffer.hides(behind)) << "far layers wait for join_layers()";
  buffer.join_layers();
  EXPECT_TRUE(buffer.hides(behind));
  EXPECT_FALSE(buffer.hides(before));
}

/// The same before a third wall, which closes the seam, too, but behind the box.
TEST(CoverBuffer, WindowsNameNothingThatIsBehind) {
  constexpr std::uint32_t kBehind = 1, kBefore = 2;
  Camera camera = looking_along_x();
  camera.eyes = EyeRegion::ball(0.3);
  CoverBuffer buffer;
  buffer.begin(FrameView(camera, 400), kWidth, kHeight, 0);
  buffer.keep_owners();
  const auto add_wall = [&](double x, double from, double to, std::uint32_t id) {
    add(buffer, {{x, from, -200}, {x, to, -200}, {x, to, 200}, {x, from, 200}}, {{0, 1, 2}, {0, 2, 3}}, id);
  };
  const kernel::Aabb box = cube({30, 0, 0}, 1);
  add_wall(60, -200, 200, kBehind);
  add_wall(5, -20, 0.2, kBefore);
  add_wall(5.05, -0.2, 20, kBefore);
  buffer.join_layers();
  ASSERT_TRUE(buffer.hides(box));
  const CoverBuffer::Footprint at = buffer.hidden_at(box);
  std::size_t sheets = 0, nearer = 0;
  const auto visit = [&](const CoverBuffer::Footprint& footprint, const auto& again) -> void {
    for (const CoverBuffer::Window& window : buffer.windows(footprint).windows) {
      if (window.is_of_nearer_layer()) {
        ++nearer;
        again(buffer.through(footprint, window), again);
        continue;
      }
      ++sheets;
      EXPECT_EQ(buffer.sheet(window.sheet).id, kBefore);
    }
  };
  visit(at, visit);
  EXPECT_GT(sheets, 0U);
  EXPECT_GT(nearer, 0U);
}

TEST(CoverBuffer, TheMarginIsKept) {
  const Mesh mesh = square(2, 1);  // reaches 27.7 pixels from the middle; with a margin of 1/8 of 64 pixels, 19.7
  const auto hides = [&](double margin, double aside) {
    return Judge(looking_along_x(), mesh, 100, margin).hides(cube({4, aside, 0}, 0.01));
  };
  EXPECT_TRUE(hides(0, 1.85));
  EXPECT_FALSE(hides(0.125, 1.85));
  EXPECT_FALSE(hides(0.125, 1.5));
  EXPECT_TRUE(hides(0.125, 1.25));
}

/// It is a share of the picture's height in both directions, whatever the shape of the pixels.
TEST(CoverBuffer, TheMarginIsAsWideAsHigh) {
  const Mesh mesh = square(2, 1);
  for (const double aspect : {0.6, 1.0, 2.0, 3.0}) {
    Camera camera = looking_along_x();
    camera.aspect = aspect;
    const Judge judge(camera, mesh, 100, 0.125);
    // The picture is 1.155 high at a distance of 1. Where a box at distance 4 hides begins at 4 (0.5 - 0.125 * 1.155).
    for (const glm::dvec3& aside : {glm::dvec3{0, 1, 0}, {0, 0, 1}}) {
      EXPECT_FALSE(judge.hides(cube(glm::dvec3{4, 0, 0} + 1.44 * aside, 0.001))) << aspect;
      EXPECT_TRUE(judge.hides(cube(glm::dvec3{4, 0, 0} + 1.0 * aside, 0.001))) << aspect;
    }
  }
}

TEST(CoverBuffer, BeginningOpensAllPixels) {
  const Mesh mesh = square(2, 1);
  CoverBuffer buffer;
  buffer.begin(FrameView(looking_along_x(), 100), kWidth, kHeight, 0);
  add(buffer, mesh.vertices, mesh.pieces[0]);
  EXPECT_TRUE(buffer.hides(cube({4, 0, 0}, 0.8)));
  buffer.begin(FrameView(looking_along_x(), 100), kWidth, kHeight, 0);
  EXPECT_FALSE(buffer.hides(cube({4, 0, 0}, 0.8)));
}

/// A floor that reaches from behind the eye to the horizon, with the eye above it.
TEST(CoverBuffer, APieceThatTheNearPlaneCutsHidesWithWhatIsBeyond) {
  Mesh mesh;
  const std::array corner{mesh.vertex({-50, -50, -1}), mesh.vertex({50, -50, -1}), mesh.vertex({50, 50, -1}),
                          mesh.vertex({-50, 50, -1})};
  mesh.pieces = {{{corner[0], corner[1], corner[2]}, {corner[0], corner[2], corner[3]}}};
  const Judge judge(looking_along_x(), mesh, 200);
  EXPECT_TRUE(judge.hides(cube({10, 0, -4}, 0.5)));
  EXPECT_TRUE(judge.is_hidden(cube({10, 0, -4}, 0.5)));
  EXPECT_FALSE(judge.hides(cube({10, 0, -0.6}, 0.5)));
}

/// On a slanting piece the farthest point within each tile counts.
TEST(CoverBuffer, DepthIsThatOfThePlane) {
  Mesh mesh;
  const std::array corner{mesh.vertex({2, -8, -8}), mesh.vertex({40, 40, -40}), mesh.vertex({40, 40, 40}),
                          mesh.vertex({2, -8, 8})};
  mesh.pieces = {{{corner[0], corner[1], corner[2]}, {corner[0], corner[2], corner[3]}}};
  const Judge judge(looking_along_x(), mesh, 200);
  EXPECT_TRUE(judge.hides(cube({9, -4, 0}, 0.5))) << "nearer than the far end";
  EXPECT_FALSE(judge.hides(cube({20, 15, 0}, 0.5)));
}

/// The depth is such that a renderer in single precision moves the corners of a square at distance 2 by 2 pixels, and a box
/// at distance 200 by a fiftieth of a pixel. With any margin the border is as wide as that.
TEST(CoverBuffer, TheBorderIsAsWideAsARendererRounds) {
  const Mesh mesh = square(2, 1);  // reaches 27.7 pixels from the middle; 55.4 pixels are a slope of 1
  constexpr double kDepth = 2 * 2 / 55.4 / kSinglePrecision;
  const auto hides = [&](double margin, double pixels) {
    return Judge(looking_along_x(), mesh, kDepth, margin).hides(cube({200, 200 * pixels / 55.4, 0}, 0.01));
  };
  EXPECT_TRUE(hides(0, 26.5));
  EXPECT_FALSE(hides(1e-30, 26.5));
  EXPECT_TRUE(hides(0x1p-1000, 23.5));
}

/// The depth is such that a renderer moves points by a fiftieth. It may move what hides away, and what is hidden nearer.
TEST(CoverBuffer, WhatHidesIsAsFarAsARendererRounds) {
  constexpr double kDepth = 0.02 / kSinglePrecision;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera = looking_along_x();
    camera.projection = projection;
    const bool is_perspective = projection == Projection::perspective;
    // Triangles in few tiles are as far as their corners, triangles in many as their planes.
    for (const double half : {is_perspective ? 0.25 : 0.9, is_perspective ? 1.0 : 4.0}) {
      const auto hides = [&](double margin, double x) {
        return Judge(camera, square(2, half), kDepth, margin).hides({{x, -0.01, -0.01}, {x + 0.01, 0.01, 0.01}});
      };
      EXPECT_TRUE(hides(0, 2.001)) << half;
      EXPECT_FALSE(hides(1e-30, 2.039)) << half;
      EXPECT_TRUE(hides(1e-30, 2.041)) << half;
    }
  }
}

glm::dvec3 some_point(std::mt19937& random, double low_x, double high_x, double aside) {
  return {uniform(random, low_x, high_x), uniform(random, -aside, aside), uniform(random, -aside, aside)};
}

/// Random pieces: fans around a middle, some of which run round twice, strips, faces of cubes, and triangles anywhere. Some
/// have a hole, some have corners that miss each other by very little, and some reach before the near plane or behind the
/// eye.
Mesh some_mesh(std::mt19937& random) {
  Mesh mesh;
  for (std::size_t count = 1 + random() % 3; mesh.pieces.size() < count;) {
    std::vector<Triangle>& piece = mesh.pieces.emplace_back();
    const double low_x = random() % 3 == 0 ? -1 : 1;
    const glm::dvec3 middle = some_point(random, low_x, 4, 1);
    const int kind = static_cast<int>(random() % 4);
    const int sides = 3 + static_cast<int>(random() % 9);
    if (kind == 0) {  // a fan, round once or twice
      const std::uint32_t tip = mesh.vertex(middle);
      const double rounds = random() % 4 == 0 ? 2 : 1, size = uniform(random, 0.3, 4);
      std::vector<std::uint32_t> rim;
      for (int i = 0; i < sides; ++i) {
        const double angle = 2 * 3.14159265358979 * rounds * i / sides, r = uniform(random, 0.5, 1) * size;
        rim.push_back(
            mesh.vertex(middle + glm::dvec3{uniform(random, -0.3, 0.3), r * std::cos(angle), r * std::sin(angle)}));
      }
      for (std::size_t i = 0; i < rim.size(); ++i) piece.push_back({tip, rim[i], rim[(i + 1) % rim.size()]});
    } else if (kind == 1) {  // a strip
      std::uint32_t a = mesh.vertex(some_point(random, low_x, 4, 2)), b = mesh.vertex(some_point(random, low_x, 4, 2));
      for (int i = 0; i < sides; ++i) {
        const std::uint32_t c = mesh.vertex(some_point(random, low_x, 4, 3));
        piece.push_back({a, b, c});
        a = b;
        b = c;
      }
    } else if (kind == 2) {  // the faces of a cube, all or some
      const double half = uniform(random, 0.2, 1.5);
      std::array<std::uint32_t, 8> v{};
      for (unsigned i = 0; i < 8; ++i) {
        v[i] = mesh.vertex(middle + half * glm::dvec3{i & 1U ? 1 : -1, i & 2U ? 1 : -1, i & 4U ? 1 : -1});
      }
      for (const std::array<std::size_t, 4>& f :
           {std::array<std::size_t, 4>{0, 2, 6, 4}, {0, 1, 5, 4}, {0, 1, 3, 2}, {1, 3, 7, 5}}) {
        piece.push_back({v[f[0]], v[f[1]], v[f[2]]});
        piece.push_back({v[f[0]], v[f[2]], v[f[3]]});
        if (random() % 3 == 0) break;
      }
    } else {
      for (int i = 0; i < sides; ++i) {
        piece.push_back({mesh.vertex(some_point(random, low_x, 4, 3)), mesh.vertex(some_point(random, low_x, 4, 3)),
                         mesh.vertex(some_point(random, low_x, 4, 3))});
      }
    }
    if (random() % 3 == 0) piece.erase(piece.begin() + static_cast<std::ptrdiff_t>(random() % piece.size()));
    if (!piece.empty() && random() % 3 == 0) {  // a gap of 2^-8 or less
      Triangle& one = piece[random() % piece.size()];
      const glm::dvec3 apart = some_point(random, -1, 1, 1) * std::ldexp(1.0, -8 - static_cast<int>(random() % 44));
      one[random() % 3] = mesh.vertex(mesh.vertices[one[0]] + apart);
    }
  }
  return mesh;
}

class CoverBufferSoundness : public testing::TestWithParam<int> {};

TEST_P(CoverBufferSoundness, WhatItHidesIsHiddenExactly) {
  std::mt19937 random(static_cast<std::mt19937::result_type>(GetParam()));
  int hidden = 0, found = 0;
  for (int scene = 0; scene < 400; ++scene) {
    Camera camera = looking_along_x();
    if (random() % 3 == 0) camera.projection = Projection::orthographic;
    if (random() % 2 == 0) camera.target = {1, uniform(random, -0.3, 0.3), uniform(random, -0.3, 0.3)};
    if (random() % 2 == 0) camera.near_plane = 0.5;
    const Judge judge(camera, some_mesh(random), random() % 8 == 0 ? 0x1p16 : 64);
    for (int i = 0; i < 40; ++i) {
      const kernel::Aabb box = cube(some_point(random, 1, 12, 2), std::ldexp(1.0, -static_cast<int>(random() % 7)));
      const bool claims = judge.hides(box);
      const bool is_hidden = (claims || i < 10) && judge.is_hidden(box);
      ASSERT_TRUE(!claims || is_hidden) << "scene " << scene << ", box " << i;
      found += claims ? 1 : 0;
      hidden += i < 10 && is_hidden ? 1 : 0;
    }
  }
  EXPECT_GT(hidden, 300);
  EXPECT_GT(found, 2 * hidden) << "of four times as many boxes more than half";
}

INSTANTIATE_TEST_SUITE_P(Seeds, CoverBufferSoundness, testing::Range(1, 5));

}  // namespace cover_buffer_test
