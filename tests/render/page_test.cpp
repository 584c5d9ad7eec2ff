// SPDX-License-Identifier: MIT
// What the page of a walk holds of a model and its frames, read back.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bytes.h"
#include "deflated.h"
#include "occlude/culler/culler.h"
#include "occlude/render/why.h"
#include "page_details.h"
#include "page_files.h"
#include "page_frames.h"
#include "page_model.h"
#include "page_pieces.h"
#include "page_reader.h"
#include "page_vain.h"
#include "template.h"

namespace page_test {

using namespace occlude;
using namespace occlude::render;

TEST(Bytes, KeepNumbers) {
  const std::vector<std::uint64_t> numbers{0, 1, 127, 128, 16383, 16384, 0xFFFFFFFF, ~std::uint64_t{0}};
  Bytes bytes;
  for (const std::uint64_t n : numbers) bytes.number(n);
  EXPECT_EQ(page_numbers(bytes.text()), numbers);
}

TEST(Bytes, KeepDifferences) {
  const std::vector<std::int64_t> differences{0, -1, 1, -2, 63, -64, 64, -65, 0x7FFFFFFF, -0x80000000LL};
  Bytes bytes;
  for (const std::int64_t d : differences) bytes.difference(d);
  PageNumbers reader(bytes.text());
  for (const std::int64_t d : differences) EXPECT_EQ(reader.difference(), d);
  EXPECT_TRUE(reader.is_at_end());
}

TEST(Bytes, SmallNumbersTakeOneByte) {
  Bytes bytes;
  bytes.number(127);
  bytes.difference(-64);
  EXPECT_EQ(bytes.text().size(), 2U);
}

TEST(Deflated, ReadsBackFromLetters) {
  std::mt19937 random(1);
  for (const std::size_t size : {0U, 1U, 2U, 3U, 1000U, 1001U, 1002U}) {
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() % 7);
    const std::string letters = base64(deflated(bytes));
    EXPECT_EQ(letters.size() % 4, 0U);
    EXPECT_EQ(inflated(from_base64(letters), size + 1), bytes) << size;
  }
}

TEST(Deflated, LettersAreThoseOfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Template, FillsPlacesOnce) {
  const auto value = [](std::string_view name) { return name == "a" ? std::string("{{b}}") : std::string(name) + "!"; };
  EXPECT_EQ(filled("x {{a}} y {{b}}", value), "x {{b}} y b!");
  EXPECT_EQ(filled("{{a", value), "{{a");
}

TEST(PageFiles, AreThereWithTheChartsLibraryAndItsLicence) {
  EXPECT_TRUE(page_file("walk.html").starts_with("<!doctype html>"));
  EXPECT_NE(page_file("dygraph.min.js").find("Dygraph"), std::string_view::npos);
  EXPECT_NE(page_file("dygraphs.txt").find("Permission is hereby granted, free of charge"), std::string_view::npos);
}

/// Random triangles and quadrilaterals that share vertices.
culler::PolygonSoup random_soup(std::size_t polygons) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  culler::PolygonSoup soup;
  for (std::size_t i = 0; i < polygons; ++i) {
    soup.add_vertex({3000 * coordinate(random), 20 * coordinate(random), coordinate(random)});
  }
  for (std::size_t i = 0; i < polygons; ++i) {
    std::vector<std::uint32_t> loop(3 + i % 2);
    for (std::uint32_t& index : loop) index = static_cast<std::uint32_t>(random() % polygons);
    soup.add_polygon(loop);
  }
  return soup;
}

/// A model of a page as its script reads it.
struct ReadModel {
  explicit ReadModel(const PageModel& model) {
    PageNumbers number(model.numbers());
    std::int64_t last = 0;
    for (std::size_t p = 0; p < model.polygons(); ++p) numbers.push_back(last += number.difference());
    leaf_sizes = page_numbers(model.leaf_sizes());
    for (const std::uint64_t side : page_numbers(model.sides())) {
      sides.push_back(side >> 1);
      see_through.push_back((side & 1U) != 0);
    }
    std::uint64_t unused = 0;
    for (const std::uint64_t back : page_numbers(model.corners())) {
      corners.push_back(unused - back);
      if (back == 0) ++unused;
    }
    read_points(model.vertices());
  }

  void read_points(const std::string& bytes) {
    const std::size_t count = bytes.size() / 12;
    points.resize(count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::uint32_t value = 0;
      for (std::size_t v = 0; v < count; ++v) {
        const auto byte = [&](std::size_t plane) {
          return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[(4 * axis + plane) * count + v]));
        };
        const std::uint32_t folded = byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
        value += (folded & 1U) != 0 ? ~(folded >> 1) : folded >> 1;
        points[v][axis] = value;
      }
    }
  }

  std::vector<std::int64_t> numbers;
  std::vector<std::uint64_t> leaf_sizes, sides, corners;
  std::vector<bool> see_through;
  std::vector<GridPoint> points;
};

TEST(PageModel, ReadsBackAsTheModel) {
  culler::PolygonSoup soup = random_soup(500);
  soup.see_through_from(400);
  const culler::Hierarchy hierarchy = culler::Hierarchy::build(soup, {});
  const PageModel model(hierarchy);
  const ReadModel read(model);
  ASSERT_EQ(read.numbers.size(), soup.size());
  ASSERT_EQ(read.sides.size(), soup.size());
  std::size_t corner = 0;
  std::vector<bool> seen(soup.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto number = static_cast<std::size_t>(read.numbers[p]);
    EXPECT_FALSE(seen.at(number));
    seen[number] = true;
    const auto loop = soup.loop(number);
    ASSERT_EQ(read.sides[p], loop.size());
    EXPECT_EQ(read.see_through[p], number >= 400);
    for (const std::uint32_t index : loop) {
      const auto& point = read.points.at(read.corners.at(corner++));
      for (int axis = 0; axis < 3; ++axis) {
        const double coordinate = model.grid().low[axis] + model.grid().step * point[static_cast<std::size_t>(axis)];
        EXPECT_LE(std::fabs(coordinate - soup.vertices[index][axis]), 0.5001 * model.grid().step);
      }
    }
  }
  EXPECT_EQ(corner, read.corners.size());
}

TEST(PageModel, LeavesAreThoseOfTheTree) {
  const culler::Hierarchy hierarchy = culler::Hierarchy::build(random_soup(500), {});
  const PageModel model(hierarchy);
  const ReadModel read(model);
  ASSERT_EQ(read.leaf_sizes.size(), model.leaves());
  for (const culler::HierarchyNode& node : hierarchy.nodes()) {
    const auto [first, count] = model.leaves_of({node.first, node.count});
    std::size_t before = 0, inside = 0;
    for (std::size_t leaf = 0; leaf < first + count; ++leaf) (leaf < first ? before : inside) += read.leaf_sizes[leaf];
    EXPECT_EQ(before, node.first);
    EXPECT_EQ(inside, node.count);
    EXPECT_EQ(node.is_leaf(), count == 1);
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
      EXPECT_GE(model.place(p), before);
      EXPECT_LT(model.place(p), before + inside);
      EXPECT_EQ(read.numbers[model.place(p)], hierarchy.original(p));
      EXPECT_GE(model.leaf_of(p), first);
      EXPECT_LT(model.leaf_of(p), first + count);
    }
  }
}

TEST(PageModel, ALargeModelLosesItsSmallestPolygons) {
  culler::PolygonSoup soup;
  for (std::uint32_t i = 0; i < 20; ++i) {
    const double size = 1 + (i * 7) % 20, x = 30.0 * i;  // every size from 1 to 20 once
    const std::array loop{soup.add_vertex({x, 0, 0}), soup.add_vertex({x + size, 0, 0}), soup.add_vertex({x, size, 0})};
    soup.add_polygon(loop);
  }
  const PageModel model(culler::Hierarchy::build(soup, {}), 5);
  std::vector<std::int64_t> sizes;
  for (const std::int64_t number : ReadModel(model).numbers) sizes.push_back(1 + (number * 7) % 20);
  std::ranges::sort(sizes);
  EXPECT_EQ(sizes, (std::vector<std::int64_t>{16, 17, 18, 19, 20}));
}

TEST(PageGrid, IsAsFineAsSinglePrecision) {
  const std::vector<glm::dvec3> points{{-640.1, 0, 3}, {639.7, 1, 3}, {0.3, 0.1, 3}};
  const PageGrid grid(points);
  EXPECT_EQ(grid.step, 0x1p-13);  // 1279.8 of them are less than 2^24, and of 2^-14 more
  EXPECT_EQ(grid.at(points[0])[0], 0U);
  EXPECT_EQ(grid.at(points[1]), (GridPoint{grid.steps[0], grid.steps[1], 0}));
  EXPECT_NEAR(grid.low.x + grid.step * grid.at(points[2])[0], 0.3, 0x1p-14);
}

TEST(PageGrid, KeepsCoordinatesThatLieOnACoarserGrid) {
  const std::vector<glm::dvec3> points{{-1000.5, 0, 0}, {1000, 20.125, 0}, {3.75, 8, 0}};
  const PageGrid grid(points);
  EXPECT_EQ(grid.step, 0.125);
  for (const glm::dvec3& point : points) {
    const GridPoint at = grid.at(point);
    EXPECT_EQ(grid.low + grid.step * glm::dvec3(at[0], at[1], at[2]), point);
  }
}

TEST(PageGrid, OfOnePointHasNoSteps) {
  const std::vector<glm::dvec3> points{{5, 6, 7}, {5, 6, 7}};
  EXPECT_EQ(PageGrid(points).steps, GridPoint{});
  EXPECT_EQ(PageGrid(points).at(points[1]), GridPoint{});
}

/// A wall at x = 4 and many squares behind it, beside it and behind the eye at the origin.
culler::PolygonSoup walls() {
  culler::PolygonSoup soup;
  const auto add = [&](double x, double y, double size) {
    std::vector<std::uint32_t> loop;
    for (const auto& [v, w] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      loop.push_back(soup.add_vertex({x, y + v * size, w * size}));
    soup.add_polygon(loop);
  };
  add(4, 0, 1);
  for (int i = 0; i < 20; ++i) {
    add(6 + i, 0, 0.5);
    add(6 + i, 4, 0.5);
    add(-6 - i, 0, 0.5);
  }
  return soup;
}

/// The fate of each polygon of the tree in a frame of the page, as `numbers` reads it on.
class PageFramesTest : public testing::Test {
 protected:
  static culler::BuildConfig small_leaves() {
    culler::BuildConfig config;
    config.hierarchy.leaf_size = 2;
    return config;
  }

  /// Reads a frame and expects of it what the culler says.
  void expect_same(PageNumbers numbers, const culler::CullResult& frame, const PageFrames& frames) {
    const auto outlines = frames.outlines();
    std::vector<std::uint32_t> occluders;
    ASSERT_EQ(numbers.next(), frame.occluders.size());
    for (const culler::Occluder& occluder : frame.occluders) {
      EXPECT_EQ(outlines.at(numbers.next()).occluder, occluder.index);
      EXPECT_EQ(numbers.next(), occluder.hidden);
    }
    std::map<std::uint64_t, std::pair<std::uint64_t, std::uint64_t>> hiders;
    for (std::uint64_t n = numbers.next(); n > 0; --n) {
      const std::uint64_t colour = numbers.next(), first = numbers.next();
      hiders[colour] = {first, numbers.next()};
    }
    std::vector<std::uint64_t> fates;  // of the leaves
    auto next = frame.culled.begin();
    while (!numbers.is_at_end()) {
      const std::uint64_t fate = numbers.next(), leaves = numbers.next();
      if (fate != 0) {
        ASSERT_NE(next, frame.culled.end());
        const culler::HierarchyNode& node = culler_.hierarchy().nodes()[(next++)->node];
        const auto [first, count] = model_.leaves_of({node.first, node.count});
        EXPECT_EQ(first, fates.size());
        EXPECT_EQ(count, leaves) << "a culled subtree";
      }
      fates.resize(fates.size() + leaves, fate);
    }
    EXPECT_EQ(next, frame.culled.end());
    ASSERT_EQ(fates.size(), model_.leaves());
    for (std::uint32_t p = 0; p < culler_.hierarchy().soup().size(); ++p) {
      const culler::Culled* culled = culler_.cull_of(frame, p);
      const std::uint64_t fate = fates[model_.leaf_of(p)];
      if (!culled) {
        EXPECT_EQ(fate, 0U);
      } else if (culled->by == culler::Culled::By::view) {
        EXPECT_EQ(fate, 1U);
      } else if (culled->by == culler::Culled::By::cover) {
        EXPECT_EQ(fate, 2U);
      } else {
        EXPECT_EQ(hiders.at(fate - 3).first, culled->index);
        EXPECT_EQ(hiders.at(fate - 3).second, culled->second == culler::Culled::kNone ? 0 : culled->second + 1);
      }
    }
  }

  culler::Camera camera_;
  culler::Culler culler_{walls(), small_leaves()};
  PageModel model_{culler_.hierarchy()};
};

TEST_F(PageFramesTest, TellWhatBecameOfEachPolygon) {
  for (const culler::Method method : {culler::Method::frusta, culler::Method::cover}) {
    const culler::CullResult frame = culler_.cull(camera_, {.method = method});
    ASSERT_GT(frame.stats.shadow_culled_polygons, 0U);
    ASSERT_GT(frame.stats.view_culled_polygons, 0U);
    PageFrames frames(culler_, model_);
    frames.add(frame);
    const std::string packed = frames.packed();
    PageNumbers numbers(packed);
    expect_same(PageNumbers(numbers.block()), frame, frames);
    EXPECT_TRUE(numbers.is_at_end());
  }
}

TEST_F(PageFramesTest, OfMoreBytesThanAllowedEverySecondFrameIsKept) {
  const culler::CullResult frame = culler_.cull(camera_, {.method = culler::Method::frusta});
  PageFrames one(culler_, model_);
  one.add(frame);
  PageFrames frames(culler_, model_, 4 * one.packed().size());
  for (int i = 0; i < 9; ++i) frames.add(frame);
  EXPECT_EQ(frames.every(), 4U);
  PageFrames kept(culler_, model_);
  for (int i = 0; i < 3; ++i) kept.add(frame);  // 0, 4 and 8
  EXPECT_EQ(frames.packed(), kept.packed());
  EXPECT_EQ(frames.occluders().begin()->second.did.frames, 9U);
}

/// The numbers of the frames that `details` keeps.
std::vector<std::size_t> kept_by(const PageDetails& details) {
  std::vector<std::size_t> frames;
  const std::string packed = details.packed();
  for (PageNumbers numbers(packed); !numbers.is_at_end(); static_cast<void>(numbers.block())) {
    const std::size_t before = frames.empty() ? 0 : frames.back();
    frames.push_back(before + static_cast<std::size_t>(numbers.next()));
  }
  return frames;
}

TEST_F(PageFramesTest, DetailsAreKeptOfTheSlowestFramesToo) {
  const culler::CullResult frame = culler_.cull(camera_, {.method = culler::Method::frusta});
  const FrameRecord record;
  const ShownFrame shown{record, camera_, frame, {}, nullptr, nullptr};
  PageDetails one(culler_, model_);
  one.add(shown, 1);
  constexpr std::size_t kFrames = 100, kSlow = PageDetails::kSlowest;
  PageDetails all(culler_, model_), some(culler_, model_, (kSlow + 10) * one.packed().size());
  for (std::size_t i = 0; i < kFrames; ++i) {
    const double ms = i % 10 == 3 ? 50 : static_cast<double>(i % 7);  // the slow ones: 3, 13, ...
    all.add(shown, ms);
    some.add(shown, ms);
  }
  EXPECT_EQ(kept_by(all).size(), kFrames);
  const std::vector<std::size_t> kept = kept_by(some);
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < kFrames; ++i) {
    if (i % 10 == 3 || i % 16 == 0) expected.push_back(i);
  }
  EXPECT_EQ(kept, expected);
}

TEST_F(PageFramesTest, DetailsHaveTheDistancesOfEachCulledSubtree) {
  const culler::CullResult frame = culler_.cull(camera_, {.method = culler::Method::frusta, .unions = true});
  const FrameRecord record;
  PageDetails details(culler_, model_);
  details.add({record, camera_, frame, {}, nullptr, nullptr}, 1);
  std::vector<double> expected;
  for (const culler::Culled& culled : frame.culled) {
    if (culled.by == culler::Culled::By::view) {
      expected.push_back(beyond_view(culler_, frame, culled));
      EXPECT_GE(expected.back(), 0);
    } else {
      for (const AgainstShadow& shadow : against_shadows(culler_, frame, culled)) {
        expected.push_back(shadow.clearance.distance);
        if (culled.second == culler::Culled::kNone) {
          EXPECT_GE(expected.back(), 0);
        }
      }
    }
  }
  const std::string packed = details.packed();
  PageNumbers frames(packed);
  static_cast<void>(frames.next());
  PageNumbers numbers(frames.block());
  ASSERT_EQ(numbers.next(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) static_cast<void>(numbers.next());
  for (const double distance : numbers.floats(expected.size())) {
    EXPECT_EQ(distance, static_cast<float>(expected.front()));
    expected.erase(expected.begin());
  }
  EXPECT_TRUE(numbers.is_at_end());
}

TEST_F(PageFramesTest, CountWhatAnOccluderHid) {
  PageFrames frames(culler_, model_);
  const culler::CullResult frame = culler_.cull(camera_, {.method = culler::Method::frusta});
  frames.add(frame);
  frames.add(frame);
  for (const culler::Occluder& occluder : frame.occluders) {
    const HiderRecord& record = frames.occluders().at(occluder.index).did;
    EXPECT_EQ(record.frames, 2U);
    EXPECT_EQ(record.hidden, 2 * occluder.hidden);
    EXPECT_EQ(record.useless, occluder.hidden == 0 ? 2U : 0U);
    EXPECT_EQ(record.best_frame, 0U);
    EXPECT_EQ(record.best_hidden, occluder.hidden);
  }
}

TEST_F(PageFramesTest, CountWhatThePiecesOfCoversHid) {
  const culler::CullOptions options{.method = culler::Method::cover};
  const culler::CullResult frame = culler_.cull(camera_, options);
  std::vector<culler::CoverWitness> covers;
  culler_.append_covers(frame, camera_, options, 1000, covers);
  PagePieces pieces(model_);
  pieces.add({}, {});  // nothing is drawn
  pieces.add(frame, covers);
  std::size_t used = 0, useless = 0, most = 0;
  for (std::uint32_t leaf = 0; leaf < model_.leaves(); ++leaf) {
    const auto is_here = [&](std::uint32_t p) { return model_.leaf_of(p) == leaf; };
    std::size_t hidden = 0;
    for (const culler::CoverWitness& cover : covers) {
      if (std::ranges::any_of(cover.polygons, is_here)) hidden += cover.range.count;
    }
    const bool is_drawn = std::ranges::any_of(frame.drawn, [&](const culler::PolygonRange& range) {
      const auto [first, count] = model_.leaves_of(range);
      return leaf >= first && leaf - first < count;
    });
    const HiderRecord& record = pieces.records()[leaf];
    EXPECT_EQ(record.frames, is_drawn || hidden > 0 ? 1U : 0U);
    EXPECT_EQ(record.hidden, hidden);
    EXPECT_EQ(record.best_frame, record.frames);
    used += record.frames;
    useless += record.useless;
    most = std::max(most, hidden);
  }
  ASSERT_GT(useless, 2U);
  const PagePieces::Ranking ranking = pieces.ranking(2);
  EXPECT_EQ(ranking.used, used);
  EXPECT_EQ(ranking.uses, used);
  EXPECT_EQ(ranking.useless, useless);
  EXPECT_EQ(ranking.idle, useless);
  EXPECT_EQ(ranking.worst.size(), 2U);
  EXPECT_EQ(pieces.records()[ranking.best.at(0)].hidden, most);
}

TEST_F(PageFramesTest, CountWhatWasDrawnInVain) {
  const culler::CullResult frame = culler_.cull(camera_, {.method = culler::Method::frusta});
  const std::vector<bool> drawn = [&] {
    std::vector<bool> result(culler_.hierarchy().soup().size());
    for (const culler::PolygonRange& range : frame.drawn) std::fill_n(result.begin() + range.first, range.count, true);
    return result;
  }();
  const std::uint32_t shown = frame.drawn.front().first;
  PageVain vain(model_);
  vain.add(frame, std::array{shown});
  vain.add(frame, {});
  for (std::uint32_t p = 0; p < drawn.size(); ++p) {
    EXPECT_EQ(vain.frames()[model_.place(p)], !drawn[p] ? 0U : p == shown ? 1U : 2U) << p;
  }
  const std::vector<std::uint64_t> read = page_numbers(vain.packed());
  EXPECT_TRUE(std::ranges::equal(read, vain.frames()));
}

}  // namespace page_test
