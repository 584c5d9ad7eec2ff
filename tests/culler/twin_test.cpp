// SPDX-License-Identifier: MIT
// A thousand views, each compared with its twin: a traversal that tests every half-space and every shadow at every node.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "frame/culler_access.h"
#include "frames.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "scenes.h"

namespace twin_test {

using namespace occlude;
using namespace occlude::culler;

/// With axis-aligned boxes it is enough to test the leaves, because the boxes above them hold theirs and cull no more. An
/// oriented box need not hold those below it, so the twin of such a tree goes down its blocks.
class Twin {
 public:
  Twin(const Culler& culler, const CullOptions& options, const CullResult& frame, const HierarchyBlocks& blocks,
       bool leaves_alone)
      : culler_(culler),
        hierarchy_(culler.hierarchy()),
        tree_(blocks.tree()),
        options_(options),
        frame_(frame),
        drawn_(hierarchy_.soup().size()) {
    if (!leaves_alone) visit_parts(0);
    for (std::uint32_t n = 0; leaves_alone && n < hierarchy_.nodes().size(); ++n) {
      if (hierarchy_.nodes()[n].is_leaf()) visit(n, TreeBlock::kNone);
    }
  }

  [[nodiscard]] const std::vector<bool>& drawn() const { return drawn_; }

 private:
  template <class Volume>
  bool is_culled(const HierarchyNode& node, const Volume& box) const {
    for (const HalfSpace& h : frame_.view) {
      if (kernel::relation(to_kernel(h), box, options_.arithmetic) == kernel::Relation::outside) return true;
    }
    for (const Occluder& o : frame_.occluders) {
      const auto decision = kernel::decide(o.frustum, box, options_.arithmetic, options_.test, kernel::NearBoundary::open);
      if (decision.relation == kernel::Relation::inside && !holds_part(culler_, node, o)) return true;
    }
    return false;
  }

  void visit_parts(std::uint32_t block) {
    for (std::size_t i = 0; i < tree_[block].size(); ++i) visit(tree_[block].node[i], tree_[block].below[i]);
  }
  void visit(std::uint32_t index, std::uint32_t below) {
    const HierarchyNode& node = hierarchy_.nodes()[index];
    if (hierarchy_.ask(index, [&](const auto& box) { return is_culled(node, box); })) return;
    if (!node.is_leaf()) return visit_parts(below);
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) drawn_[p] = true;
  }

  const Culler& culler_;
  const Hierarchy& hierarchy_;
  const BlockTree tree_;
  const CullOptions& options_;
  const CullResult& frame_;
  std::vector<bool> drawn_;
};

CullOptions some_options(std::mt19937& random) {
  CullOptions options{.method = Method::frusta};
  options.shadow_near = random() % 2 ? kernel::Near::surface : kernel::Near::farthest;
  options.test = random() % 2 ? kernel::Test::conservative : kernel::Test::overlap;
  options.occluders = std::array<std::size_t, 4>{0, 3, 8, 40}[random() % 4];
  options.probes = random() % 2 ? 8 : 0;
  if (random() % 4 == 0) options.objective.coherence = 0;
  return options;
}

/// A camera one step on, or somewhere else.
Camera next_camera(std::mt19937& random, const Camera& before) {
  if (random() % 8 == 0) return random_camera(random);
  Camera camera = before;
  const double x = uniform(random, -0.5, 0.5), y = uniform(random, -0.5, 0.5), turn = uniform(random, -0.1, 0.1);
  camera.eye += glm::dvec3{x, y, 0};
  camera.target += glm::dvec3{x + turn, y - turn, 0};
  return fault(camera).empty() ? camera : random_camera(random);
}

struct Tally {
  std::size_t shadow_culled = 0, by_shells = 0, by_pieces = 0, probe_tests = 0, frames = 0;
};

/// Compares views of one culler: half of them are independent, and half are along a path.
void compare(const Culler& culler, bool leaves_alone, std::uint32_t seed, int views, Tally& tally) {
  std::mt19937 random(seed);
  const HierarchyBlocks blocks(culler.hierarchy());
  Camera camera = random_camera(random);
  View view;
  for (int i = 0; i < views; ++i) {
    const CullOptions options = some_options(random);
    const bool is_followed = random() % 2 == 0;
    camera = is_followed ? next_camera(random, camera) : random_camera(random);
    CullResult alone;
    if (!is_followed) alone = culler.cull(camera, options);
    const CullResult& frame = is_followed ? culler.cull(camera, options, view) : alone;
    ASSERT_EQ(drawn_polygons(culler, frame), Twin(culler, options, frame, blocks, leaves_alone).drawn())
        << "seed " << seed << ", view " << i;
    const CullStats& stats = frame.stats;
    ASSERT_EQ(stats.drawn_polygons + stats.view_culled_polygons + stats.shadow_culled_polygons,
              culler.hierarchy().soup().size());
    ++tally.frames;
    tally.shadow_culled += stats.shadow_culled_polygons;
    tally.probe_tests += stats.probe_tests;
    for (const Occluder& o : frame.occluders) {
      if (occluders_of(culler).is_shell(o.index)) {
        tally.by_shells += o.hidden;
      } else if (occluders_of(culler).regions().piece(o.index)) {
        tally.by_pieces += o.hidden;
      }
    }
  }
}

/// L-shaped walls, which hide as pieces.
void add_angles(PolygonSoup& soup, std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  for (int i = 0; i < count; ++i) {
    const double x = uniform(random, -45, 45), y = uniform(random, -45, 45), s = uniform(random, 3, 8);
    add(soup, {{x, y, 0}, {x, y + s, 0}, {x, y + s, s / 2}, {x, y + s / 2, s / 2}, {x, y + s / 2, s}, {x, y, s}});
  }
}

TEST(Culler, AThousandViewsDrawWhatTheirTwinsDraw) {
  Tally with_shells, without;
  std::uint32_t seed = 20;
  for (const Bounds bounds : {Bounds::aabb, Bounds::obb}) {
    for (const bool shells : {true, false}) {
      PolygonSoup soup = random_town_of_houses(seed, 1500);
      add_angles(soup, seed, 40);
      for (glm::dvec3& v : soup.vertices) {  // so that oriented boxes pay
        if (bounds == Bounds::obb) v = {0.8 * v.x - 0.6 * v.y, 0.6 * v.x + 0.8 * v.y, v.z};
      }
      const Culler culler(soup, {.hierarchy = {.leaf_size = 4, .bounds = bounds}, .occluders = {.shells = shells}});
      ASSERT_EQ(culler.hierarchy().oriented() > 0, bounds == Bounds::obb);
      compare(culler, bounds == Bounds::aabb, seed, 250, shells ? with_shells : without);
      ASSERT_FALSE(HasFatalFailure());
      ++seed;
    }
  }
  EXPECT_EQ(with_shells.frames + without.frames, 1000U);
  // Something could have gone wrong in these views.
  EXPECT_GT(with_shells.shadow_culled, 50000U);
  EXPECT_GT(with_shells.by_shells, 10000U);
  EXPECT_GT(with_shells.by_pieces, 100U);
  EXPECT_GT(without.shadow_culled, 20000U);
  EXPECT_EQ(without.by_shells, 0U);
  EXPECT_GT(with_shells.probe_tests, 1000U);
}

}  // namespace twin_test
