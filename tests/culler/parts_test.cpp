// SPDX-License-Identifier: MIT
#include "occlude/culler/parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "cover/cover_mesh.h"
#include "forged_parts.h"
#include "frame/culler_access.h"
#include "frames.h"
#include "model/bounds.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/culler.h"
#include "scenes.h"

namespace parts_test {

using namespace occlude::culler;
namespace kernel = occlude::kernel;

using U32 = std::uint32_t;
using U64 = std::uint64_t;

bool are_same(const CullResult& a, const CullResult& b) {
  const auto same_cull = [](const Culled& x, const Culled& y) {
    return x.node == y.node && x.by == y.by && x.index == y.index && x.second == y.second;
  };
  const auto same_occluder = [](const Occluder& x, const Occluder& y) { return x.index == y.index && x.hidden == y.hidden; };
  return a.drawn == b.drawn && std::ranges::equal(a.culled, b.culled, same_cull) &&
         std::ranges::equal(a.occluders, b.occluders, same_occluder);
}

/// A town with houses, which are shells; walls of two triangles, which are joined regions; and a polygon that is not convex,
/// which has pieces.
PolygonSoup varied_town(std::size_t polygons) {
  PolygonSoup soup = random_town_of_houses(9, polygons);
  for (int i = 0; i < 8; ++i) {
    add(soup, {{i, 20, 0}, {i, 24, 0}, {i, 24, 3}});
    add(soup, {{i, 20, 0}, {i, 24, 3}, {i, 20, 3}});
  }
  add(soup, {{0, 30, 0}, {0, 34, 0}, {0, 34, 3}, {0, 32, 1}, {0, 30, 3}});
  return soup;
}

Culler sampled(const PolygonSoup& soup, const BuildConfig& config) { return preprocess(soup, config, {.viewpoints = 1}); }

/// Frame by frame, by both methods, the culler of parts culls as the one that the parts are of.
TEST(Parts, GiveTheSameCuller) {
  const PolygonSoup soup = varied_town(1000);
  for (const BuildConfig& config : kSmallConfigs) {
    const Culler fresh = sampled(soup, config);
    const Culler prepared = ForgedParts(fresh).culler();
    EXPECT_EQ(prepared.hierarchy().oriented(), fresh.hierarchy().oriented());
    EXPECT_EQ(prepared.hierarchy().oriented() > 0, config.hierarchy.bounds == Bounds::obb);
    EXPECT_GT(occluders_of(prepared).shells().size(), 0U);
    EXPECT_EQ(occluders_of(prepared).shells().most_edges(), occluders_of(fresh).shells().most_edges());
    EXPECT_EQ(occluders_of(prepared).lists().longest(), occluders_of(fresh).lists().longest());
    EXPECT_EQ(prepared.config().lists.regions, config.lists.regions);
    for (std::size_t p = 0; p < soup.size(); ++p) {
      ASSERT_EQ(prepared.hierarchy().original(p), fresh.hierarchy().original(p));
    }
    for (const Method method : {Method::frusta, Method::cover}) {
      CullOptions options{.method = Method::frusta};
      options.method = method;
      constexpr std::uint32_t kSeed = 12;
      std::mt19937 random(kSeed);
      View of_fresh, of_prepared;
      std::size_t culled = 0;
      for (int frame = 0; frame < 60; ++frame) {
        const Camera camera = random_camera(random);
        ASSERT_TRUE(are_same(prepared.cull(camera, options), fresh.cull(camera, options))) << "seed " << kSeed;
        const CullResult& next = prepared.cull(camera, options, of_prepared);
        ASSERT_TRUE(are_same(next, fresh.cull(camera, options, of_fresh))) << "seed " << kSeed << ", frame " << frame;
        culled += next.culled.size();
      }
      EXPECT_GT(culled, 1000U);
    }
  }
}

/// Nothing is copied, and what is not copied stays.
TEST(Parts, AreUsedWhereTheyLie) {
  Parts parts = Culler(varied_town(100)).parts();
  const Culler culler(parts);
  const SoupView& soup = culler.hierarchy().soup();
  const auto bytes_of = [&](std::string_view name) {
    return std::ranges::find(parts.parts, name, &Part::name)->bytes.data();
  };
  EXPECT_EQ(std::as_bytes(soup.vertices).data(), bytes_of("vertices"));
  EXPECT_EQ(std::as_bytes(soup.indices).data(), bytes_of("indices"));
  EXPECT_EQ(std::as_bytes(soup.first).data(), bytes_of("first"));
  parts = {};
  std::mt19937 random(4);
  const Camera camera = random_camera(random);
  EXPECT_TRUE(are_same(culler.cull(camera, {.method = Method::frusta}),
                       Culler(varied_town(100)).cull(camera, {.method = Method::frusta})));
}

/// A culler of parts has the parts that it was made of, and two cullers of one model have the same.
TEST(Parts, AreTheSameBytes) {
  const PolygonSoup soup = varied_town(300);
  const ForgedParts first(sampled(soup, kSmallConfigs[0]));
  ForgedParts other(sampled(soup, kSmallConfigs[0])), again(first.culler());
  ASSERT_EQ(other.names(), first.names());
  ASSERT_EQ(again.names(), first.names());
  for (const std::string& name : first.names()) {
    EXPECT_EQ(other.bytes(name), first.get<std::byte>(name)) << name;
    EXPECT_EQ(again.bytes(name), first.get<std::byte>(name)) << name;
  }
  EXPECT_EQ(std::set<std::string>(first.names().begin(), first.names().end()).size(), first.names().size());
}

/// What frames by one method need may be left out.
TEST(Parts, OfAMethodMayBeLeftOut) {
  const Culler fresh(varied_town(300), kSmallConfigs[0]);
  ForgedParts bare(fresh);
  const std::vector<std::string> names = bare.names();
  std::size_t left_out = 0;
  for (const std::string& name : names) {
    if (!Culler::method_of(name)) continue;
    bare.erase(name);
    ++left_out;
  }
  EXPECT_EQ(left_out, 21U);
  const Culler culler = bare.culler();
  std::mt19937 random(2);
  for (const Method method : {Method::frusta, Method::cover}) {
    CullOptions options{.method = Method::frusta};
    options.method = method;
    const Camera camera = random_camera(random);
    EXPECT_TRUE(are_same(culler.cull(camera, options), fresh.cull(camera, options)));
  }
  for (const std::string& name : names) {
    ForgedParts lacking(fresh);
    lacking.erase(name);
    EXPECT_EQ(lacking.refusal(), "part \"" + name + "\": it is missing");
  }
}

class ForgedPart : public testing::Test {
 protected:
  template <class T, class Change>
  [[nodiscard]] std::string refusal(const std::string& name, Change&& change) const {
    ForgedParts forged(sound_);
    forged.edit<T>(name, change);
    return forged.refusal();
  }
  /// The refusal when element i is `value`.
  template <class T>
  [[nodiscard]] std::string with(const std::string& name, std::size_t i, const T& value) const {
    return refusal<T>(name, [&](std::vector<T>& elements) { elements.at(i) = value; });
  }

  PolygonSoup soup_ = varied_town(300);
  Culler culler_ = sampled(soup_, kSmallConfigs[0]);
  ForgedParts sound_{culler_};
  U32 polygons_ = static_cast<U32>(soup_.size()), vertices_ = static_cast<U32>(soup_.vertices.size());
};

/// No part may be a byte or an element shorter or longer, but what oriented boxes and samples may lack altogether.
TEST_F(ForgedPart, OfAnotherSize) {
  for (const std::string& name : sound_.names()) {
    ForgedParts cut(sound_), shorter(sound_), longer(sound_);
    const std::size_t element = sound_.element(name), size = sound_.get<std::byte>(name).size();
    longer.bytes(name).insert(longer.bytes(name).end(), element, std::byte{});
    const bool may_be_longer = name == "vertices" || name == "cover vertices" || name == "oriented boxes";  // unused ones
    EXPECT_EQ(longer.refusal().empty(), may_be_longer) << name << ": " << longer.refusal();
    if (size == 0) continue;
    cut.bytes(name).pop_back();
    EXPECT_EQ(cut.refusal(), "part \"" + name + "\": its elements have another size");
    shorter.bytes(name).resize(size - element);
    EXPECT_NE(shorter.refusal(), "") << name;
    shorter.bytes(name).clear();
    EXPECT_EQ(shorter.refusal().empty(), name == "hidden") << name;
  }
}

TEST_F(ForgedPart, OfTheSoup) {
  EXPECT_EQ(with("first", 0, U32{1}), "the soup's `first` does not begin with 0");
  EXPECT_TRUE(with("indices", 7, vertices_)
                  .ends_with("is vertex " + std::to_string(vertices_) + " of " + std::to_string(vertices_)));
  EXPECT_NE(with("first", 5, sound_.get<U32>("first")[4] + 2), "");
  const double nan = std::nan("");
  EXPECT_EQ((refusal<double>("vertices", [&](std::vector<double>& v) { v[3] = nan; })), "vertex 1: number is not finite");
  EXPECT_NE((refusal<double>("vertices", [&](std::vector<double>& v) { v[3] = 1e300; })), "");
  EXPECT_EQ(with("order", 3, sound_.get<U32>("order")[7]), "part \"order\": it does not number the polygons") << "twice";
  EXPECT_EQ(with("order", 0, polygons_), "part \"order\": it does not number the polygons");
}

TEST_F(ForgedPart, OfTheTree) {
  const std::string tree = "part \"nodes\": it is not a tree of these polygons";
  const auto change = [&](const std::function<void(std::vector<HierarchyNode>&)>& of) {
    return refusal<HierarchyNode>("nodes", of);
  };
  EXPECT_EQ(change([](auto&) {}), "");
  EXPECT_EQ(change([](auto& nodes) { nodes[0].right = static_cast<U32>(nodes.size()); }), tree);
  EXPECT_EQ(change([](auto& nodes) { nodes[0].right = 1; }), tree);
  EXPECT_EQ(change([](auto& nodes) { nodes[0].right = 0; }), tree);
  EXPECT_EQ(change([](auto& nodes) { ++nodes[0].count; }), tree);
  EXPECT_EQ(change([](auto& nodes) { ++nodes.back().first; }), tree);
  EXPECT_EQ(change([](auto& nodes) { nodes.back().right = 1; }), tree);
  EXPECT_EQ(change([](auto& nodes) { nodes[1].count = 0; }), tree);
  EXPECT_EQ(change([](auto& nodes) { nodes[1].count = nodes[0].count; }), tree);
  EXPECT_EQ(change([](auto& nodes) { nodes.clear(); }), tree);
  // A child without polygons, on the left or on the right, in a tree that is right in all else.
  const kernel::Aabb box = sound_.get<HierarchyNode>("nodes")[0].box;
  const HierarchyNode root{box, 0, polygons_, 2}, all{box, 0, polygons_, 0}, none{empty_box(), 0, 0, 0},
      none_left{empty_box(), polygons_, 0, 0};
  for (const std::vector<HierarchyNode>& nodes : {std::vector{root, none, all}, {root, all, none_left}}) {
    ForgedParts forged(sound_);
    forged.set("nodes", nodes);
    for (const std::string& name : sound_.names()) {
      if (Culler::method_of(name)) forged.erase(name);
    }
    EXPECT_EQ(forged.refusal(), tree);
  }
}

/// A box that is too small by the least that a double can be would let visible polygons be culled.
TEST_F(ForgedPart, OfTheBoxes) {
  const auto nodes = sound_.get<HierarchyNode>("nodes");
  const double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < nodes.size(); n += n < 20 ? 1 : 37) {
    for (int axis = 0; axis < 3; ++axis) {
      HierarchyNode smaller = nodes[n], larger = nodes[n];
      smaller.box.max[axis] = std::nextafter(smaller.box.max[axis], -infinity);
      larger.box.min[axis] = std::nextafter(larger.box.min[axis], -infinity);
      EXPECT_EQ(with("nodes", n, smaller), "part \"nodes\": a box is not that of its polygons") << n;
      EXPECT_EQ(with("nodes", n, larger), "part \"nodes\": a box is not that of its polygons") << n;
    }
  }
}

TEST(Parts, RefuseTreesDeeperThanAStack) {
  PolygonSoup soup;
  for (int i = 0; i < 20000; ++i) add(soup, {{i, 0, 0}, {i, 1, 0}, {i, 0, 1}});
  const Culler sound(soup, {.hierarchy = {.leaf_size = 4096}, .lists = {.regions = 1}});
  const auto chain = [&](U32 levels) {  // of one polygon each, and what is left
    ForgedParts forged(sound);
    const auto order = forged.get<U32>("order");
    const auto count = static_cast<U32>(soup.size());
    std::vector<kernel::Aabb> boxes_from(count);  // of a polygon and all after it
    for (U32 p = count; p-- > 0;) {
      boxes_from[p] = soup.box(order[p]);
      if (p + 1 < count) grow(boxes_from[p], boxes_from[p + 1]);
    }
    std::vector<HierarchyNode> nodes;
    for (U32 level = 0; level < levels; ++level) {
      nodes.push_back({boxes_from[level], level, count - level, 2 * level + 2});
      nodes.push_back({soup.box(order[level]), level, 1, 0});
    }
    nodes.push_back({boxes_from[levels], levels, count - levels, 0});
    std::vector<TreeBlock> blocks(levels);
    for (U32 level = 0; level < levels; ++level) {
      TreeBlock& block = blocks[level];
      block.add(nodes[2 * level + 1].box, {level, 1});
      block.add(nodes[2 * level + 2].box, {level + 1, count - level - 1});
      block.node[0] = 2 * level + 1;
      block.node[1] = 2 * level + 2;
      if (level + 1 < levels) block.divide(1, level + 1);
    }
    forged.set("nodes", nodes);
    forged.set("blocks", blocks);
    for (const std::string& name : std::vector<std::string>(forged.names())) {
      if (Culler::method_of(name)) forged.erase(name);
    }
    return forged;
  };
  for (const U32 levels : {kMostLevels + 1, U32{8192}, U32{19999}}) {
    EXPECT_EQ(chain(levels).refusal(), "part \"nodes\": the tree is deeper than 256 levels");
  }
  const Culler deepest = chain(kMostLevels).culler();
  Camera along;  // planes of its view cross every node, and the deepest ones are nearest
  along.eye = {20100, 0.25, 0.25};
  along.target = {0, 0.25, 0.25};
  along.projection = Projection::orthographic;
  along.height = 0.25;
  for (const Method method : {Method::frusta, Method::cover}) {
    const CullResult frame = deepest.cull(along, {.method = method, .occluders = 0});
    EXPECT_EQ(frame.stats.nodes_visited, 2 * kMostLevels);
  }
}

/// Cells of as many levels below the first, each with a region on its lower or its upper side.
std::vector<Partition::Cell> chain_of_cells(U32 levels, bool is_lower_region) {
  std::vector<Partition::Cell> cells(2 * std::size_t{levels} + 1);
  for (U32 i = 0; i < levels; ++i) {
    cells[is_lower_region ? 2 * i : i] = {static_cast<double>(i), i % 3, is_lower_region ? 2 * i + 2 : 2 * levels - i};
  }
  return cells;
}

TEST(Parts, RefuseCellsDeeperThanAStack) {
  const Culler sound(varied_town(100), kSmallConfigs[0]);
  for (const bool is_lower_region : {false, true}) {
    const auto with_levels = [&](U32 levels) {
      ForgedParts forged(sound);
      forged.set("cells", chain_of_cells(levels, is_lower_region));
      forged.set("list first", std::vector<U64>(std::size_t{levels} + 2));
      forged.set("listed", std::vector<U32>{});
      forged.set("hidden", std::vector<float>{});
      return forged.refusal();
    };
    EXPECT_EQ(with_levels(kMostLevels), "");
    EXPECT_EQ(with_levels(kMostLevels + 1), "part \"cells\": the tree is deeper than 256 levels");
    EXPECT_EQ(with_levels(100000), "part \"cells\": the tree is deeper than 256 levels");
  }
}

/// A model of a few bytes whose lists are left out asks for no more of them than these bytes, or a default, could hold.
TEST(Parts, AskForNoMoreListsThanTheyCouldHold) {
  const std::string regions = "part \"config\": it asks for more regions than its bytes could hold",
                    entries = "part \"config\": it asks for longer lists than its bytes could hold";
  const ListConfig few;
  const auto refusal = [&](RegionKind kind, double regions_wanted, U64 entries_wanted, U64 left_out) {
    ForgedParts forged(Culler(varied_town(100), small_config(Bounds::aabb, kind)));
    for (const std::string& name : std::vector<std::string>(forged.names())) {
      if (Culler::method_of(name) == Method::frusta) forged.erase(name);
    }
    forged.edit<double>("config", [&](auto& numbers) { numbers[3] = regions_wanted; });
    forged.edit<U64>("config", [&](auto& numbers) { numbers[4] = entries_wanted; });
    forged.left_out = left_out;
    return forged.refusal();
  };
  EXPECT_EQ(refusal(RegionKind::grid, few.regions, few.entries, 0), "");
  EXPECT_EQ(refusal(RegionKind::grid, 0x1p30, few.entries, 0), regions);
  EXPECT_EQ(refusal(RegionKind::grid, 1e6, few.entries, 0), regions);
  EXPECT_EQ(refusal(RegionKind::grid, 1e6, few.entries, 100'000'000), "") << "the cells themselves may be left out";
  EXPECT_EQ(refusal(RegionKind::tree, 0x1p30, few.entries, 0), "") << "there are no more than nodes";
  EXPECT_EQ(refusal(RegionKind::grid, few.regions, few.entries + 1, 0), entries);
  EXPECT_EQ(refusal(RegionKind::grid, few.regions, few.entries + 1, 200'000'000), "");
}

TEST_F(ForgedPart, OfOrientedBoxes) {
  const ForgedParts sound(Culler(soup_, kSmallConfigs[1]));
  const auto boxes = static_cast<U32>(sound.get<kernel::Obb>("oriented boxes").size());
  ForgedParts forged = sound;
  forged.edit<U32>("oriented", [&](auto& oriented) { oriented[3] = boxes; });
  EXPECT_EQ(forged.refusal(), "part \"oriented\": it does not number the oriented boxes");
  forged = sound;
  forged.edit<kernel::Obb>("oriented boxes", [&](auto& all) { all[2].center.x = std::nan(""); });
  EXPECT_EQ(forged.refusal(), "part \"oriented boxes\": a box is not legal");
}

TEST_F(ForgedPart, OfTheRegions) {
  const std::string region = "part \"region corners\": a region is not made of its polygons",
                    whole = "part \"whole\": a polygon is not in its region";
  const auto corners = sound_.get<U32>("region corners"), first = sound_.get<U32>("region first corner"),
             wholes = sound_.get<U32>("whole"), parts = sound_.get<U32>("region polygons"),
             first_part = sound_.get<U32>("region first polygon");
  const auto runs = sound_.get<FanRun>("pieces");
  const std::size_t regions = first.size() - 1, first_piece = regions - runs.size();
  ASSERT_GT(first_piece, polygons_);
  ASSERT_GT(runs.size(), 0U);
  for (const std::size_t r : {std::size_t{0}, std::size_t{polygons_}, first_piece, regions - 1}) {
    EXPECT_EQ(with("region corners", first[r] + 1, vertices_), region) << r;
    EXPECT_EQ(with("region corners", first[r] + 1, corners[first[r]]), region) << r << ": a corner twice";
    EXPECT_EQ(with("region polygons", first_part[r], polygons_), region) << r;
    EXPECT_NE(with("region first corner", r + 1, first[r]), "") << r << ": no corners";
  }
  EXPECT_EQ(with("region first corner", 1, U32{1} << 31U),
            "part \"region first corner\": the regions are not of these polygons");
  EXPECT_EQ(with("region first polygon", 1, U32{1} << 31U),
            "part \"region first corner\": the regions are not of these polygons");
  EXPECT_EQ(with("region polygons", first_part[polygons_], parts[first_part[polygons_] + 1]), region) << "a part twice";
  // A joined region that is larger than its polygons.
  const U32 elsewhere = corners[0];
  EXPECT_EQ(with("region corners", first[polygons_], elsewhere), region);
  // The corners of a joined region in another order, which goes over its edge.
  EXPECT_EQ(
      (refusal<U32>("region corners", [&](auto& all) { std::swap(all[first[polygons_]], all[first[polygons_] + 1]); })),
      region);
  for (const FanRun wrong : {FanRun{runs[0].first, runs[0].count + 1}, FanRun{runs[0].first, 0}, FanRun{0xFFFFFFFFU, 1},
                             FanRun{runs[0].first + 1, runs[0].count}}) {
    EXPECT_EQ(with("pieces", 0, wrong), region);
  }
  const U32 part = parts[first_part[polygons_]];
  EXPECT_NE(wholes[part], part);
  EXPECT_EQ(with("whole", part, part), region);
  for (const U32 wrong : {(part + 1) % polygons_, static_cast<U32>(regions), static_cast<U32>(first_piece)}) {
    EXPECT_NE(with("whole", part, wrong), "") << wrong;
  }
  const auto alone = static_cast<std::size_t>(std::ranges::mismatch(wholes, parts).in1 == wholes.begin() ? 1 : 0);
  ASSERT_EQ(wholes[alone], alone);
  EXPECT_EQ(with("whole", alone, polygons_), whole);
  EXPECT_EQ(with("whole", alone, static_cast<U32>(regions)), whole);
}

TEST_F(ForgedPart, OfTheShells) {
  const std::string shells = "part \"shell polygons\": the shells are not of these polygons";
  const auto parts = sound_.get<U32>("shell polygons"), of = sound_.get<U32>("shell of");
  ASSERT_GT(parts.size(), 12U);
  EXPECT_EQ(with("shell polygons", 0, polygons_), shells);
  EXPECT_EQ(with("shell polygons", 1, parts[0]), shells);
  EXPECT_EQ(with("shell first polygon", 1, U32{3}), shells);
  EXPECT_EQ(with("shell first polygon", 1, U32{1} << 31U), shells);
  EXPECT_EQ(with("shell of", parts[0], ConvexShells::kNone), shells);
  EXPECT_EQ(with("shell of", parts[0], U32{0x7FFFFFFFU}), shells);
  const auto none = static_cast<std::size_t>(std::ranges::find(of, ConvexShells::kNone) - of.begin());
  EXPECT_EQ(with("shell of", none, U32{0}), "part \"shell of\": a polygon is not in its shell");
  EXPECT_EQ(with("shell of", none, U32{0x7FFFFFFFU}), "part \"shell of\": a polygon is not in its shell");
  EXPECT_EQ(with("shell limits", 0, U64{65}), "part \"shell limits\": out of range");
  EXPECT_EQ(with("shell limits", 0, U64{769} << 32U), "part \"shell limits\": out of range");
}

/// Polygons that are said to be a shell, and are none, hide nothing as one. Those that are one are found out when they are
/// asked for.
TEST_F(ForgedPart, ThatIsNoShell) {
  const auto parts = sound_.get<U32>("shell polygons"), first = sound_.get<U32>("shell first polygon");
  const auto of = sound_.get<U32>("shell of");
  U32 last = first[1] - 1;  // another polygon in place of the last one of the first shell
  U32 other = parts[last] + 1;
  while (other < polygons_ && of[other] != ConvexShells::kNone) ++other;
  ASSERT_LT(other, polygons_);
  ForgedParts forged(sound_);
  forged.edit<U32>("shell polygons", [&](auto& all) { all[last] = other; });
  forged.edit<U32>("shell of", [&](auto& all) {
    all[parts[last]] = ConvexShells::kNone;
    all[other] = 0;
  });
  ASSERT_EQ(forged.refusal(), "");
  const Culler culler = forged.culler();
  const auto regions = occluders_of(culler).regions().size();
  const auto eye = kernel::Viewpoint::eye({-90, -90, 5});
  EXPECT_TRUE(occluders_of(culler).polytope(regions).faces().empty());
  EXPECT_FALSE(occluders_of(culler).shadow(regions, eye, kernel::Near::surface).frustum.has_value());
  EXPECT_EQ(occluders_of(culler).polytope(regions + 1).faces().size(),
            occluders_of(culler_).polytope(regions + 1).faces().size());
  EXPECT_TRUE(occluders_of(culler).shadow(regions + 1, eye, kernel::Near::surface).frustum.has_value());
}

TEST_F(ForgedPart, OfTheLists) {
  const std::string lists = "part \"listed\": the lists are not of these regions and occluders",
                    cells = "part \"cells\": it is not a tree of cells",
                    hidden = "part \"hidden\": it is not of these lists";
  const auto many = static_cast<U32>(occluders_of(culler_).size());
  const auto first = sound_.get<U64>("list first");
  const std::size_t entries = sound_.get<U32>("listed").size();
  EXPECT_EQ(with("listed", entries - 1, many - 1), "");
  EXPECT_EQ(with("listed", entries - 1, many), lists);
  EXPECT_EQ(with("list first", 0, U64{1}), lists);
  EXPECT_EQ(with("list first", first.size() - 1, U64{entries} + 1), lists);
  EXPECT_EQ(with("list first", 1, U64{entries} + 1), lists) << "not ascending";
  std::size_t r = 0;
  while (first[r + 1] < first[r] + 2) ++r;
  EXPECT_EQ((refusal<U32>("listed", [&](auto& all) { std::swap(all[first[r]], all[first[r] + 1]); })), lists);
  EXPECT_EQ((refusal<U32>("listed", [&](auto& all) { all[first[r] + 1] = all[first[r]]; })), lists) << "an occluder twice";
  for (const float wrong : {std::nanf(""), std::numeric_limits<float>::infinity(), -1.0F}) {
    EXPECT_EQ(with("hidden", 2, wrong), hidden);
  }
  EXPECT_EQ((refusal<float>("hidden", [](auto& all) { all.clear(); })), "") << "not sampled";

  using Cell = Partition::Cell;
  const auto all = sound_.get<Cell>("cells");
  ASSERT_GT(all.size(), 8U);
  const auto change = [&](std::size_t i, const Cell& cell) { return with("cells", i, cell); };
  EXPECT_EQ(change(0, {all[0].plane, 3, all[0].upper}), cells);
  EXPECT_EQ(change(0, {std::nan(""), all[0].axis, all[0].upper}), cells);
  EXPECT_EQ(change(0, {all[0].plane, all[0].axis, static_cast<U32>(all.size())}), cells);
  EXPECT_EQ(change(0, {all[0].plane, all[0].axis, 0}), cells);
  EXPECT_EQ(change(all.size() - 1, {0, 0, static_cast<U32>(all.size() - 2)}), cells);
  EXPECT_EQ((refusal<Cell>("cells",
                           [](auto& few) {
                             few.resize(1);
                             few[0] = {};
                           })),
            lists)
      << "of another partition";
  EXPECT_EQ((refusal<double>("space", [](auto& box) { box[1] = std::nan(""); })), "part \"space\": it is not a box");
}

TEST_F(ForgedPart, OfWhatIsKnownAndTheSettings) {
  const std::string known = "part \"known\": it is not about these occluders";
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), -0x1p211}) {
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(with("known", 8 * 5 + i, wrong), known);
  }
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(with("config", i, U32{2}), "part \"config\": out of range");
  for (const double none : {0.0, -1.0, std::nan("")}) {
    EXPECT_EQ(with("config", 2, none), "part \"config\": the threshold of the lists must be above 0");
    EXPECT_EQ(with("config", 3, none), "part \"config\": the number of regions must be from 1 to 2^30");
  }
  EXPECT_EQ(with("config", 1, U32{1}), "part \"oriented\": it does not number the oriented boxes");
}

TEST_F(ForgedPart, OfTheBlocks) {
  const std::string blocks = "part \"blocks\": the blocks are not of this tree";
  const auto all = sound_.get<TreeBlock>("blocks");
  const auto nodes = static_cast<U32>(culler_.hierarchy().nodes().size());
  ASSERT_GT(all.size(), 10U);
  const auto change = [&](std::size_t i, const std::function<void(TreeBlock&)>& of) {
    return refusal<TreeBlock>("blocks", [&](std::vector<TreeBlock>& changed) { of(changed[i]); });
  };
  for (std::size_t i = 0; i < all.size(); i += i < 4 ? 1 : 7) {
    EXPECT_EQ(change(i, [&](TreeBlock& b) { b.node[0] = nodes; }), blocks) << i;
    EXPECT_EQ(change(i, [&](TreeBlock& b) { b.boxes.max[2][0] = std::nextafter(b.boxes.max[2][0], -1e9); }), blocks) << i;
    EXPECT_EQ(change(i, [&](TreeBlock& b) { ++b.begin[1]; }), blocks) << i;
    EXPECT_EQ(change(i, [&](TreeBlock& b) { b.used = 0; }), blocks) << i;
    EXPECT_EQ(change(i, [&](TreeBlock& b) { b.used = static_cast<TreeBlock::Bits>(b.used & ~1U); }), blocks) << i;
    EXPECT_EQ(change(i, [&](TreeBlock& b) { b.divided ^= 2; }), blocks) << i;
    EXPECT_EQ(change(i, [&](TreeBlock& b) { b.oriented ^= 1; }), blocks) << i;
    for (std::size_t k = 0; k < TreeBlock::kNodes; ++k) {
      for (const U32 wrong : {static_cast<U32>(all.size()), all[i].below[k] - 1, static_cast<U32>(i)}) {
        EXPECT_EQ(change(i, [&](TreeBlock& b) { b.below[k] = wrong; }), blocks) << i << ", " << k;
      }
    }
  }
  // The last node of a block is left out: the block is right in all else, but polygons are in no leaf.
  const auto of_few = [&](const std::function<TreeBlock(const TreeBlock&)>& made) {
    return change(all.size() - 1, [&](TreeBlock& b) { b = made(b); });
  };
  EXPECT_EQ(of_few([](const TreeBlock& b) {
              TreeBlock few;
              for (std::size_t i = 0; i + 1 < b.size(); ++i) {
                few.add(b.boxes.box(i), b.items(i));
                few.node[i] = b.node[i];
                if (!b.is_leaf(i)) few.divide(i, b.below[i]);
              }
              return few;
            }),
            blocks);
  // Below a block the same node once more, and so on: with enough of them, a descent would take more than the stack.
  const auto with_roots = [&](U32 roots) {
    return refusal<TreeBlock>("blocks", [&](std::vector<TreeBlock>& changed) {
      for (TreeBlock& block : changed) {
        for (std::size_t i = 0; i < block.size(); ++i) {
          if (!block.is_leaf(i)) block.below[i] += roots;
        }
      }
      const HierarchyNode& root = culler_.hierarchy().nodes()[0];
      for (U32 i = roots; i > 0; --i) {
        TreeBlock whole;
        whole.add(root.box, {0, root.count});
        whole.divide(0, i);
        changed.insert(changed.begin(), whole);
      }
    });
  };
  EXPECT_EQ(with_roots(1), "") << "the first block may have the root";
  EXPECT_EQ(with_roots(2), blocks);
}

TEST_F(ForgedPart, OfTheCover) {
  const std::string corners = "part \"cover corners\": the triangles are not those of the polygons",
                    rings = "part \"cover next\": the sides are not in rings",
                    polygons = "part \"cover polygons\": the triangles are of other polygons";
  const auto own = sound_.get<CoverMesh::Triangle>("cover corners");
  const auto count = static_cast<U32>(sound_.get<glm::dvec3>("cover vertices").size());
  EXPECT_EQ(with("cover first", 3, U32{0}), corners);
  for (std::size_t t = 0; t < own.size(); t += 29) {
    EXPECT_EQ(with("cover corners", t, CoverMesh::Triangle{own[t][0], own[t][1], count}), corners);
    EXPECT_EQ(with("cover corners", t, CoverMesh::Triangle{own[t][0], own[t][2], own[t][1]}), corners);
  }
  EXPECT_EQ((refusal<double>("cover vertices", [](auto& v) { v[4] = std::nextafter(v[4], 1e9); })), corners);

  const auto next = sound_.get<U32>("cover next");
  const auto sides = static_cast<U32>(next.size());
  constexpr U32 kOfTwo = 0x80000000U;
  for (U32 s = 0; s < sides; s += 17) {
    EXPECT_EQ(with("cover next", s, sides | (next[s] & kOfTwo)), rings) << "no side";
    EXPECT_EQ(with("cover next", s, next[s] ^ kOfTwo), rings);
    EXPECT_EQ(with("cover next", s, ((next[s] & ~kOfTwo) + 1) % sides | kOfTwo), rings) << "another edge";
  }
  const auto paired = static_cast<U32>(
      std::ranges::find_if(next, [&](const U32& n) { return (n & ~kOfTwo) != static_cast<U32>(&n - next.data()); }) -
      next.begin());
  ASSERT_LT(paired, sides);
  EXPECT_EQ(with("cover next", paired, paired | kOfTwo), rings) << "a ring that is not entered again";
  std::vector<U32> alone;
  for (U32 s = 0; s < sides; ++s) {
    if (next[s] == (s | kOfTwo)) alone.push_back(s);
  }
  ASSERT_GT(alone.size(), 1U);
  EXPECT_EQ((refusal<U32>("cover next", [&](auto& all) { std::swap(all[alone.front()], all[alone.back()]); })), rings)
      << "a ring of two edges";

  const auto of = sound_.get<U32>("cover polygons");
  for (std::size_t t = 0; t < of.size(); t += 31) EXPECT_EQ(with("cover polygons", t, of[t] + 1), polygons);
  EXPECT_EQ((refusal<U32>("cover polygons", [](auto& all) { all.pop_back(); })), polygons);
}

/// A triangle with a corner twice covers nothing and is not drawn. In a store it must not have another vertex in the same
/// place, with which it would be.
TEST(Parts, RefuseATriangleWithTwoVerticesInOnePlace) {
  using glm::dvec3;
  const dvec3 a{50, 0, 0}, b{50, 1, 0};
  const std::array<std::vector<dvec3>, 3> loops{{{a, a, b}, {a, b, b}, {a, b, a}}};  // side i leads nowhere
  for (std::size_t i = 0; i < 3; ++i) {
    PolygonSoup soup = varied_town(20);
    add(soup, loops[i]);
    ForgedParts forged{Culler(soup, kSmallConfigs[0])};
    auto corners = forged.get<CoverMesh::Triangle>("cover corners");
    const auto t = static_cast<std::size_t>(
        std::ranges::find_if(corners, [&](const auto& c) { return c[i] == c[(i + 1) % 3]; }) - corners.begin());
    ASSERT_LT(t, corners.size());
    auto vertices = forged.get<dvec3>("cover vertices");
    vertices.push_back(vertices[corners[t][i]]);
    corners[t][std::max<std::size_t>(i, 1)] = static_cast<U32>(vertices.size() - 1);
    forged.set("cover corners", corners);
    forged.set("cover vertices", vertices);
    forged.edit<U32>("cover next", [&](auto& next) {  // no two of its sides are along one edge
      for (std::size_t side = 3 * t; side < 3 * t + 3; ++side) next[side] = static_cast<U32>(side) | 0x80000000U;
    });
    EXPECT_EQ(forged.refusal(), "part \"cover corners\": the triangles are not those of the polygons") << i;
  }
}

/// Whatever bytes change, the parts are refused, or what they cull by frusta is in a shadow.
TEST(Parts, OfAnyBytesCullRightOrAreRefused) {
  const PolygonSoup soup = varied_town(120);
  const Culler culler = sampled(soup, kSmallConfigs[0]);
  const ForgedParts sound(culler);
  constexpr std::uint32_t kSeed = 5;
  std::mt19937 random(kSeed);
  std::size_t accepted = 0;
  for (int run = 0; run < 3000; ++run) {
    ForgedParts forged(sound);
    const std::string& name = sound.names()[random() % sound.names().size()];
    std::vector<std::byte>& bytes = forged.bytes(name);
    if (bytes.empty()) continue;
    bytes[random() % bytes.size()] ^= static_cast<std::byte>(1U << random() % 8);
    if (!forged.refusal().empty()) continue;
    ++accepted;
    const Culler changed = forged.culler();
    const Camera camera = random_camera(random);
    static_cast<void>(changed.cull(camera, {.method = Method::cover}));
    const CullResult frame = changed.cull(camera, {.method = Method::frusta});
    for (const Culled& culled : frame.culled) {
      if (culled.by != Culled::By::shadow) continue;
      const auto inside = [&](const auto& box) {
        return kernel::overlap_certified(frame.occluders[culled.index].frustum, box, kernel::NearBoundary::open).relation ==
               kernel::Relation::inside;
      };
      ASSERT_TRUE(changed.hierarchy().ask(culled.node, inside)) << name << ", seed " << kSeed << ", run " << run;
    }
  }
  EXPECT_GT(accepted, 100U) << "of heuristics anything is";
}

}  // namespace parts_test
