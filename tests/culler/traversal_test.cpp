// SPDX-License-Identifier: MIT
// The traversal, which asks about the nodes of a block at once, answers as a descent that asks node by node does.
#include "descent/traversal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "camera/shadow_rule.h"
#include "executors.h"
#include "frame/culler_access.h"
#include "frame/view_memory.h"
#include "frusta/node_tests.h"
#include "model/append_range.h"
#include "model/bounds.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/culler.h"
#include "scenes.h"

namespace traversal_test {

using namespace occlude::culler;
namespace kernel = occlude::kernel;
using kernel::Relation;

constexpr std::uint32_t kSeed = 23;

/// Section 5 as the paper tells it: a recursion that tests one node after the other.
class Descent {
 public:
  Descent(const Culler& culler, const BlockTree& tree, const CullOptions& options, View::Memory& memory)
      : culler_(culler), tree_(tree), options_(options), memory_(memory), result_(memory.frame.result) {}

  void run() {
    static_cast<void>(memory_.frame.view_planes(options_.arithmetic));
    memory_.frusta.shrink_shadows(memory_.frame);
    const auto numbers = [](std::size_t size) {
      std::vector<std::uint32_t> result(size);
      for (std::uint32_t i = 0; i < size; ++i) result[i] = i;
      return result;
    };
    visit_parts(0, {numbers(memory_.frame.planes.size()),
                    numbers(result_.occluders.size()),
                    numbers(memory_.frusta.probes.size()),
                    {}});
  }

 private:
  struct Active {
    std::vector<std::uint32_t> planes, shadows, probes, holding;
  };

  void visit_parts(std::uint32_t block, const Active& above) {
    for (std::size_t i = 0; i < tree_[block].size(); ++i) visit(tree_[block].node[i], tree_[block].below[i], above);
  }
  void visit(std::uint32_t index, std::uint32_t below, const Active& above) {
    const HierarchyNode& node = culler_.hierarchy().nodes()[index];
    Active here;
    ++result_.stats.nodes_visited;
    if (is_culled(index, above, here)) return;
    ask_probes(index, above, here);
    const bool is_undecided =
        !here.planes.empty() || !here.shadows.empty() || (!here.probes.empty() && node.count > kProbed);
    if (is_undecided && !node.is_leaf()) {
      visit_parts(below, here);
    } else {
      append_range(result_.drawn, {node.first, node.count});
      result_.stats.drawn_polygons += node.count;
      for (const std::uint32_t probe : here.holding) memory_.frusta.probes[probe].hidden += node.count;
    }
  }

  bool is_culled(std::uint32_t index, const Active& above, Active& here) {
    for (const std::uint32_t plane : above.planes) {
      ++result_.stats.view_tests;
      const Relation relation = culler_.hierarchy().ask(
          index, [&](const auto& box) { return kernel::relation(memory_.frame.planes[plane], box, options_.arithmetic); });
      if (relation == Relation::outside) return cull({index, Culled::By::view, plane});
      if (relation == Relation::partial) here.planes.push_back(plane);
    }
    for (const std::uint32_t s : above.shadows) {
      ++result_.stats.shadow_tests;
      const Occluder& by = result_.occluders[s];
      const Relation relation = culler_.hierarchy().ask(index, [&](const auto& box) {
        return decide_cull(by.frustum, box, {options_.arithmetic, options_.test}, memory_.frusta.shrunk[s],
                           [&] { return holds_part(index, by.index); })
            .relation;
      });
      if (relation == Relation::inside) return cull({index, Culled::By::shadow, s});
      if (relation == Relation::partial) here.shadows.push_back(s);
    }
    for (const auto& [first, second] : result_.pairs) {
      const auto straddles = [&](std::uint32_t s) { return std::ranges::count(here.shadows, s) != 0; };
      if (!straddles(first) || !straddles(second)) continue;
      ++result_.stats.union_tests;
      const Occluder &a = result_.occluders[first], &b = result_.occluders[second];
      const Relation relation = culler_.hierarchy().ask(index, [&](const auto& box) {
        return decide_cull(kernel::ShadowUnion{a.frustum, b.frustum}, box, Asked{}, memory_.frame.margin,
                           [&] { return holds_part(index, a.index) || holds_part(index, b.index); })
            .relation;
      });
      if (relation == Relation::inside) return cull({index, Culled::By::shadow, first, second});
    }
    return false;
  }

  void ask_probes(std::uint32_t index, const Active& above, Active& here) {
    here.holding = above.holding;
    for (const std::uint32_t p : above.probes) {
      ++result_.stats.probe_tests;
      const Relation relation = culler_.hierarchy().ask(index, [&](const auto& box) {
        return decide_cull(memory_.frusta.probes[p].frustum, box, {.arithmetic = options_.arithmetic}, ShadowMargin())
            .relation;
      });
      if (relation == Relation::inside) here.holding.push_back(p);
      if (relation == Relation::partial) here.probes.push_back(p);
    }
  }

  bool cull(const Culled& culled) {
    const std::uint32_t count = culler_.hierarchy().nodes()[culled.node].count;
    result_.culled.push_back(culled);
    if (culled.by == Culled::By::view) {
      result_.stats.view_culled_polygons += count;
      return true;
    }
    result_.stats.shadow_culled_polygons += count;
    result_.occluders[culled.index].hidden += count;
    if (culled.second != Culled::kNone) result_.occluders[culled.second].hidden += count;
    return true;
  }

  bool holds_part(std::uint32_t node, std::uint32_t occluder) const {
    const HierarchyNode& n = culler_.hierarchy().nodes()[node];
    return std::ranges::any_of(occluders_of(culler_).parts(occluder),
                               [&](std::uint32_t p) { return p >= n.first && p < n.first + n.count; });
  }

  const Culler& culler_;
  const BlockTree& tree_;
  const CullOptions& options_;
  View::Memory& memory_;
  CullResult& result_;
};

/// A frame that is to be traversed: with the occluders of a culled one, of which every third is a probe instead. If the
/// frame has pairs, each occluder is paired with the next: any two may be.
void take_frame(const CullResult& frame, const ShadowMargin& margin, View::Memory& memory) {
  memory.frame.margin = margin;
  memory.frame.result.view = frame.view;
  for (std::size_t i = 0; i < frame.occluders.size(); ++i) {
    const Occluder occluder{frame.occluders[i].index, frame.occluders[i].frustum, 0};
    (i % 3 == 2 ? memory.frusta.probes : memory.frame.result.occluders).push_back(occluder);
  }
  if (frame.pairs.empty()) return;
  for (std::uint32_t i = 0; i + 1 < memory.frame.result.occluders.size(); ++i)
    memory.frame.result.pairs.push_back({i, i + 1});
}

auto what_hid(const std::vector<Occluder>& occluders) {
  std::vector<std::uint32_t> hidden;
  for (const Occluder& occluder : occluders) hidden.push_back(occluder.hidden);
  return hidden;
}

void expect_same(const View::Memory& expected, const View::Memory& found) {
  const CullResult &e = expected.frame.result, &f = found.frame.result;
  ASSERT_EQ(f.culled.size(), e.culled.size());
  for (std::size_t i = 0; i < e.culled.size(); ++i) {
    const auto told = [](const Culled& c) { return std::tuple(c.node, c.by, c.index, c.second); };
    EXPECT_EQ(told(f.culled[i]), told(e.culled[i])) << "cull " << i;
  }
  ASSERT_EQ(f.drawn.size(), e.drawn.size());
  for (std::size_t i = 0; i < e.drawn.size(); ++i) {
    EXPECT_EQ(f.drawn[i].first, e.drawn[i].first);
    EXPECT_EQ(f.drawn[i].count, e.drawn[i].count);
  }
  EXPECT_EQ(what_hid(f.occluders), what_hid(e.occluders));
  EXPECT_EQ(what_hid(found.frusta.probes), what_hid(expected.frusta.probes));
  EXPECT_EQ(f.stats.nodes_visited, e.stats.nodes_visited);
  EXPECT_EQ(f.stats.view_tests, e.stats.view_tests);
  EXPECT_EQ(f.stats.shadow_tests, e.stats.shadow_tests);
  EXPECT_EQ(f.stats.union_tests, e.stats.union_tests);
  EXPECT_EQ(f.stats.probe_tests, e.stats.probe_tests);
  EXPECT_EQ(f.stats.drawn_polygons, e.stats.drawn_polygons);
  EXPECT_EQ(f.stats.view_culled_polygons, e.stats.view_culled_polygons);
  EXPECT_EQ(f.stats.shadow_culled_polygons, e.stats.shadow_culled_polygons);
}

struct Case {
  const char* name;
  Bounds bounds = Bounds::aabb;
  CullOptions options = {.method = Method::frusta};
};

class TraversalTest : public testing::TestWithParam<Case> {};

TEST_P(TraversalTest, AnswersAsADescentNodeByNode) {
  BuildConfig config;
  config.hierarchy = {.leaf_size = 2, .bounds = GetParam().bounds};
  const Culler culler(random_town_of_houses(kSeed, 3000), config);
  const HierarchyBlocks blocks(culler.hierarchy());
  const BlockTree tree = blocks.tree();
  const auto unwatched = [](const TreeBlock&, const kernel::BlockQuestions&, kernel::BoxBytes) {};
  std::mt19937 random(kSeed);
  const std::vector<Executor> executors = some_executors();
  std::vector<View::Memory> memories(executors.size());
  std::size_t culled = 0, hidden_by_probes = 0, unions = 0;
  std::vector<std::size_t> deferred(executors.size());
  for (int frame = 0; frame < 40; ++frame) {
    Camera camera;
    camera.eye = {uniform(random, -50, 50), uniform(random, -50, 50), 2};
    camera.target = camera.eye + glm::dvec3{uniform(random, -1, 1), uniform(random, -1, 1), 0};
    if (frame % 4 == 3) camera.projection = Projection::orthographic;
    const CullResult seen = culler.cull(camera, GetParam().options);
    const FrameView view(camera, depth(culler.hierarchy().nodes()[0].box, camera.eye));
    const ShadowMargin margin(view, GetParam().options.margin);
    View::Memory expected;
    take_frame(seen, margin, expected);
    Descent(culler, tree, GetParam().options, expected).run();
    for (std::size_t i = 0; i < executors.size(); ++i) {
      View::Memory& found = memories[i];
      found.frusta.keep_spare(found.frame.result);
      found.frame.begin(culler.hierarchy().nodes().size());
      take_frame(seen, margin, found);
      CullOptions options = GetParam().options;
      options.executor = &executors[i];
      traverse(tree, culler.hierarchy(), &occluders_of(culler), unwatched, options, found.frame, found.frusta);
      expect_same(expected, found);
      ASSERT_FALSE(HasFailure()) << "frame " << frame << ", executor " << i << ", seed " << kSeed;
      EXPECT_EQ(found.frame.result.stats.exact_shadow_tests, memories[0].frame.result.stats.exact_shadow_tests);
      const std::size_t subtrees = found.frusta.parts.deferred.size;
      EXPECT_TRUE(subtrees == 0 || (executors[i].threads() > 1 && expected.frame.result.pairs.empty()));
      deferred[i] += subtrees;
    }
    culled += expected.frame.result.stats.shadow_culled_polygons;
    unions += expected.frame.result.stats.union_tests;
    for (const Occluder& probe : expected.frusta.probes) hidden_by_probes += probe.hidden;
  }
  EXPECT_GT(culled, 10000U);
  EXPECT_GT(hidden_by_probes, 1000U);
  EXPECT_EQ(unions > 100, GetParam().options.unions);
  for (std::size_t i = 0; i < executors.size(); ++i) EXPECT_EQ(deferred[i] > 50, executors[i].threads() > 1);
}

INSTANTIATE_TEST_SUITE_P(
    Options, TraversalTest,
    testing::Values(Case{"frusta"}, Case{"oriented", Bounds::obb},
                    Case{"many", Bounds::aabb, {.method = Method::frusta, .occluders = 40}},
                    Case{"overlap", Bounds::aabb, {.method = Method::frusta, .test = kernel::Test::overlap}},
                    Case{"plain", Bounds::aabb, {.method = Method::frusta, .arithmetic = kernel::Arithmetic::plain}},
                    Case{"farthest", Bounds::aabb, {.method = Method::frusta, .shadow_near = kernel::Near::farthest}},
                    Case{"margin", Bounds::aabb, {.method = Method::frusta, .margin = 0.002}},
                    Case{"unions", Bounds::aabb, {.method = Method::frusta, .occluders = 24, .unions = true}}),
    [](const auto& c) { return std::string(c.param.name); });

}  // namespace traversal_test
