// SPDX-License-Identifier: MIT
// What the prover accepts and what it does not, worked out by hand, above all culls by view.
#include "proof.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <string>
#include <vector>

#include "camera_picture.h"
#include "culler/scenes.h"
#include "occlude/culler/culler.h"

namespace occlude::proof {
namespace proof_test {

using culler::Camera;
using culler::PolygonSoup;
using glm::dvec3;

constexpr const char* kCuts = "the plane cuts what the camera shows (is --size that of the walk?)";

Camera looking_along_x(double fov_y_deg, double aspect) {
  Camera camera;
  camera.target = {1, 0, 0};
  camera.fov_y_deg = fov_y_deg;
  camera.aspect = aspect;
  return camera;
}

/// A square of this size in front of the camera, shifted sideways by `y`, and a triangle ten units away, where the model
/// ends.
PolygonSoup scene(double y, double size) {
  PolygonSoup soup;
  culler::add(soup, {{5, y, 0}, {5, y + size, 0}, {5, y + size, size}, {5, y, size}});
  culler::add(soup, {{10, 0, 0}, {10, 0.1, 0}, {10, 0, 0.1}});
  return soup;
}

/// The verdict on a line that culls all triangles of a polygon by this plane.
class ViewCull {
 public:
  ViewCull(const PolygonSoup& soup, const Camera& camera)
      : hierarchy_(culler::Hierarchy::build(soup, {.leaf_size = 1})),
        prover_(hierarchy_, {1, [camera](std::size_t) { return camera; }}) {}

  std::string fault(std::uint32_t polygon, const std::string& plane) const {
    std::uint32_t p = 0;
    while (hierarchy_.original(p) != polygon) ++p;
    const std::size_t first = hierarchy_.first_triangle(p), count = hierarchy_.first_triangle(p + 1) - first;
    const kernel::Aabb box = hierarchy_.soup().box(p);
    return prover_
        .prove(fmt::format(
            R"({{"frame":0,"eye":[0,0,0],"box":{{"min":[{},{},{}],"max":[{},{},{}]}},"triangles":[{},{}],"by":"view","plane":{}}})",
            box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z, first, count, plane))
        .failure;
  }

 private:
  culler::Hierarchy hierarchy_;
  Prover prover_;
};

TEST(ViewProof, TakesPlanesOutsideOfTheView) {
  const ViewCull aside(scene(60, 1), looking_along_x(60, 16.0 / 9));
  EXPECT_EQ(aside.fault(0, "[0,-1,0,50]"), "");  // the view ends at y = 10.3, where the model ends
  EXPECT_EQ(aside.fault(0, "[2,-1,0,0]"), "");   // tan 45.7 is 1.03
  EXPECT_EQ(aside.fault(0, "[1,-1,0,0]"), kCuts);
  EXPECT_EQ(aside.fault(0, "[2,-1,0,50]"), "the box reaches the plane");
}

/// In doubles, the terms of such a plane are infinite at every corner of the view, and their sum is not a number.
TEST(ViewProof, RefusesPlanesThatOverflow) {
  PolygonSoup soup = scene(-1, 2);
  for (dvec3& v : soup.vertices) v += dvec3{10, 10, 10};
  Camera camera = looking_along_x(60, 1);
  camera.eye = {10, 10, 10};
  camera.target = {11, 10, 10};
  const ViewCull before(soup, camera);
  for (const char* plane : {"[-1.7e308,1.6e308,0,0]", "[-1.7e308,1.7e308,1.7e308,-1.7e308]", "[-1e308,0,0,1e308]"}) {
    EXPECT_EQ(before.fault(0, plane), "a number of the plane is out of range") << plane;
  }
  EXPECT_EQ(before.fault(0, "[-1e30,0,0,0]"), kCuts);
}

TEST(ViewProof, RefusesPlanesThatUnderflow) {
  const ViewCull before(scene(-1, 0.25), looking_along_x(60, 1));
  for (const char* plane : {"[-5e-324,0,0,0]", "[-1e-300,0,0,0]", "[0,0,0,-5e-324]"}) {
    EXPECT_EQ(before.fault(0, plane), "a number of the plane is out of range") << plane;
  }
  EXPECT_EQ(before.fault(0, "[-1e-30,0,0,0]"), kCuts);
  EXPECT_EQ(before.fault(0, "[0,0,0,-1e-30]"), kCuts);
}

/// Suppose that the far corners of the view are cut off at the sideways reach of the model. The hull of the corners then
/// lacks the part next to the border of a wide picture, and ordinary planes pass through that part.
TEST(ViewProof, RefusesPlanesWithinTheBorderOfAWidePicture) {
  const ViewCull usual(scene(5.06, 0.06), looking_along_x(60, 16.0 / 9));
  EXPECT_EQ(usual.fault(0, "[11.13,-11.14,0,0.113]"), kCuts);
  const ViewCull wide(scene(12, 1), looking_along_x(120, 16.0 / 9));
  EXPECT_EQ(wide.fault(0, "[1,-1,0,0.3]"), kCuts);
}

/// These planes are outside the picture, or in front of the near plane, by less than single precision may move a point of a
/// model 2^20 deep.
TEST(ViewProof, RefusesPlanesWithinWhatTheRendererRounds) {
  Camera camera = looking_along_x(90, 1);
  const oracle::Aabb model{{-0x1p19, -0x1p18, -0x1p18}, {8, 0x1p18, 0x1p18}};
  for (const auto projection : {culler::Projection::perspective, culler::Projection::orthographic}) {
    camera.projection = projection;
    camera.height = 2;
    EXPECT_TRUE(may_draw_beyond({1, 0, 0, 0.3}, camera, model)) << "0.4 before the near plane";
    EXPECT_FALSE(may_draw_beyond({1, 0, 0, 0.6}, camera, model));
  }
  EXPECT_TRUE(may_draw_beyond({0, -1, 0, 1.5}, camera, model)) << "0.5 aside of parallel rays";
  EXPECT_FALSE(may_draw_beyond({0, -1, 0, 1.7}, camera, model));
}

TEST(ViewProof, TakesEveryPlaneThatTheCullerMakes) {
  for (const double fov : {0.001, 1.0, 60.0, 120.0, 179.0}) {
    for (const double aspect : {1.0, 16.0 / 9, 8192.0, 1 / 8192.0, 65536.0, 1 / 65536.0}) {
      for (const dvec3& away : {dvec3{0, 0, 0}, dvec3{1e6, -3e5, 0.1}, dvec3{4e9, 0, 4e9}}) {
        for (const auto projection : {culler::Projection::perspective, culler::Projection::orthographic}) {
          Camera camera = looking_along_x(fov, aspect);
          camera.projection = projection;
          camera.height = fov;
          camera.eye += away;
          camera.target = camera.eye + dvec3{0.3, 0.7, -0.2};
          camera.far_plane = 1e4;
          ASSERT_EQ(culler::fault(camera), "");
          const oracle::Aabb model{{away.x - 100, away.y - 100, away.z - 100}, {away.x + 100, away.y + 100, away.z + 100}};
          std::vector<culler::HalfSpace> planes;
          culler::append_view_frustum(camera, 300, planes);
          for (const auto& [n, offset] : planes) {
            EXPECT_FALSE(may_draw_beyond({n.x, n.y, n.z, offset}, camera, model))
                << fov << " degrees, " << aspect << " wide, at " << away.x << ", plane " << n.x << ' ' << n.y << ' ' << n.z;
            EXPECT_EQ(oracle::refute_view_cull({n.x, n.y, n.z, offset}, model), "the box reaches the plane");
          }
        }
      }
    }
  }
}

/// The matrix of a camera at the origin that looks along x: 90 degrees, from x = 1 on. The third row is that of its depth.
culler::MatrixCamera matrix_along_x(std::array<double, 4> depth, culler::ClipDepth clip) {
  const auto [a, b, c, d] = depth;
  return culler::MatrixCamera::from_rows(std::array<double, 16>{0, -1, 0, 0, 0, 0, 1, 0, a, b, c, d, 1, 0, 0, 0}.data(),
                                         clip);
}

/// Depth from -w or 0 to w or, without a far plane, to what is less than w; and the same reversed.
const std::array kMatrices{matrix_along_x({1, 0, 0, -2}, culler::ClipDepth::minus_w_to_w),
                           matrix_along_x({1, 0, 0, -1}, culler::ClipDepth::zero_to_w),
                           matrix_along_x({1.25, 0, 0, -1.25}, culler::ClipDepth::zero_to_w),
                           matrix_along_x({-1, 0, 0, 2}, culler::ClipDepth::minus_w_to_w),
                           matrix_along_x({0, 0, 0, 1}, culler::ClipDepth::zero_to_w)};

TEST(MatrixProof, RefusesPlanesThatCutWhatTheMatrixShows) {
  const oracle::Aabb model{{-8, -8, -8}, {4, 4, 4}};
  for (culler::MatrixCamera camera : kMatrices) {
    ASSERT_EQ(culler::fault(camera), "");
    const auto is_refused = [&](const std::array<double, 4>& plane) { return may_draw_beyond(plane, camera, model); };
    EXPECT_TRUE(is_refused({1, 0, 0, -1.001})) << "within the near plane";
    EXPECT_FALSE(is_refused({1, 0, 0, -0.999})) << "before it";
    EXPECT_TRUE(is_refused({1, -1, 0, -0.001})) << "within the left side";
    EXPECT_FALSE(is_refused({1, -1, 0, 0.001})) << "beyond it";
    EXPECT_TRUE(is_refused({1, 0, 1, -0.001})) << "within the bottom";
    EXPECT_FALSE(is_refused({1, 0, 1, 0.001})) << "beyond it";
    camera.eyes.radius = 0.25;
    EXPECT_TRUE(is_refused({1, 0, 0, -0.76})) << "one of the eyes shows it";
    EXPECT_FALSE(is_refused({1, 0, 0, -0.74}));
    EXPECT_TRUE(is_refused({1, -1, 0, 0.34})) << "a side is moved by the radius, 0.25 sqrt 2 along the axes";
    EXPECT_FALSE(is_refused({1, -1, 0, 0.36}));
  }
}

TEST(MatrixProof, KnowsWhereTheRendererClips) {
  const oracle::Aabb model{{-8, -8, -8}, {4, 4, 4}};
  for (culler::MatrixCamera camera : kMatrices) {
    const auto clips = [&](double x) { return may_clip(camera, model, std::vector<oracle::Point>{{x, 0, 0}}); };
    EXPECT_TRUE(clips(0.999));
    EXPECT_FALSE(clips(1.001));
    EXPECT_FALSE(clips(1000)) << "what is beyond the far plane hides what is beyond it too";
    camera.eyes.radius = 0.25;
    EXPECT_TRUE(clips(1.24)) << "for one of the eyes";
    EXPECT_FALSE(clips(1.26));
  }
}

/// Sheets may be cut across a line of sight that is turned by ten degrees. A ray to the corner of a picture of 90 degrees is
/// at depth 1 after a way of sqrt(3), and so cos(10) + sqrt(2) sin(10) = 1.23 along that line at most.
TEST(MatrixProof, KnowsWhatTheNearPlaneClipsWithinThePicture) {
  const oracle::Aabb model{{-8, -8, -8}, {4, 4, 4}};
  const double c = std::cos(glm::radians(10.0)), s = std::sin(glm::radians(10.0));
  for (culler::MatrixCamera camera : kMatrices) {
    const auto draws = [&](const std::array<double, 4>& cut) { return draws_all_in(cut, camera, model); };
    EXPECT_TRUE(draws({1, 0, 0, -1.001}));
    EXPECT_FALSE(draws({1, 0, 0, -0.999}));
    EXPECT_TRUE(draws({c, s, 0, -1.24})) << "what is nearer is aside of the picture";
    EXPECT_FALSE(draws({c, s, 0, -1.1}));
    camera.eyes.radius = 0.25;
    EXPECT_TRUE(draws({1, 0, 0, -1.251}));
    EXPECT_FALSE(draws({1, 0, 0, -1.249})) << "for one of the eyes";
    EXPECT_TRUE(draws({c, s, 0, -1.49}));
    EXPECT_FALSE(draws({c, s, 0, -1.35}));
  }
}

/// The sides of all eyes, each moved outward, meet behind the eyes. Nobody sees what is there.
TEST(ViewProof, TakesPlanesBehindTheEyesOfARegion) {
  Camera camera = looking_along_x(90, 1);
  camera.near_plane = 0.125;
  const oracle::Aabb model{{-8, -8, -8}, {8, 8, 8}};
  const oracle::EyeRegion eyes = oracle::Obb{{0, 0, 0}, {{{0, 1, 0}, {0, 0, 1}, {0.25, 0, 0}}}};
  const double side = std::sqrt(0.5) - 0.01, ahead = std::sqrt(0.5) + 0.01;
  EXPECT_FALSE(may_draw_beyond({ahead, -side, 0, side + 0.25 * ahead}, camera, model, eyes)) << "a side, turned outward";
  EXPECT_TRUE(may_draw_beyond({side, -ahead, 0, ahead + 0.25 * side}, camera, model, eyes)) << "a side, turned inward";
  EXPECT_TRUE(may_draw_beyond({ahead, -side, 0, side}, camera, model, eyes))
      << "the side of an eye in the middle of the others";
}

/// An eye that is 0.25 / sqrt(2) behind and aside of the middle shows as much more of a wall to the side, and once more.
TEST(ViewProof, RefusesPlanesWithinWhatAnEyeAsideShowsOfAWall) {
  const Camera camera = looking_along_x(90, 1);
  const oracle::Aabb wall{{4, -8, -8}, {4, 8, 8}};
  const oracle::EyeRegion eyes = oracle::Ball{{0, 0, 0}, 0.25};
  EXPECT_TRUE(may_draw_beyond({0, -1, 0, 4.3}, camera, wall, eyes));
  EXPECT_FALSE(may_draw_beyond({0, -1, 0, 4.6}, camera, wall, eyes));
}

/// The oracle's time grows with the square of the number of vertices of a polytope, so more than kMostCorners are refused at
/// once.
TEST(ShadowProof, RefusesPolytopesOfVeryManyVertices) {
  const auto hierarchy = culler::Hierarchy::build(scene(-1, 2), {.leaf_size = 1});
  const Prover prover(hierarchy, {1, [](std::size_t) { return looking_along_x(60, 1); }});
  const auto prove = [&](std::size_t vertices) {
    std::string list = "[5,0,0]";
    for (std::size_t i = 1; i < vertices; ++i) list += ",[5,0,0]";
    return prover.prove(
        fmt::format(R"({{"frame":0,"eye":[0,0,0],"box":{{"min":[5,-9,-9],"max":[10,9,9]}},"triangles":[0,1],"by":"shadow",)"
                    R"("near":"surface","occluders":[{{"vertices":[{}],"faces":[]}}]}})",
                    list));
  };
  EXPECT_NO_THROW(prove(kMostCorners));
  EXPECT_THROW(prove(kMostCorners + 1), LineError);
}

/// A wall of two halves at x = 2. The second half is in two parts with a corner on the edge of the first half. A horizontal
/// polygon starts close to the eye. Behind the wall is a square.
class CoverCull : public testing::Test {
 protected:
  CoverCull() {
    culler::add(soup_, {{2, -1, -1}, {2, 0, -1}, {2, 0, 1}, {2, -1, 1}});
    culler::add(soup_, {{2, 0, -1}, {2, 1, -1}, {2, 1, 0.25}, {2, 0, 0.25}});
    culler::add(soup_, {{2, 0, 0.25}, {2, 1, 0.25}, {2, 1, 1}, {2, 0, 1}});
    culler::add(soup_, {{0.05, -1, 0.1}, {3, -1, 0.1}, {3, 1, 0.1}, {0.05, 1, 0.1}});
    culler::add(soup_, {{6, -1, -1}, {6, 1, -1}, {6, 1, 1}, {6, -1, 1}});
  }

  [[nodiscard]] std::string fault(const std::string& polygons, const std::string& box, const Camera& camera,
                                  const std::string& more = "") const {
    const auto hierarchy = culler::Hierarchy::build(soup_, {.leaf_size = 1});
    const Prover prover(hierarchy, {1, [camera](std::size_t) { return camera; }});
    std::uint32_t p = 0;
    while (hierarchy.original(p) != 4) ++p;
    return prover
        .prove(fmt::format(R"({{"frame":0,"{}":[{},0,0],"box":{},"triangles":[{},2],"by":"cover","polygons":[{}]{}}})",
                           camera.projection == culler::Projection::perspective ? "eye" : "direction",
                           camera.projection == culler::Projection::perspective ? 0 : 1, box, hierarchy.first_triangle(p),
                           polygons, more))
        .failure;
  }

  PolygonSoup soup_;
  const std::string box_ = R"({"min":[6,-1,-1],"max":[6,1,1]})";
};

TEST_F(CoverCull, RefusesWhatIsSeeThrough) {
  const Camera camera = looking_along_x(60, 1);
  soup_.see_through = {0, 1, 0, 0, 1};
  EXPECT_EQ(fault("0,1,2", box_, camera), "a see-through polygon hides nothing");
  soup_.see_through = {0, 0, 0, 1, 1};
  EXPECT_EQ(fault("0,1,2", box_, camera), "");
  EXPECT_EQ(fault("0,1,2,3", box_, camera), "a see-through polygon hides nothing");
}

/// The second half of the wall is one face of two pieces.
TEST_F(CoverCull, NamesPiecesOfFaces) {
  const Camera camera = looking_along_x(60, 1);
  soup_.faces = {0, 1, 1, 2, 3};
  EXPECT_EQ(fault("0,[1,0],[1,1]", box_, camera), "");
  EXPECT_EQ(fault("[0,0],[1,0],[1,1]", box_, camera), "");
  EXPECT_EQ(fault("0,[1,0]", box_, camera), "the polygons do not hide the box");
  EXPECT_EQ(fault("0,1", box_, camera), "no such polygon") << "it has two";
  EXPECT_EQ(fault("0,[1,2]", box_, camera), "no such polygon");
  EXPECT_EQ(fault("0,[4,0]", box_, camera), "no such polygon");
  EXPECT_THROW(fault("0,[1,0,0]", box_, camera), LineError);
  EXPECT_THROW(fault("0,[1,-1]", box_, camera), LineError);
}

/// One polygon, or two that are joined, and a square behind.
TEST(ShadowProof, RefusesOccludersThatAreSeeThrough) {
  for (const bool is_joined : {false, true}) {
    for (const bool is_opaque : {true, false}) {
      PolygonSoup soup;
      culler::add(soup, {{2, -1, -1}, {2, 0, -1}, {2, 0, 1}, {2, -1, 1}});
      culler::add(soup, {{2, 0, -1}, {2, 1, -1}, {2, 1, 1}, {2, 0, 1}});
      culler::add(soup, {{6, -0.5, -0.5}, {6, -0.25, -0.5}, {6, -0.5, -0.25}});
      if (!is_opaque) soup.see_through = {1, 0, 0};
      const auto hierarchy = culler::Hierarchy::build(soup, {.leaf_size = 1});
      const Prover prover(hierarchy, {1, [](std::size_t) { return looking_along_x(60, 1); }});
      const auto run_of = [&](std::uint32_t original) {
        std::uint32_t p = 0;
        while (hierarchy.original(p) != original) ++p;
        const std::size_t first = hierarchy.first_triangle(p);
        return fmt::format("[{},{}]", first, hierarchy.first_triangle(p + 1) - first);
      };
      const std::string occluder =
          is_joined ? fmt::format(R"("polygon":[[2,-1,-1],[2,0,-1],[2,1,-1],[2,1,1],[2,0,1],[2,-1,1]],"parts":[{},{}])",
                                  run_of(0), run_of(1))
                    : R"("polygon":[[2,-1,-1],[2,0,-1],[2,0,1],[2,-1,1]])";
      const std::string line = fmt::format(
          R"({{"frame":0,"eye":[0,0,0],"box":{{"min":[6,-0.5,-0.5],"max":[6,-0.25,-0.25]}},"triangles":{},"by":"shadow",)"
          R"("occluders":[{{{}}}],"near":"surface"}})",
          run_of(2), occluder);
      EXPECT_EQ(prover.prove(line).failure, is_opaque ? "" : "the occluder is not of the model outside the subtree");
    }
  }
}

TEST_F(CoverCull, IsProvedByTheOracle) {
  const Camera camera = looking_along_x(60, 1);
  constexpr const char* kSeen = "the polygons do not hide the box";
  EXPECT_EQ(fault("0,1,2", box_, camera), "");
  EXPECT_EQ(fault("2,0,1,1,3,4", box_, camera), "") << "in any order, and with itself";
  EXPECT_EQ(fault("0,1", box_, camera), kSeen);
  EXPECT_EQ(fault("", box_, camera), kSeen);
  EXPECT_EQ(fault("4", box_, camera), kSeen);
  EXPECT_EQ(fault("0,1,2,3", R"({"min":[2,-1,-1],"max":[6,1,1]})", camera), kSeen) << "it touches the wall";
  EXPECT_EQ(fault("0,1,2", R"({"min":[6,-1,-1],"max":[6,0,1]})", camera), "the triangles are not in the box");
  EXPECT_EQ(fault("0,1,5", box_, camera), "no such polygon");
  EXPECT_EQ(fault("0,1,2", box_, camera, R"(,"margin":1e-9)"), "a cover has no margin");
  EXPECT_THROW(fault("0,-1", box_, camera), LineError);
  EXPECT_THROW(fault("0,[1]", box_, camera), LineError);
  Camera parallel = camera;
  parallel.projection = culler::Projection::orthographic;
  EXPECT_EQ(fault("0,1,2", box_, parallel), "");
  EXPECT_EQ(fault("0,1", box_, parallel), kSeen);
}

/// A ramp that starts in front of the near plane hides what is low behind it, but only as far as it is drawn.
TEST_F(CoverCull, CountsWhatIsDrawn) {
  soup_ = {};
  for (int i = 0; i < 4; ++i) culler::add(soup_, {{50, 50, 50}, {51, 50, 50}, {50, 51, 50}});
  culler::add(soup_, {{9, -1, -1}, {9, 1, -1}, {9, 1, 0}, {9, -1, 0}});
  culler::add(soup_, {{0.05, -4, 0.01}, {4, -4, -1}, {4, 4, -1}, {0.05, 4, 0.01}});
  const std::string box = R"({"min":[9,-1,-1],"max":[9,1,0]})";
  Camera camera = looking_along_x(60, 1);
  camera.near_plane = 0.04;
  EXPECT_EQ(fault("5", box, camera), "");
  camera.near_plane = 0.3;
  EXPECT_EQ(fault("5", box, camera), "the polygons do not hide the box");
}

/// Seen from |x|, |y|, |z| <= 1/4, a square at x = 6 is behind the two halves of a wall at x = 2, and passes it where |y|,
/// |z|
/// <= 1/2. A slope between the two begins at x = 1/2. The last polygon is see-through.
class RegionCull : public testing::Test {
 protected:
  RegionCull() {
    culler::add(soup_, {{2, -2, -2}, {2, 0, -2}, {2, 0, 2}, {2, -2, 2}});
    culler::add(soup_, {{2, 0, -2}, {2, 2, -2}, {2, 2, 2}, {2, 0, 2}});
    culler::add(soup_, {{0.5, -9, 1}, {0.5, 9, 1}, {4, 9, -2.5}, {4, -9, -2.5}});
    culler::add(soup_, {{6, -1, -1}, {6, 1, -1}, {6, 1, 1}, {6, -1, 1}});
    culler::add(soup_, {{-3, -9, -9}, {3, 9, -9}, {3, 9, 9}, {-3, -9, 9}});
    soup_.see_through = {0, 0, 0, 0, 1};
  }

  [[nodiscard]] std::string fault(const std::string& eyes, const std::string& rest) const {
    const auto hierarchy = culler::Hierarchy::build(soup_, {.leaf_size = 1});
    const Prover prover(hierarchy, {1, [this](std::size_t) { return camera_; }});
    std::uint32_t p = 0;
    while (hierarchy.original(p) != 3) ++p;
    return prover
        .prove(fmt::format(R"({{"frame":0,"eyes":{},"box":{{"min":[6,-1,-1],"max":[6,1,1]}},"triangles":[{},2],)"
                           R"("focus":{{"point":[2,0,0],"normal":[1,0,0],"right":[0,-1,0]}},{}}})",
                           eyes, hierarchy.first_triangle(p), rest))
        .failure;
  }
  [[nodiscard]] std::string fault_of_cover(const std::string& eyes, const std::string& windows) const {
    return fault(eyes, R"("by":"cover","windows":[)" + windows + "]");
  }

  PolygonSoup soup_;
  Camera camera_ = looking_along_x(60, 1);
  const std::string ball_ = R"({"center":[0,0,0],"radius":0.25})",
                    cube_ = R"({"center":[0,0,0],"half_edges":[[0.25,0,0],[0,0.25,0],[0,0,0.25]]})";
};

TEST_F(RegionCull, IsProvedByTheOracle) {
  constexpr const char* kSeam = "window 0: the border of the sheet shows before the focus plane";
  constexpr const char* kUncovered = "the windows do not cover what the box is seen through";
  const std::string whole = R"({"rect":[-0.51,-0.51,0.51,0.51],"polygons":[0,1]})";
  EXPECT_EQ(fault_of_cover(ball_, whole), "");
  EXPECT_EQ(fault_of_cover(cube_, R"({"rect":[-0.6,-0.6,0.6,0.6],"polygons":[1,0]})"), "");
  EXPECT_EQ(fault_of_cover(cube_, whole), kUncovered);
  EXPECT_EQ(fault_of_cover(ball_, R"({"rect":[-0.51,-0.51,0.51,0.51],"polygons":[0]})"), kSeam);
  EXPECT_EQ(
      fault_of_cover(
          ball_, R"({"rect":[0.125,-0.51,0.51,0.51],"polygons":[0]},{"rect":[-0.51,-0.51,0.125,0.51],"polygons":[0,1]})"),
      "")
      << "the first axis is -y";
  EXPECT_EQ(fault_of_cover(ball_, ""), kUncovered);
  const auto nested = [](double half) {
    return fmt::format(R"({{"rect":[-0.51,-0.51,0.51,0.51],"focus":{{"point":[1,0,0],"normal":[1,0,0],"right":[0,-1,0]}},)"
                       R"("windows":[{{"rect":[-{0},-{0},{0},{0}],"polygons":[0,1]}}]}})",
                       half);
  };
  EXPECT_EQ(fault_of_cover(ball_, nested(0.5)), "");
  EXPECT_EQ(fault_of_cover(ball_, nested(0.3)), std::string("window 0: ") + kUncovered);
  EXPECT_EQ(fault_of_cover(ball_, R"({"rect":[-0.51,-0.51,0.51,0.51],"polygons":[0,4]})"),
            "a see-through polygon hides nothing");
  EXPECT_EQ(fault_of_cover(ball_, R"({"rect":[-0.51,-0.51,0.51,0.51],"polygons":[9]})"), "no such polygon");
  EXPECT_EQ(fault_of_cover(R"({"center":[0,0,0],"radius":-1})", whole), "the frame's eye is not in the region");
  EXPECT_EQ(fault_of_cover(R"({"center":[0,0.25,0],"radius":0.25})", whole), kUncovered);
  EXPECT_EQ(fault_of_cover(R"({"center":[0,0.25,0],"radius":0.125})", whole), "the frame's eye is not in the region");
  camera_.projection = culler::Projection::orthographic;
  EXPECT_EQ(fault_of_cover(ball_, whole), "a region of eyes is for perspective");
}

/// The slope is met between x = 1.2 and 1.9, and begins at z = 1, above all lines, for eyes whose near plane is there.
TEST_F(RegionCull, CountsWhatIsDrawnForAllEyes) {
  const std::string slope = R"({"rect":[-0.51,-0.51,0.51,0.51],"polygons":[2]})";
  EXPECT_EQ(fault_of_cover(ball_, slope), "");
  camera_.near_plane = 0.7;
  EXPECT_EQ(fault_of_cover(R"({"center":[0,0,0],"radius":0.125})", slope), "");
  EXPECT_EQ(fault_of_cover(ball_, slope), "");
  camera_.near_plane = 0.9;
  EXPECT_EQ(fault_of_cover(R"({"center":[0,0,0],"radius":0.125})", slope), "");
  EXPECT_EQ(fault_of_cover(ball_, slope), "window 0: the border of the sheet shows before the focus plane");
}

/// What a frame for several eyes culls is proved for all of them.
TEST_F(RegionCull, IsOfTheEyesOfTheFrame) {
  const std::string window = R"({"rect":[-0.6,-0.6,0.6,0.6],"polygons":[0,1]})";
  const std::string smaller = R"({"center":[0,0,0],"radius":0.125})";
  constexpr const char* kOther = "the eyes are not the frame's";
  EXPECT_EQ(fault_of_cover(smaller, window), "");
  camera_.eyes = culler::EyeRegion::ball(0.25);
  EXPECT_EQ(fault_of_cover(ball_, window), "");
  EXPECT_EQ(fault_of_cover(smaller, window), kOther);
  EXPECT_EQ(fault_of_cover(cube_, window), kOther);
  camera_.eyes = culler::EyeRegion::box({0.25, 0, 0}, {0, 0.25, 0}, {0, 0, 0.25});
  EXPECT_EQ(fault_of_cover(cube_, window), "");
  EXPECT_EQ(fault_of_cover(ball_, window), kOther);
  const auto hierarchy = culler::Hierarchy::build(soup_, {.leaf_size = 1});
  const Prover prover(hierarchy, {1, [this](std::size_t) { return camera_; }});
  std::uint32_t p = 0;
  while (hierarchy.original(p) != 3) ++p;
  EXPECT_EQ(
      prover
          .prove(fmt::format(
              R"({{"frame":0,"eye":[0,0,0],"box":{{"min":[6,-1,-1],"max":[6,1,1]}},"triangles":[{},2],"by":"cover","polygons":[0,1]}})",
              hierarchy.first_triangle(p)))
          .failure,
      "the frame holds for a region of eyes, and the line is of one");
}

TEST_F(RegionCull, PlanesAreOutsideOfAllPictures) {
  const auto view = [&](const std::string& eyes, const std::string& plane) {
    return fault(eyes, R"("by":"view","plane":)" + plane);
  };
  EXPECT_EQ(view(ball_, "[-1,0,0,5]"), kCuts);
  camera_.target = {-1, 0, 0};  // it looks away
  EXPECT_EQ(view(ball_, "[-1,0,0,5]"), "");
  EXPECT_EQ(view(ball_, "[-1,0,0,0.2]"), "");
  EXPECT_EQ(view(ball_, "[-1,0,0,0.1]"), kCuts) << "what an eye at 1/4 shows begins at 0.15";
  EXPECT_EQ(view(cube_, "[-1,0,0,0.1]"), kCuts);
  EXPECT_EQ(view(R"({"center":[0,0,0],"half_edges":[[0.1875,0,0],[0,0,0],[0,0,0]]})", "[-1,0,0,0.1]"), "");
}

TEST_F(RegionCull, ShadowsAreFromAllEyes) {
  const auto shadow = [&](const std::string& eyes, const std::string& polygon, const std::string& more = "") {
    return fault(eyes, R"("by":"shadow","occluders":[{"polygon":)" + polygon + "}]" + more);
  };
  const std::string wall = "[[1,-2,-2],[1,2,-2],[1,2,2],[1,-2,2]]", half = "[[2,0,-2],[2,2,-2],[2,2,2],[2,0,2]]";
  culler::add(soup_, {{1, -2, -2}, {1, 2, -2}, {1, 2, 2}, {1, -2, 2}});
  soup_.see_through.push_back(0);
  EXPECT_EQ(shadow(ball_, wall), "");
  EXPECT_EQ(shadow(cube_, wall), "");
  EXPECT_EQ(shadow(ball_, half), "the box is not in the shadow from every eye");
  EXPECT_EQ(shadow(ball_, "[[1,-3,-2],[1,2,-2],[1,2,2],[1,-2,2]]"), "the occluder is not of the model outside the subtree");
  EXPECT_EQ(shadow(ball_, wall, R"(,"margin":1e-9)"), "a shadow for a region of eyes has no margin");
  EXPECT_THROW(fault(ball_, R"("by":"shadow","occluders":[{"polygon":[]},{"polygon":[]}])"), LineError);
  camera_.near_plane = 0.8;
  EXPECT_EQ(shadow(ball_, wall), "the renderer clips the occluder");
  EXPECT_EQ(shadow(R"({"center":[0,0,0],"radius":0.125})", wall), "");
}

TEST_F(RegionCull, RefusesWhatIsNoWitness) {
  const std::string window = R"({"rect":[-1,-1,1,1],"polygons":[0,1]})";
  for (const char* eyes : {"0", "{}", R"({"radius":1})", R"({"center":[0,0,0]})", R"({"center":[0,0],"radius":1})",
                           R"({"center":[0,0,0],"radius":"1"})", R"({"center":[0,0,0],"half_edges":[[1,0,0]]})",
                           R"({"center":[0,0,0],"radius":1,"half_edges":[[1,0,0],[0,0,0],[0,0,0]]})"}) {
    EXPECT_THROW(fault_of_cover(eyes, window), LineError) << eyes;
  }
  for (const char* line :
       {R"("by":"cover")", R"("by":"cover","windows":1)", R"("by":"cover","windows":[1])",
        R"("by":"cover","windows":[{"polygons":[]}])", R"("by":"cover","windows":[{"rect":[0,0,1],"polygons":[]}])",
        R"("by":"cover","windows":[{"rect":[0,0,1,1]}])", R"("by":"cover","windows":[{"rect":[0,0,1,1],"polygons":[-1]}])",
        R"("by":"cover","windows":[],"eye":[0,0,0])", R"("by":"cover","windows":[{"rect":[0,0,1,1],"windows":[]}])",
        R"("by":"cover","windows":[{"rect":[0,0,1,1],"windows":[],"polygons":[]}])"}) {
    EXPECT_THROW(fault(ball_, line), LineError) << line;
  }
  EXPECT_EQ(fault_of_cover(R"({"center":["nan",0,0],"radius":1})", window), "the frame's eye is not in the region");
  EXPECT_EQ(fault_of_cover(R"({"center":[0,0,0],"radius":"inf"})", window), "the frame's eye is not in the region");
  EXPECT_EQ(fault_of_cover(ball_, R"({"rect":[-1,-1,"inf",1],"polygons":[0,1]})"), "a number is not finite");
  EXPECT_EQ(fault_of_cover(ball_, R"({"rect":[1,-1,-1,1],"polygons":[0,1]})"), "a window is empty");
  std::string many = window;
  for (int i = 0; i < 16384; ++i) many += "," + window;
  EXPECT_THROW(fault_of_cover(ball_, many), LineError);
}

TEST(NearPlaneProof, IsExact) {
  const Camera camera = looking_along_x(60, 1);         // near 0.1
  const oracle::Aabb model{{-500, -8, -4}, {5, 8, 4}};  // 512 deep
  const auto clips = [&](double x) { return may_clip(camera, model, std::vector<oracle::Point>{{5, 0, 0}, {x, 1, 1}}); };
  EXPECT_FALSE(clips(0.101));
  EXPECT_FALSE(clips(0.1 + 512 * 0x1p-20));
  EXPECT_TRUE(clips(0.1 + 512 * 0x1p-21));
  EXPECT_TRUE(clips(0.1));
  EXPECT_TRUE(clips(-1));
}

}  // namespace proof_test
}  // namespace occlude::proof
