// SPDX-License-Identifier: MIT
// The small scenes of tests/data/scenes from many eyes: no triangle that the culler leaves out shows, by exact visibility.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "exact_visibility.h"
#include "occlude/culler/culler.h"
#include "occlude/fuzz/random.h"
#include "occlude/render/model_io.h"

namespace scenes_test {

using namespace occlude;
using namespace occlude::culler;
using fuzz::Random;
using glm::dvec3;

constexpr std::size_t kEyes = 1000;
constexpr std::uint64_t kSeed = 1997;

std::vector<std::filesystem::path> scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(OCCLUDE_SCENES)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::string name_of(const testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name = info.param.stem().string();
  std::ranges::replace(name, '-', '_');
  return name;
}

/// Places for eyes: anywhere around the scene, and on planes, edges and vertices of its polygons.
class Eyes {
 public:
  Eyes(SoupView soup, std::uint64_t seed) : soup_(soup), random_(seed) {
    low_ = high_ = soup.vertices.front();
    for (const dvec3& v : soup.vertices) {
      low_ = glm::min(low_, v);
      high_ = glm::max(high_, v);
    }
  }

  Camera next() {
    Camera camera;
    do {
      camera = any();
    } while (!fault(camera).empty());
    return camera;
  }

 private:
  Camera any() {
    const double extent = glm::distance(low_, high_);
    Camera camera;
    camera.eye = eye();
    camera.target = random_.index(2) == 0 ? anywhere() : vertex();
    camera.fov_y_deg = random_.real(20, 120);
    camera.near_plane = extent * std::array{0x1p-20, 0x1p-9, 0x1p-5}[random_.index(3)];
    if (random_.index(4) == 0) camera.far_plane = extent * random_.real(0.2, 1);
    if (random_.index(4) == 0) {
      camera.projection = Projection::orthographic;
      camera.height = extent * random_.real(0.1, 1);
    }
    return camera;
  }

  dvec3 eye() {
    const auto loop = soup_.loop(random_.index(soup_.size()));
    const auto corner = [&](std::size_t i) { return soup_.vertices[loop[i % loop.size()]]; };
    const std::size_t i = random_.index(loop.size());
    // Quarters are exact where the coordinates are short, so that the eye is exactly on the plane.
    const auto factor = [&] { return random_.integer(-12, 12) / 4.0; };
    switch (random_.index(6)) {
      case 0:
        return corner(i);
      case 1:
        return corner(i) + factor() * (corner(i + 1) - corner(i));
      case 2:
        return corner(i) + factor() * (corner(i + 1) - corner(i)) + factor() * (corner(i + 2) - corner(i));
      case 3:  // in front of the scene, as on the paths of viewers
        return {low_.x - random_.real(0, 0.5) * (high_.x - low_.x), random_.real(low_.y, high_.y),
                random_.real(low_.z, high_.z)};
      default:
        return anywhere();
    }
  }

  dvec3 vertex() { return soup_.vertices[random_.index(soup_.vertices.size())]; }

  dvec3 anywhere() {
    const dvec3 margin = (high_ - low_) / 4.0;
    const double x = random_.real(low_.x - margin.x, high_.x + margin.x);
    const double y = random_.real(low_.y - margin.y, high_.y + margin.y);
    return {x, y, random_.real(low_.z - margin.z, high_.z + margin.z)};
  }

  SoupView soup_;
  Random random_;
  dvec3 low_, high_;
};

CullOptions options_of(std::size_t frame) {
  CullOptions options;
  options.test = frame % 2 == 0 ? kernel::Test::conservative : kernel::Test::overlap;
  options.shadow_near = frame / 2 % 3 == 0 ? kernel::Near::farthest : kernel::Near::surface;
  options.unions = frame / 6 % 2 == 0;
  options.occluders = frame % 5 == 0 ? 32 : 8;
  return options;
}

std::vector<bool> drawn_triangles(const Culler& culler, const CullResult& frame) {
  const Hierarchy& hierarchy = culler.hierarchy();
  std::vector<bool> drawn(hierarchy.first_triangle(hierarchy.soup().size()), false);
  for (const PolygonRange& range : frame.drawn) {
    for (std::size_t t = hierarchy.first_triangle(range.first); t < hierarchy.first_triangle(range.first + range.count); ++t)
      drawn[t] = true;
  }
  return drawn;
}

class Scenes : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Scenes, NothingThatShowsIsCulled) {
  const PolygonSoup soup = render::read_model(GetParam()).soup;
  std::vector<Culler> cullers;
  for (const Bounds bounds : {Bounds::aabb, Bounds::obb}) {
    for (const std::uint32_t leaf : {1U, 4U}) {
      cullers.emplace_back(soup, BuildConfig{.hierarchy = {.leaf_size = leaf, .bounds = bounds},
                                             .occluders = {.shells = leaf == 1},
                                             .lists = {.threshold = 1e-3, .regions = 64}});
    }
  }
  std::vector<View> views(cullers.size());
  Eyes eyes(soup, kSeed);
  std::size_t shown = 0, hidden = 0, culled = 0;
  for (std::size_t frame = 0; frame < kEyes; ++frame) {
    const Camera camera = eyes.next();
    const std::size_t which = frame % cullers.size();
    const Culler& culler = cullers[which];
    // Half of the frames depend on those before them.
    const CullResult alone = culler.cull(camera, options_of(frame));
    const CullResult& result = frame / 4 % 2 == 0 ? alone : culler.cull(camera, options_of(frame), views[which]);
    const std::vector<bool> drawn = drawn_triangles(culler, result);
    const std::vector<bool> shows = proof::visible_triangles(culler.hierarchy().soup(), camera);
    for (std::size_t t = 0; t < drawn.size(); ++t) {
      ASSERT_LE(shows[t], drawn[t]) << "seed " << kSeed << ", frame " << frame << ": triangle " << t
                                    << " shows and is culled";
      ++(shows[t] ? shown : hidden);
    }
    culled += result.stats.shadow_culled_polygons;
  }
  EXPECT_GT(shown, kEyes / 2);
  EXPECT_GT(hidden, kEyes / 2);
  EXPECT_GT(culled, kEyes / 10) << "what culls nothing is never wrong";
  std::printf("%zu triangles shown, %zu hidden or out of view, %zu polygons culled by shadow\n", shown, hidden, culled);
}

INSTANTIATE_TEST_SUITE_P(All, Scenes, testing::ValuesIn(scenes()), name_of);

}  // namespace scenes_test
