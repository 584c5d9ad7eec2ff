// SPDX-License-Identifier: MIT
// A frame as the culler returns it is right. Everything that can be wrong with a frame is named.
#include "differential/cull_judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "culler/scenes.h"
#include "frame/culler_access.h"

namespace occlude::fuzz {
namespace cull_judge_test {

using culler::Camera;
using culler::Culled;
using culler::Culler;
using culler::CullOptions;
using culler::CullResult;
using glm::dvec3;

void add_triangle(culler::PolygonSoup& soup, const dvec3& at) {
  culler::add(soup, {at, at + dvec3{0, 1, 0}, at + dvec3{0, 0, 1}});
}

/// A leaning wall from x = 5 to x = 6, a triangle in front of it, two behind it, and one on each side of the picture.
culler::PolygonSoup scene() {
  culler::PolygonSoup soup;
  culler::add(soup, {{5, -4, -4}, {5, 4, -4}, {6, 4, 4}, {6, -4, 4}});
  for (const dvec3 at : {dvec3{3, -2, 0}, dvec3{20, 0, 0}, dvec3{30, 5, 0}, dvec3{8, 90, 0}, dvec3{8, -90, 0}}) {
    add_triangle(soup, at);
  }
  return soup;
}

class CullJudgeTest : public testing::Test {
 protected:
  CullJudgeTest() { camera_.target = {1, 0, 0}; }

  /// The judge's verdict on the frame after this change.
  std::string fault_after(const std::function<void(CullResult&)>& change) const {
    CullResult result = culler_.cull(camera_, options_);
    change(result);
    return fault_of(culler_, camera_, options_, result);
  }

  static Culled& first(CullResult& result, Culled::By by) { return *std::ranges::find(result.culled, by, &Culled::by); }

  /// The region that has this polygon.
  std::uint32_t region_of(std::uint32_t polygon) const {
    std::uint32_t region = 0;
    while (std::ranges::count(occluders_of(culler_).parts(region), polygon) == 0) ++region;
    return region;
  }

  std::size_t polygons(const Culled& culled) const { return culler_.hierarchy().nodes()[culled.node].count; }

  Culler culler_{scene(), {.hierarchy = {.leaf_size = 1}, .lists = {}}};
  Camera camera_;
  CullOptions options_{.method = culler::Method::frusta};
};

TEST_F(CullJudgeTest, FindsNothingWrongWithAFrame) {
  EXPECT_EQ(fault_after([](CullResult& result) {
              EXPECT_EQ(result.stats.drawn_polygons, 2U);
              EXPECT_EQ(result.stats.shadow_culled_polygons, 2U);
              EXPECT_EQ(result.stats.view_culled_polygons, 2U);
            }),
            "");
}

TEST_F(CullJudgeTest, NamesWhatIsWrongWithTheRanges) {
  EXPECT_EQ(fault_after([](CullResult& result) { result.drawn.push_back(result.drawn.front()); }),
            "a polygon is drawn twice, or there is none");
  EXPECT_EQ(fault_after([](CullResult& result) {
              result.drawn.push_back({100, 1});
            }),
            "a polygon is drawn twice, or there is none");
  EXPECT_EQ(fault_after([](CullResult& result) {
              result.drawn.push_back({0, 0});
            }),
            "a polygon is drawn twice, or there is none");
  EXPECT_EQ(fault_after([](CullResult& result) {
              std::vector<culler::PolygonRange> apart;
              for (const auto [begin, count] : result.drawn) {
                for (auto p = begin; p < begin + count; ++p) apart.insert(apart.begin(), {p, 1});
              }
              result.drawn = std::move(apart);
            }),
            "what is drawn is not in order, or not merged");
  EXPECT_EQ(fault_after([](CullResult& result) { result.culled.front().node = 1000; }),
            "a node is culled that does not exist");
  EXPECT_EQ(fault_after([](CullResult& result) { result.culled.push_back(result.culled.front()); }),
            "a polygon is drawn and culled, or culled twice");
  EXPECT_EQ(fault_after([](CullResult& result) { result.culled.pop_back(); }), "a polygon is neither drawn nor culled");
}

TEST_F(CullJudgeTest, NamesWrongCounts) {
  EXPECT_EQ(fault_after([](CullResult& result) { ++result.stats.drawn_polygons; }), "the counts are wrong");
  EXPECT_EQ(fault_after([](CullResult& result) { result.occluders.resize(100, result.occluders.front()); }),
            "the counts are wrong");
}

TEST_F(CullJudgeTest, NamesWhatIsDrawnOnlyWithOccluders) {
  EXPECT_EQ(fault_after([&](CullResult& result) {
              const auto beyond = std::ranges::find(result.culled, Culled::By::view, &Culled::by);
              const auto& node = culler_.hierarchy().nodes()[beyond->node];
              result.drawn.push_back({node.first, node.count});
              std::ranges::sort(result.drawn, {}, &culler::PolygonRange::first);
              result.stats.view_culled_polygons -= node.count;
              result.stats.drawn_polygons += node.count;
              result.culled.erase(beyond);
              // Adjacent ranges must be merged.
              for (std::size_t i = 1; i < result.drawn.size();) {
                auto& before = result.drawn[i - 1];
                if (before.first + before.count != result.drawn[i].first) {
                  ++i;
                  continue;
                }
                before.count += result.drawn[i].count;
                result.drawn.erase(result.drawn.begin() + static_cast<std::ptrdiff_t>(i));
              }
            }),
            "a polygon is drawn with occluders and not without");
}

TEST_F(CullJudgeTest, NamesCullsWithoutAReason) {
  for (const Culled::By by : {Culled::By::view, Culled::By::shadow}) {
    EXPECT_EQ(fault_after([&](CullResult& result) { first(result, by).index = 1000; }),
              "a subtree is culled by what does not exist");
  }
}

TEST_F(CullJudgeTest, NamesUnprovedCullsByView) {
  EXPECT_EQ(fault_after([](CullResult& result) {
              for (auto& half_space : result.view) half_space.offset -= 100;
            }),
            "a plane of the view cuts off what the camera shows");
  const std::string fault = fault_after([](CullResult& result) {
    // The other side of the view proves nothing about what is beyond one side.
    const auto is_by_view = [](const Culled& culled) { return culled.by == Culled::By::view; };
    Culled& one = first(result, Culled::By::view);
    Culled& other = *std::find_if(&one + 1, result.culled.data() + result.culled.size(), is_by_view);
    std::swap(one.index, other.index);
  });
  EXPECT_EQ(fault.rfind("culled by view: ", 0), 0U) << fault;
}

TEST_F(CullJudgeTest, NamesUnprovedCullsByShadow) {
  const auto with_region = [](std::uint32_t region) {
    return [region](CullResult& result) { result.occluders[first(result, Culled::By::shadow).index].index = region; };
  };
  EXPECT_EQ(fault_after(with_region(1000)), "there is no such occluder");
  EXPECT_EQ(fault_after([&](CullResult& result) {
              const Culled& culled = first(result, Culled::By::shadow);
              result.occluders[culled.index].index = region_of(culler_.hierarchy().nodes()[culled.node].first);
            }),
            "an occluder culls itself");
  std::size_t wrong = 0;
  for (std::uint32_t region = 0; region < occluders_of(culler_).size(); ++region) {
    wrong += fault_after(with_region(region)).rfind("culled by shadow: ", 0) == 0 ? 1U : 0U;
  }
  EXPECT_GE(wrong, 3U);
}

TEST_F(CullJudgeTest, NamesAnOccluderThatTheNearPlaneClips) {
  culler::PolygonSoup soup;
  culler::add(soup, {{5, -4, -4}, {5, 4, -4}, {6, 4, 4}, {6, -4, 4}});
  add_triangle(soup, {20, 0, 0});
  const Culler culler(soup, {.hierarchy = {.leaf_size = 1}, .lists = {}});
  const CullResult result = culler.cull(camera_, options_);
  EXPECT_EQ(result.stats.shadow_culled_polygons, 1U);
  camera_.near_plane = 5.5;
  EXPECT_EQ(fault_of(culler, camera_, options_, result), "the near plane clips an occluder");
}

/// Two walls that meet at an angle, an object behind both, and a triangle below their shadows. The object goes from y = -2
/// to 2 and reaches up to z = `high`. Seen from the origin, the shadows are where |y| <= x and |z| <= 2 x - |y|.
culler::PolygonSoup corner(double high) {
  culler::PolygonSoup soup;
  culler::add(soup, {{4, -4, -4}, {2, 0, -4}, {2, 0, 4}, {4, -4, 4}});
  culler::add(soup, {{2, 0, -4}, {4, 4, -4}, {4, 4, 4}, {2, 0, 4}});
  culler::add(soup, {{10, -2, 0}, {10, 2, 0}, {10, 2, high}, {10, -2, high}});
  culler::add(soup, {{3, -1, -9}, {3, 1, -9}, {3, 0, -8}});
  return soup;
}

class UnionJudgeTest : public testing::Test {
 protected:
  UnionJudgeTest() {
    camera_.target = {1, 0, 0};
    camera_.fov_y_deg = 150;
    options_.unions = true;
  }

  static Culler culler_of(double high) {
    return Culler(corner(high), {.hierarchy = {.leaf_size = 1}, .lists = {.threshold = 1e-6, .regions = 1}});
  }

  CullResult cull(const Culler& culler) const { return culler.cull(camera_, options_); }

  static Culled* by_two(CullResult& result) {
    const auto found = std::ranges::find_if(result.culled, [](const Culled& c) { return c.second != Culled::kNone; });
    return found == result.culled.end() ? nullptr : &*found;
  }

  /// The judge's verdict on the frame after this change to what two occluders culled.
  std::string fault_after(const std::function<void(CullResult&, Culled&)>& change) const {
    const Culler culler = culler_of(1);
    CullResult result = cull(culler);
    Culled* const culled = by_two(result);
    if (!culled) return "nothing is culled by two";
    change(result, *culled);
    return fault_of(culler, camera_, options_, result);
  }

  Camera camera_;
  CullOptions options_{.method = culler::Method::frusta};
};

TEST_F(UnionJudgeTest, FindsNothingWrongWithACullByTwo) {
  EXPECT_EQ(fault_after([](CullResult&, Culled&) {}), "");
  EXPECT_EQ(fault_after([](CullResult&, Culled& culled) { std::swap(culled.index, culled.second); }), "");
}

TEST_F(UnionJudgeTest, NamesWhatOneOfTheTwoDoesNotHide) {
  const std::string not_in_one = "culled by shadow: the box is not inside the frustum";
  EXPECT_EQ(fault_after([](CullResult&, Culled& culled) { culled.second = Culled::kNone; }), not_in_one);
  EXPECT_EQ(fault_after([](CullResult&, Culled& culled) {
              culled.index = culled.second;
              culled.second = Culled::kNone;
            }),
            not_in_one);
  EXPECT_EQ(fault_after([](CullResult&, Culled& culled) { culled.second = culled.index; }),
            "culled by shadow: the box is not inside the union of the frusta");
}

TEST_F(UnionJudgeTest, NamesASecondOccluderThatIsNone) {
  EXPECT_EQ(fault_after([](CullResult&, Culled& culled) { culled.second = 1000; }),
            "a subtree is culled by what does not exist");
  EXPECT_EQ(fault_after([](CullResult& result, Culled& culled) { result.occluders[culled.second].index = 1000; }),
            "there is no such occluder");
  const Culler culler = culler_of(1);
  CullResult result = cull(culler);
  Culled* const culled = by_two(result);
  ASSERT_NE(culled, nullptr);
  result.occluders[culled->second].index = culler.hierarchy().nodes()[culled->node].first;
  EXPECT_EQ(fault_of(culler, camera_, options_, result), "an occluder culls itself");
}

TEST_F(UnionJudgeTest, NamesABoxThatSticksOutByAnUlp) {
  const Culler inside = culler_of(18), outside = culler_of(std::nextafter(18, 19));
  CullResult hides = cull(inside), shows = cull(outside);
  Culled* const culled = by_two(hides);
  ASSERT_NE(culled, nullptr) << "what reaches the edge of both shadows is hidden";
  ASSERT_EQ(by_two(shows), nullptr) << "what reaches an ulp beyond it is not";
  EXPECT_EQ(fault_of(outside, camera_, options_, hides), "culled by shadow: the box is not inside the union of the frusta")
      << "the one claimed of the other";
}

}  // namespace cull_judge_test
}  // namespace occlude::fuzz
