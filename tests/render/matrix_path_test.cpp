// SPDX-License-Identifier: MIT
// Camera paths that are lists of matrices.
#include <gtest/gtest.h>

#include <string>

#include "folder_test.h"
#include "occlude/render/camera_path.h"

namespace occlude::render {
namespace matrix_path_test {

using glm::dvec3;

class MatrixPathTest : public FolderTest {
 protected:
  [[nodiscard]] CameraPath read(const std::string& name, const std::string& text, const PathDefaults& defaults = {}) const {
    return read_camera_path(save(name, text), defaults);
  }
  /// The message after the folder.
  [[nodiscard]] std::string failure(const std::string& name, const std::string& text) const {
    return failure_after(folder_ / "", [&] { return read(name, text); });
  }
};

// Cameras at (1, 2, 3) and (1, 2, 4) that look to +y, with z upwards.
constexpr const char* kRows = "1,0,0,1, 0,0,-1,2, 0,1,0,3, 0,0,0,1\n1,0,0,1, 0,0,-1,2, 0,1,0,4, 0,0,0,1\n";
constexpr const char* kColumns = "1,0,0,0, 0,0,1,0, 0,-1,0,0, 1,2,3,1\n1,0,0,0, 0,0,1,0, 0,-1,0,0, 1,2,4,1\n";

void expect_the_cameras(const CameraPath& path) {
  ASSERT_EQ(path.frames, 2U);
  EXPECT_EQ(path.camera(0, 1).eye, dvec3(1, 2, 3));
  EXPECT_EQ(path.camera(1, 1).eye, dvec3(1, 2, 4));
  for (const std::size_t frame : {0U, 1U}) {
    const culler::Camera::Axes axes = path.camera(frame, 1).axes();
    EXPECT_EQ(axes.forward, dvec3(0, 1, 0));
    EXPECT_EQ(axes.up, dvec3(0, 0, 1));
  }
}

TEST_F(MatrixPathTest, TheLastRowTellsTheOrder) {
  expect_the_cameras(read("rows.csv", kRows));
  expect_the_cameras(read("columns.txt", kColumns));
  expect_the_cameras(read("ROWS.CSV", kRows));
  expect_the_cameras(read("rows.csv.gz", kRows));
}

TEST_F(MatrixPathTest, TablesMayHaveAHeadingCommentsAndBlanks) {
  expect_the_cameras(read("rows.csv", std::string("a,b\n# made by hand\r\n\n") + kRows + "\n"));
  expect_the_cameras(read("rows.txt", "1 0 0 1  0 0 -1 2  0 1 0 3  0 0 0 1\r\n1\t0;0 1 0 0 -1 +2 0 1 0 4e0 0 0 0 1"));
}

TEST_F(MatrixPathTest, JsonHasListsRowsOrColumns) {
  const std::string first = "[[1,0,0,1],[0,0,-1,2],[0,1,0,3],[0,0,0,1]]", second = "[1,0,0,1,0,0,-1,2,0,1,0,4,0,0,0,1]";
  expect_the_cameras(read("list.json", "[" + first + "," + second + "]"));
  expect_the_cameras(read("members.json", R"({"matrices": [)" + first + "," + second + "]}"));
  expect_the_cameras(read("three.json", "[[[1,0,0,1],[0,0,-1,2],[0,1,0,3]], [[1,0,0,1],[0,0,-1,2],[0,1,0,4]]]"));
  expect_the_cameras(read("four.json", "[[[1,0,0],[0,0,1],[0,-1,0],[1,2,3]], [[1,0,0],[0,0,1],[0,-1,0],[1,2,4]]]"));
}

TEST_F(MatrixPathTest, OtherMembersAreThoseOfAPath) {
  const CameraPath path = read("path.json", R"({"matrices": [[1,0,0,1,0,0,-1,2,0,1,0,3,0,0,0,1],
      [1,0,0,1,0,0,-1,2,0,1,0,4,0,0,0,1]], "frames": 5, "fov_y_deg": 30, "near": 0.5, "up": [0, 0, 2]})");
  EXPECT_EQ(path.frames, 5U);
  EXPECT_EQ(path.camera(2, 1).eye, dvec3(1, 2, 3.5));
  EXPECT_EQ(path.fov_y_deg, 30);
  EXPECT_EQ(path.near, 0.5);
  EXPECT_EQ(path.up, dvec3(0, 0, 2));
}

TEST_F(MatrixPathTest, WhatMayBeRowsOrColumnsIsRefused) {
  // Turned cameras at the origin, and matrices without last row.
  const std::string turned = "0 0 -1 0 1 0 0 0 0 -1 0 0 0 0 0 1\n", twelve = "1 0 0 1 0 0 -1 2 0 1 0 3\n";
  EXPECT_EQ(failure("turned.csv", turned + turned),
            "turned.csv:1: the numbers may be rows or columns: give --matrix-order row or --matrix-order column");
  EXPECT_EQ(failure("twelve.csv", twelve + twelve),
            "twelve.csv:1: the numbers may be rows or columns: give --matrix-order row or --matrix-order column");
  EXPECT_EQ(failure("turned.json", "[[0,0,-1,0,1,0,0,0,0,-1,0,0,0,0,0,1],[0,0,-1,0,1,0,0,0,0,-1,0,0,0,0,0,1]]"),
            R"(turned.json: matrices[0]: the numbers may be rows or columns: write "order": "row" or "order": "column")");
  // What is said decides.
  const PathDefaults row{.up = {0, 0, 1}, .order = MatrixOrder::row}, column{.up = {0, 0, 1}, .order = MatrixOrder::column};
  EXPECT_EQ(read("turned.csv", turned + turned, row).camera(0, 1).axes().forward, dvec3(1, 0, 0));
  EXPECT_EQ(read("turned.csv", turned + turned, column).camera(0, 1).axes().forward, dvec3(0, 1, 0));
  EXPECT_EQ(read("twelve.csv", twelve + twelve, row).camera(0, 1).eye, dvec3(1, 2, 3));
  expect_the_cameras(read("said.json", R"({"order": "column", "matrices": [[1,0,0,0,0,1,0,-1,0,1,2,3],
                                           [1,0,0,0,0,1,0,-1,0,1,2,4]]})"));
  // Of those that are the same in either order nothing need be said.
  EXPECT_EQ(failure("still.csv", "1 0 0 0 0 -1 0 0 0 0 -1 0 0 0 0 1\n1 0 0 0 0 0 1 0 0 1 0 0 0 0 0 1\n"), "no error");
}

TEST_F(MatrixPathTest, FaultsNameTheMatrix) {
  const std::string good = "1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 1\n";
  EXPECT_EQ(failure("a.csv", ""), "a.csv: expected at least two lines, each with a matrix");
  EXPECT_EQ(failure("a.csv", good), "a.csv: expected at least two lines, each with a matrix");
  EXPECT_EQ(failure("a.csv", good + "1 2 3\n"), "a.csv:2: a matrix has 16 numbers, or 12, not 3");
  EXPECT_EQ(failure("a.csv", good + "1 2 x\n"), "a.csv:2: expected a number");
  EXPECT_EQ(failure("a.csv", good + "1 0 0 nan 0 1 0 2 0 0 1 3 0 0 0 1\n"), "a.csv:2: a number is not finite");
  EXPECT_EQ(failure("a.csv", good + "1 0 0 1e40 0 1 0 2 0 0 1 3 0 0 0 1\n"),
            "a.csv:2: x is out of range (neither 0 nor of magnitude 2^-100 to 2^100)");
  EXPECT_EQ(failure("a.csv", good + "1 0 0 1 0 0 0 2 0 0 1 3 0 0 0 1\n"),
            "a.csv:2: the second and third column are no axes of a camera");
  EXPECT_EQ(failure("a.json", R"({"order": "row", "matrices": [[1,0,0,1,0,1,0,2,0,0,1,3,0,0,0,1],
                                  [1,0,0,1,0,1,0,2,0,0,1,3,0,0,0.5,1]]})"),
            "a.json: matrices[1]: the last row of a camera's matrix is 0 0 0 1");
  EXPECT_EQ(failure("a.json", "[1, 2]"), "a.json: matrices[0]: expected an array of numbers");
  EXPECT_EQ(failure("a.json", "[[1, 2, 3], []]"), "a.json: matrices[0]: a matrix has 16 numbers, or 12, not 3");
  EXPECT_EQ(failure("a.json", "[[[1, 2, 3, 4, 5]], []]"), "a.json: matrices[0]: expected rows of 4 numbers");
  EXPECT_EQ(failure("a.json", "[[]]"), "a.json: matrices: expected an array of 2 to 1000000");
}

TEST_F(MatrixPathTest, ATiltedCameraStaysTilted) {
  // It looks to +y, rolled by a right angle: +x is upwards. Another looks straight down, with +y upwards.
  const CameraPath path = read("tilted.csv", "0 1 0 5 0 0 -1 0 -1 0 0 0 0 0 0 1\n1 0 0 0 0 1 0 0 0 0 1 5 0 0 0 1\n");
  EXPECT_EQ(path.camera(0, 1).axes().up, dvec3(1, 0, 0));
  EXPECT_EQ(path.camera(1, 1).axes().up, dvec3(0, 1, 0));
  EXPECT_EQ(path.camera(1, 1).axes().forward, dvec3(0, 0, -1));
}

TEST_F(MatrixPathTest, ALevelCameraHasTheUpOfThePath) {
  // It looks to +y, rolled by this angle: by one that single precision leaves, and by a larger one.
  const auto rolled = [](const std::string& angle) {
    const std::string line = "1 -" + angle + " 0 5 0 0 -1 0 " + angle + " 1 0 0 0 0 0 1\n";
    return line + line;
  };
  EXPECT_FALSE(read("level.csv", rolled("1e-7")).keyframes[1].up);
  EXPECT_TRUE(read("rolled.csv", rolled("1e-3")).keyframes[1].up);
}

TEST_F(MatrixPathTest, AFarCameraKeepsItsDirection) {
  const std::string far = "0.8 0 0.6 4e15 -0.6 0 0.8 2 0 -1 0 3 0 0 0 1\n";
  const CameraPath path = read("far.csv", far + far);
  EXPECT_NEAR(path.camera(0, 1).axes().forward.x, -0.6, 1e-15);
  EXPECT_NEAR(path.camera(0, 1).axes().forward.y, -0.8, 1e-15);
}

TEST_F(MatrixPathTest, RoundingNoiseIsZero) {
  const CameraPath path = read("noise.csv", "1 0 0 1e-40 0 1e-50 -1 2 0 1 0 3 0 0 0 1\n1 0 0 0 0 0 -1 2 0 1 0 3 0 0 0 1\n");
  EXPECT_EQ(path.camera(0, 1).eye, dvec3(0, 2, 3));
  EXPECT_GT(path.noise, 0U);
}

}  // namespace matrix_path_test
}  // namespace occlude::render
