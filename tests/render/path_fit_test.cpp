// SPDX-License-Identifier: MIT
// A path that was made for another model is doubted, and no other.
#include "occlude/render/path_fit.h"

#include <gtest/gtest.h>

namespace occlude::render {
namespace path_fit_test {

/// A cube of side 10 at the origin.
culler::PolygonSoup cube() {
  culler::PolygonSoup soup;
  soup.add_box({0, 0, 0}, {10, 10, 10});
  return soup;
}

CameraPath path_between(const glm::dvec3& first, const glm::dvec3& last) {
  CameraPath path;
  path.frames = 11;
  for (const glm::dvec3& eye : {first, last}) path.keyframes.push_back({eye, eye + glm::dvec3(1, 0, 0)});
  return path;
}

TEST(PathFit, DoubtsAPathThatNamesAnotherModel) {
  CameraPath path = path_between({5, 5, 5}, {6, 5, 5});
  EXPECT_EQ(doubt_about(path, "folder/sponza.ply", cube()), "");
  path.model = "sponza.ply";
  EXPECT_EQ(doubt_about(path, "folder/sponza.ply", cube()), "");
  EXPECT_EQ(doubt_about(path, "folder/sponza.obj", cube()), "");
  EXPECT_EQ(doubt_about(path, "folder/castle.ply", cube()), "made for sponza.ply, not for castle.ply");
}

TEST(PathFit, DoubtsAPathFarFromTheModel) {
  const auto doubt = [](const CameraPath& path) { return doubt_about(path, "cube.ply", cube()); };
  EXPECT_EQ(doubt(path_between({-9, 5, 5}, {-9, 6, 5})), "");
  EXPECT_EQ(doubt(path_between({-50, 5, 5}, {-50, 6, 5})), "the path is nowhere near cube.ply");
  CameraPath named = path_between({-50, 5, 5}, {-50, 6, 5});
  named.model = "cube.ply";
  EXPECT_EQ(doubt(named), "") << "who made it knew";
  // Through the model between two keyframes that are far from it.
  EXPECT_EQ(doubt(path_between({-50, 5, 5}, {50, 5, 5})), "");
  // From far, at the model.
  CameraPath telescope = path_between({-5000, 5, 5}, {-5000, 6, 5});
  telescope.keyframes[0].target = {5, 5, 5};
  EXPECT_EQ(doubt(telescope), "");
}

}  // namespace path_fit_test
}  // namespace occlude::render
