// SPDX-License-Identifier: MIT
// One mesh in many formats: the same triangles, area and box, whoever wrote the file.
#include <assimp/scene.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <assimp/Exporter.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "occlude/render/model_io.h"

namespace occlude::render {
namespace formats_test {

namespace fs = std::filesystem;
using culler::PolygonSoup;
using glm::dvec3;

/// Triangles and quadrilaterals, counter-clockwise.
struct Mesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::vector<unsigned>> faces;
};

/// A house of boxes that have no more digits than any format keeps.
Mesh house() {
  Mesh mesh;
  const auto add_box = [&](const std::array<float, 3>& low, const std::array<float, 3>& high) {
    const auto base = static_cast<unsigned>(mesh.vertices.size());
    for (unsigned i = 0; i < 8; ++i)
      mesh.vertices.push_back({(i & 1U ? high : low)[0], (i & 2U ? high : low)[1], (i & 4U ? high : low)[2]});
    for (const std::array<unsigned, 4>& side :
         {std::array{0U, 2U, 3U, 1U}, std::array{4U, 5U, 7U, 6U}, std::array{0U, 1U, 5U, 4U}, std::array{2U, 6U, 7U, 3U},
          std::array{0U, 4U, 6U, 2U}, std::array{1U, 3U, 7U, 5U}})
      mesh.faces.push_back({base + side[0], base + side[1], base + side[2], base + side[3]});
  };
  add_box({-10, -8, 0}, {10, 8, 6});
  add_box({-2.5F, -9.25F, 0}, {2.5F, -8, 3.125F});
  mesh.vertices.insert(mesh.vertices.end(), {{-10, -8, 6}, {10, -8, 6}, {0, 0, 11.5F}});
  mesh.faces.push_back({16, 17, 18});
  return mesh;
}

/// A wavy surface, with all digits of single precision.
Mesh surface() {
  constexpr unsigned kSide = 9;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(0, 0.5F);
  Mesh mesh;
  for (unsigned y = 0; y < kSide; ++y) {
    for (unsigned x = 0; x < kSide; ++x) {
      mesh.vertices.push_back(
          {100 * (static_cast<float>(x) + noise(random)), static_cast<float>(y) + noise(random), noise(random)});
      const unsigned a = y * kSide + x;
      if (x + 1 < kSide && y + 1 < kSide)
        mesh.faces.insert(mesh.faces.end(), {{a, a + 1, a + kSide}, {a + 1, a + kSide + 1, a + kSide}});
    }
  }
  return mesh;
}

using Corner = std::array<double, 3>;
using Triangle = std::array<Corner, 3>;

Triangle from_least_corner(Triangle triangle) {
  std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
  return triangle;
}

/// All triangles of all fans, whose order and first corners formats do not keep.
std::vector<Triangle> triangles(const PolygonSoup& soup) {
  std::vector<Triangle> all;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    const auto corner = [&](std::size_t i) {
      const dvec3& v = soup.vertices[loop[i]];
      return Corner{v.x, v.y, v.z};
    };
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      all.push_back(from_least_corner({corner(0), corner(i), corner(i + 1)}));
  }
  std::ranges::sort(all);
  return all;
}

std::vector<Triangle> triangles(const Mesh& mesh) {
  PolygonSoup soup;
  for (const auto& v : mesh.vertices) soup.add_vertex({v[0], v[1], v[2]});
  for (const auto& face : mesh.faces) soup.add_polygon(std::vector<std::uint32_t>(face.begin(), face.end()));
  return triangles(soup);
}

double area(const std::vector<Triangle>& all) {
  double sum = 0;
  const auto vec = [](const Corner& c) { return dvec3(c[0], c[1], c[2]); };
  for (const auto& [a, b, c] : all) sum += glm::length(glm::cross(vec(b) - vec(a), vec(c) - vec(a))) / 2;
  return sum;
}

std::pair<dvec3, dvec3> box(const PolygonSoup& soup) {
  dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const dvec3& v : soup.vertices) low = glm::min(low, v), high = glm::max(high, v);
  return {low, high};
}

Mesh in_triangles(const Mesh& mesh) {
  Mesh triangles{mesh.vertices, {}};
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) triangles.faces.push_back({face[0], face[i], face[i + 1]});
  }
  return triangles;
}

/// The mesh as a scene of the library, which its destructor takes apart.
std::unique_ptr<aiScene> scene_of(const Mesh& mesh) {
  auto scene = std::make_unique<aiScene>();
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mNumMaterials = 1;
  auto* const out = new aiMesh;
  out->mNumVertices = static_cast<unsigned>(mesh.vertices.size());
  out->mVertices = new aiVector3D[mesh.vertices.size()];
  out->mNormals = new aiVector3D[mesh.vertices.size()];
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    out->mVertices[i] = {mesh.vertices[i][0], mesh.vertices[i][1], mesh.vertices[i][2]};
    out->mNormals[i] = {0, 0, 1};
  }
  out->mNumFaces = static_cast<unsigned>(mesh.faces.size());
  out->mFaces = new aiFace[mesh.faces.size()];
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    out->mFaces[i].mNumIndices = static_cast<unsigned>(mesh.faces[i].size());
    out->mFaces[i].mIndices = new unsigned[mesh.faces[i].size()];
    std::ranges::copy(mesh.faces[i], out->mFaces[i].mIndices);
  }
  for (const auto& face : mesh.faces)
    out->mPrimitiveTypes |= face.size() == 3 ? aiPrimitiveType_TRIANGLE : aiPrimitiveType_POLYGON;
  scene->mMeshes = new aiMesh* [1] { out };
  scene->mNumMeshes = 1;
  auto* const node = new aiNode;
  node->mMeshes = new unsigned[1]{0};
  node->mNumMeshes = 1;
  scene->mRootNode = new aiNode;
  scene->mRootNode->addChildren(1, std::array{node}.data());
  return scene;
}

/// The mesh as the library writes it in the format of this name.
fs::path exported(const Mesh& mesh, const std::string& format, const fs::path& file) {
  Assimp::Exporter exporter;
  // Of larger faces it writes three corners into 3MF, which has triangles alone.
  const auto scene = scene_of(format == "3mf" ? in_triangles(mesh) : mesh);
  EXPECT_EQ(exporter.Export(scene.get(), format, file.string()), aiReturn_SUCCESS) << exporter.GetErrorString();
  return file;
}

/// The library writes no OFF.
fs::path written_as_off(const Mesh& mesh, const fs::path& file) {
  std::ofstream out(file);
  out.precision(std::numeric_limits<float>::max_digits10);
  out << "OFF\n" << mesh.vertices.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const auto& v : mesh.vertices) out << v[0] << ' ' << v[1] << ' ' << v[2] << '\n';
  for (const auto& face : mesh.faces) {
    out << face.size();
    for (const unsigned vertex : face) out << ' ' << vertex;
    out << '\n';
  }
  return file;
}

struct Format {
  const char *id, *extension;
  double error;  ///< of a number, as a share of it: the library writes some formats in few digits
};

class FormatsTest : public testing::TestWithParam<Format> {
 protected:
  FormatsTest() { fs::create_directories(folder_); }
  ~FormatsTest() override { fs::remove_all(folder_); }

  [[nodiscard]] Model read(const Mesh& mesh, const Conversion& conversion = {}) const {
    const auto& [id, extension, error] = GetParam();
    const fs::path file = folder_ / (std::string("a") + extension);
    return read_model(id == std::string("off") ? written_as_off(mesh, file) : exported(mesh, id, file),
                      {.conversion = conversion});
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("occlude_formats_" + std::to_string(getpid()));
};

TEST_P(FormatsTest, AHouseIsTheSameToTheLastBit) {
  const std::vector<Triangle> expected = triangles(house());
  const Model model = read(house());
  const std::vector<Triangle> found = triangles(model.soup);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(area(found), area(expected));
  EXPECT_EQ(box(model.soup), std::pair(dvec3(-10, -9.25, 0), dvec3(10, 8, 11.5)));
  EXPECT_EQ(text_of(model.notes), "");
}

TEST_P(FormatsTest, ASurfaceIsTheSameWithinThePrecisionOfTheFormat) {
  const std::vector<Triangle> expected = triangles(surface());
  const Model model = read(surface());
  const std::vector<Triangle> found = triangles(model.soup);
  ASSERT_EQ(found.size(), expected.size());
  double worst = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        worst = std::max(worst, std::fabs(found[i][k][c] - expected[i][k][c]) / std::max(1.0, std::fabs(expected[i][k][c])));
      }
    }
  }
  EXPECT_LE(worst, GetParam().error);
  EXPECT_NEAR(area(found), area(expected), 4 * GetParam().error * area(expected));
}

TEST_P(FormatsTest, UnitsAndAxesAreConvertedAlike) {
  std::vector<Triangle> expected = triangles(house());
  for (Triangle& triangle : expected) {
    for (Corner& c : triangle) c = {c[0] / 4, 0 - c[2] / 4, c[1] / 4};
    triangle = from_least_corner(triangle);
  }
  std::ranges::sort(expected);
  const Model model = read(house(), {true, true, {0.25, {0, 1, 0}}});
  EXPECT_EQ(triangles(model.soup), expected);
  EXPECT_EQ(model.notes.file, (Convention{0.25, {0, 1, 0}}));
  EXPECT_EQ(model.notes.convention, (Convention{1, {0, 0, 1}}));
}

// Binary FBX is missing: what the library writes, it cannot read.
INSTANTIATE_TEST_SUITE_P(All, FormatsTest,
                         testing::Values(Format{"obj", ".obj", 1e-8}, Format{"ply", ".ply", 0}, Format{"plyb", ".ply", 0},
                                         Format{"stl", ".stl", 0}, Format{"stlb", ".stl", 0}, Format{"off", ".off", 0},
                                         Format{"glb2", ".glb", 0}, Format{"gltf2", ".gltf", 0},
                                         Format{"fbxa", ".fbx", 1e-6}, Format{"collada", ".dae", 0},
                                         Format{"3ds", ".3ds", 0}, Format{"3mf", ".3mf", 1e-5}),
                         [](const auto& format) { return std::string(format.param.id); });

}  // namespace formats_test
}  // namespace occlude::render
