// SPDX-License-Identifier: MIT
#include "frusta/candidate_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "scenes.h"

namespace candidate_order_test {

using namespace occlude::culler;

std::vector<std::uint32_t> occluders_of(std::span<const Candidate> candidates) {
  std::vector<std::uint32_t> result;
  for (const Candidate& c : candidates) result.push_back(c.occluder);
  return result;
}

/// The best `count` candidates, or all if there are fewer.
std::vector<Candidate> best(CandidateOrder& order, std::size_t count) {
  std::vector<Candidate> taken;
  if (count == 0) return taken;
  order.for_best_first([&](const Candidate& c) {
    taken.push_back(c);
    return taken.size() < count;
  });
  return taken;
}

constexpr std::size_t kAll = 1'000'000;

void expect_sorted(CandidateOrder& order, std::vector<Candidate> candidates, std::size_t count = kAll) {
  std::sort(candidates.begin(), candidates.end());
  candidates.resize(std::min(candidates.size(), count));
  const std::vector<Candidate> taken = best(order, count);
  ASSERT_EQ(occluders_of(taken), occluders_of(candidates));
  for (std::size_t i = 0; i < candidates.size(); ++i) ASSERT_EQ(taken[i].score, candidates[i].score);
}

/// A share, in per cent, of all occluders, with their scores.
std::vector<Candidate> some_of(std::span<const double> scores, std::size_t share, std::mt19937& random) {
  std::vector<Candidate> candidates;
  for (std::uint32_t i = 0; i < scores.size(); ++i) {
    if (random() % 100 < share) candidates.push_back({scores[i], i});
  }
  return candidates;
}

/// n candidates, the first of them the best.
std::vector<Candidate> descending(std::uint32_t n) {
  std::vector<Candidate> candidates;
  for (std::uint32_t i = 0; i < n; ++i) candidates.push_back({static_cast<double>(n - i), i});
  return candidates;
}

TEST(CandidateOrder, IsWhatSortingGives) {
  constexpr std::uint32_t kSeed = 3;
  std::mt19937 random(kSeed);
  constexpr std::size_t kOccluders = 300;
  CandidateOrder order;
  std::vector<double> scores(kOccluders, 0);
  std::set<std::uint32_t> before;
  for (int frame = 0; frame < 2000; ++frame) {
    // Frames change nothing, or as much as a step does, or everything. Equal scores are common.
    const std::size_t changes = frame % 50 == 0 ? kOccluders : random() % 20;
    for (std::size_t i = 0; i < changes; ++i) scores[random() % kOccluders] = static_cast<double>(random() % 40);
    const std::size_t in_view = frame % 7 == 0 ? 0 : random() % 100;
    std::vector<Candidate> candidates = some_of(scores, in_view, random);
    std::set<std::uint32_t> now;
    for (const Candidate& c : candidates) now.insert(c.occluder);
    std::shuffle(candidates.begin(), candidates.end(), random);
    order.update(candidates, kOccluders);
    expect_sorted(order, candidates);
    ASSERT_FALSE(HasFatalFailure()) << "seed " << kSeed << ", frame " << frame;
    const auto kept = std::ranges::count_if(now, [&](std::uint32_t i) { return before.contains(i); });
    ASSERT_EQ(order.kept(), static_cast<std::size_t>(kept)) << "all were asked for in the frame before";
    before = std::move(now);
  }
}

/// Frames ask for few of many candidates, for more than the frames before, for all or none, once or several times.
TEST(CandidateOrder, IsWhatSortingGivesToFramesThatAskForAPart) {
  constexpr std::uint32_t kSeed = 4;
  std::mt19937 random(kSeed);
  constexpr std::uint32_t kOccluders = 300;
  CandidateOrder order;
  std::vector<double> scores(kOccluders, 0);
  std::size_t not_sorted = 0, sorted_later = 0;
  for (int frame = 0; frame < 3000; ++frame) {
    for (std::uint32_t i = 0; i < 20; ++i) scores[random() % kOccluders] = static_cast<double>(random() % 400);
    const std::size_t in_view = frame % 31 == 0 ? 0 : 20 + random() % 80;
    const std::vector<Candidate> candidates = some_of(scores, in_view, random);
    order.update(candidates, kOccluders);
    const std::size_t comparisons = order.comparisons();
    for (std::size_t times = random() % 3; times-- > 0;) {
      expect_sorted(order, candidates, frame % 13 == 0 ? kAll : random() % 40);
      ASSERT_FALSE(HasFatalFailure()) << "seed " << kSeed << ", frame " << frame;
    }
    ++(order.comparisons() > comparisons ? sorted_later : not_sorted);
  }
  EXPECT_GT(not_sorted, 1500U);
  EXPECT_GT(sorted_later, 200U);
}

TEST(CandidateOrder, ComparesEachOfManyOnceWhereAFrameAsksForFew) {
  constexpr std::uint32_t kMany = 4000;
  constexpr std::size_t kFew = 100;
  const std::vector<Candidate> candidates = descending(kMany);
  CandidateOrder order;
  for (int frame = 0; frame < 3; ++frame) {
    order.update(candidates, kMany);
    expect_sorted(order, candidates, kFew);
  }
  EXPECT_LE(order.kept(), 2 * kFew);
  EXPECT_GE(order.kept(), kFew);
  EXPECT_LE(order.comparisons(), kMany + 10 * kFew);
}

/// What looked good from elsewhere may be better than all that is in view now.
TEST(CandidateOrder, FindsWhatIsGoodAmongWorseCandidates) {
  constexpr std::uint32_t kMany = 1000;
  constexpr std::size_t kFew = 100;
  std::vector<Candidate> candidates = descending(kMany);
  CandidateOrder order;
  for (int frame = 0; frame < 3; ++frame) {
    order.update(candidates, kMany);
    expect_sorted(order, candidates, kFew);
  }
  ASSERT_LT(order.kept(), kMany / 2);
  candidates.resize(kFew + kFew / 2);
  for (Candidate& c : candidates) c.score /= 1e6;
  for (int frame = 0; frame < 3; ++frame) {
    order.update(candidates, kMany);
    expect_sorted(order, candidates, kFew);
  }
  EXPECT_EQ(order.kept(), candidates.size());
  EXPECT_EQ(order.moves(), 0U);
}

TEST(CandidateOrder, NothingMovesWhereNothingChanges) {
  std::vector<Candidate> candidates = descending(1000);
  CandidateOrder order;
  order.update(candidates, 1000);
  static_cast<void>(best(order, kAll));
  EXPECT_EQ(order.kept(), 0U);
  EXPECT_EQ(order.moves(), 0U) << "all are new";
  order.update(candidates, 1000);
  static_cast<void>(best(order, kAll));
  EXPECT_EQ(order.kept(), 1000U);
  EXPECT_EQ(order.moves(), 0U);
  for (Candidate& c : candidates) c.score *= 3;
  order.update(candidates, 1000);
  EXPECT_EQ(order.moves(), 0U) << "as seen from nearer";
}

TEST(CandidateOrder, MovesAreThePlacesPassed) {
  std::vector<Candidate> candidates = descending(1000);
  CandidateOrder order;
  order.update(candidates, 1000);
  static_cast<void>(best(order, kAll));
  std::swap(candidates[500].score, candidates[501].score);
  order.update(candidates, 1000);
  EXPECT_EQ(order.moves(), 1U);
  static_cast<void>(best(order, kAll));
  candidates[100].score = 2000;  // to the top: past the hundred before it
  order.update(candidates, 1000);
  EXPECT_EQ(order.moves(), 100U);
  expect_sorted(order, candidates);
  candidates.erase(candidates.begin() + 200, candidates.begin() + 300);
  order.update(candidates, 1000);
  EXPECT_EQ(order.kept(), 900U);
  EXPECT_EQ(order.moves(), 0U) << "what is gone is passed by nobody";
}

TEST(CandidateOrder, AJumpDoesNotCostASquare) {
  constexpr std::uint32_t kMany = 4000;
  std::vector<Candidate> candidates = descending(kMany);
  CandidateOrder order;
  order.update(candidates, kMany);
  static_cast<void>(best(order, kAll));
  for (Candidate& c : candidates) c.score = -c.score;  // insertion alone would pass 4000 * 3999 / 2 places
  order.update(candidates, kMany);
  expect_sorted(order, candidates);
  EXPECT_LE(order.moves(), 17U * kMany);
  EXPECT_EQ(order.kept(), kMany);
}

TEST(CandidateOrder, EqualsByTheirNumber) {
  CandidateOrder order;
  order.update(std::vector<Candidate>{{1, 5}, {1, 2}, {2, 9}, {1, 3}}, 10);
  EXPECT_EQ(occluders_of(best(order, kAll)), (std::vector<std::uint32_t>{9, 2, 3, 5}));
  order.update(std::vector<Candidate>{{1, 9}, {1, 4}, {1, 2}}, 10);
  EXPECT_EQ(occluders_of(best(order, kAll)), (std::vector<std::uint32_t>{2, 4, 9}));
}

}  // namespace candidate_order_test
