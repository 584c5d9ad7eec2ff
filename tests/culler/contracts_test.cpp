// SPDX-License-Identifier: MIT
// The contracts of the cullers: views that are used with another culler, soups that are not well formed, shadows that were
// never made, boxes far away, and other rounding modes.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "camera/frame_view.h"
#include "camera/shadow_margin.h"
#include "frame/culler_access.h"
#include "frames.h"
#include "kernel/rounding.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/scene.h"
#include "occlude/kernel/clearance.h"
#include "scenes.h"

namespace contracts_test {

using namespace occlude;
using namespace occlude::culler;
using kernel::Aabb;

Camera camera_at(int frame) {
  Camera camera;
  camera.eye = {-40.0 + frame, 1, 2};
  camera.target = camera.eye + glm::dvec3{1, 0.1, 0};
  return camera;
}

void expect_same(const CullResult& a, const CullResult& b) {
  EXPECT_EQ(a.drawn, b.drawn);
  ASSERT_EQ(a.occluders.size(), b.occluders.size());
  for (std::size_t i = 0; i < a.occluders.size(); ++i) {
    EXPECT_EQ(a.occluders[i].index, b.occluders[i].index);
    EXPECT_EQ(a.occluders[i].hidden, b.occluders[i].hidden);
  }
  EXPECT_EQ(a.stats.sort_kept, b.stats.sort_kept);
  EXPECT_EQ(a.stats.silhouette_faces_asked, b.stats.silhouette_faces_asked);
  EXPECT_EQ(a.stats.cover_triangles, b.stats.cover_triangles);
}

constexpr int kFrames = 6;

TEST(View, StartsAnewWithAnotherCuller) {
  const BuildConfig config{.lists = {.regions = 256}};
  const Culler large(random_town_of_houses(1, 3000), config), small(random_town_of_houses(2, 120), config),
      other(random_town(3, 3000), config);
  for (const Method method : {Method::frusta, Method::cover}) {
    CullOptions options{.method = Method::frusta};
    options.method = method;
    View shared;
    for (const Culler* culler : {&large, &small, &other, &large}) {
      View own;
      for (int i = 0; i < kFrames; ++i) {
        culler->cull(camera_at(i), options, shared);
        culler->cull(camera_at(i), options, own);
        expect_same(shared.result(), own.result());
        ASSERT_FALSE(testing::Test::HasFailure()) << "frame " << i;
      }
    }
  }
}

/// A copy is the same culler, so the view forgets nothing.
TEST(View, GoesOnWithACopy) {
  const Culler culler(random_town_of_houses(1, 1000));
  const Culler copy = culler;  // NOLINT(performance-unnecessary-copy-initialization)
  View both, one;
  for (int i = 0; i < kFrames; ++i) {
    (i % 2 == 0 ? culler : copy).cull(camera_at(i), {.method = Method::frusta}, both);
    culler.cull(camera_at(i), {.method = Method::frusta}, one);
    expect_same(both.result(), one.result());
  }
  EXPECT_GT(one.result().stats.sort_kept, 0U);
}

TEST(View, KeepsItsLastFrameWhenAForeignCameraIsFaulty) {
  const Culler first(random_town(1, 500)), second(random_town(2, 50));
  View view;
  const CullResult frame = first.cull(camera_at(0), {.method = Method::frusta}, view);
  Camera faulty = camera_at(0);
  faulty.target = faulty.eye;
  EXPECT_THROW(second.cull(faulty, {.method = Method::frusta}, view), std::invalid_argument);
  expect_same(view.result(), frame);
}

/// With an opening of 90 degrees the border of the picture is y = x. The half-space there is tilted by the rounding of the
/// tangent of 45 degrees, so that far beyond the model its plane lies inside the picture.
TEST(View, NothingInThePictureIsOutOfViewHoweverFar) {
  PolygonSoup soup;
  add_wall(soup, 2, -1, 1, -1, 1);
  const Culler culler(soup);
  for (const Method method : {Method::frusta, Method::cover}) {
    CullOptions options{.method = Method::frusta};
    options.method = method;
    View view;
    Camera camera;
    camera.eye = {0, 0, 0};
    camera.target = {1, 0, 0};
    camera.fov_y_deg = 90;
    camera.aspect = 1;
    culler.cull(camera, options, view);
    for (double x = 1; x < 0x1p99; x *= 2) {
      for (const double y : {x, -x}) {
        EXPECT_NE(view.visibility(Aabb{{x, y, 0}, {x, y, 0}}), Visibility::out_of_view) << x;
        EXPECT_NE(view.visibility(Aabb{{x, 0, y}, {x, 0, y}}), Visibility::out_of_view) << x;
        if (x > 2) {
          EXPECT_EQ(view.visibility(Aabb{{x / 2, y, 0}, {x / 2, y, 0}}), Visibility::out_of_view) << x;
        }
      }
      EXPECT_EQ(view.visibility(Aabb{{-x, 0, 0}, {-x, 0, 0}}), Visibility::out_of_view) << x;
    }
  }
}

PolygonSoup triangle() {
  PolygonSoup soup;
  add(soup, {{2, -1, -1}, {2, 1, -1}, {2, 0, 1}});
  add(soup, {{3, -1, -1}, {3, 1, -1}, {3, 0, 1}});
  return soup;
}

/// The refusal of a soup, for which the culler and an occluder mesh must give the same text.
template <class Change>
std::string refusal_of_soup(const Change& change) {
  PolygonSoup soup = triangle();
  change(soup);
  const std::string by_culler = refusal([&] { static_cast<void>(Culler(soup)); });
  EXPECT_EQ(by_culler, refusal([&] { static_cast<void>(OccluderMesh(soup)); }));
  return by_culler;
}

TEST(Soup, IsRefusedUnlessWellFormed) {
  EXPECT_EQ(refusal_of_soup([](PolygonSoup&) {}), "");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.indices[4] = 6; }), "polygon 1: corner 1 is vertex 6 of 6");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.indices[0] = 4294967295U; }),
            "polygon 0: corner 0 is vertex 4294967295 of 6");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first = {0, 2, 6}; }), "polygon 0: fewer than 3 corners");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first = {0, 3, 3, 6}; }), "polygon 1: fewer than 3 corners");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) {
              soup.first = {0, 6, 3};
            }),
            "polygon 1: its corners are not among the indices");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) {
              soup.first = {0, 3, 7};
            }),
            "polygon 1: its corners are not among the indices");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first = {0, 3}; }), "the soup has indices after its last polygon");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first = {1, 3, 6}; }), "the soup's `first` does not begin with 0");
  EXPECT_EQ(refusal_of_soup([](PolygonSoup& soup) { soup.first.clear(); }), "the soup's `first` does not begin with 0");
}

TEST(Soup, NumbersDoNotWrap) {
  EXPECT_EQ(PolygonSoup::narrowed(4294967295U), 4294967295U);
  EXPECT_THROW(static_cast<void>(PolygonSoup::narrowed(4294967296U)), std::length_error);
}

TEST(Clearance, WithoutAShadowThereIsNone) {
  const kernel::ShadowFrustum none;
  const Aabb box{{3, 0, 0}, {4, 1, 1}};
  const kernel::Obb oriented{{3, 0, 0}, {}};
  EXPECT_EQ(clearance(none, box).distance, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(clearance(none, oriented).distance, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(certain_distance(none, box), 0);
  EXPECT_EQ(certain_distance(none, oriented), 0);
  for (const ShadowMargin& margin : {ShadowMargin(), ShadowMargin(FrameView(camera_at(0), 100), 0.01)}) {
    EXPECT_FALSE(margin.keeps(none, box));
    EXPECT_FALSE(margin.keeps(none, oriented));
    EXPECT_FALSE(margin.keeps(kernel::ShadowUnion{none, none}, box));
  }
}

TEST(Rounding, NothingIsCulledUnlessToNearest) {
  const Culler culler(triangle()), unprepared(triangle());
  const Scene scene;
  View view;
  SceneView scene_view;
  culler.cull(camera_at(0), {.method = Method::frusta}, view);
  for (const int mode : kOtherRoundings) {
    const WithRounding other(mode);
    for (const Method method : {Method::frusta, Method::cover}) {
      CullOptions options{.method = Method::frusta};
      options.method = method;
      EXPECT_THROW(culler.cull(camera_at(1), options, view), std::runtime_error);
    }
    EXPECT_THROW(scene.cull(camera_at(1), {}, scene_view), std::runtime_error);
    EXPECT_THROW(static_cast<void>(scene_view.visibility(Aabb{{3, 0, 0}, {3, 0, 0}})), std::runtime_error);
    EXPECT_THROW(static_cast<void>(view.visibility(Aabb{{3, 0, 0}, {3, 0, 0}})), std::runtime_error);
    EXPECT_THROW(static_cast<void>(Culler(triangle())), std::runtime_error);
    for (const Method method : {Method::frusta, Method::cover}) EXPECT_THROW(unprepared.prepare(method), std::runtime_error);
    EXPECT_THROW(static_cast<void>(occluders_of(unprepared)), std::runtime_error);
    EXPECT_THROW(static_cast<void>(unprepared.parts()), std::runtime_error);
    EXPECT_THROW(static_cast<void>(OccluderMesh(triangle())), std::runtime_error);
  }
}

}  // namespace contracts_test
