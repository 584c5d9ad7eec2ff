// SPDX-License-Identifier: MIT
#include "base/work_runner.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <deque>
#include <new>
#include <thread>
#include <vector>

#include "executors.h"

namespace work_runner_test {

using namespace occlude::culler;

std::size_t alike(std::size_t) { return 1; }

TEST(WorkRunner, RunsEachPartOnce) {
  WorkRunner runner;
  for (const Executor& executor : some_executors()) {
    for (const std::size_t count : {0U, 1U, 2U, 3U, 7U, 100U}) {
      std::deque<std::atomic<int>> runs(count);
      runner.run(
          executor, count, [](std::size_t i) { return i % 5 * 1000; }, [&](std::size_t i) { ++runs[i]; });
      for (const std::atomic<int>& of_part : runs) EXPECT_EQ(of_part, 1) << count;
      ASSERT_EQ(runner.items().size(), count);
      for (const WorkRunner::WorkItem& turn : runner.items()) EXPECT_TRUE(turn.is_done);
    }
  }
}

/// The order in which parts of so much work are run where only one of the executor's calls does anything.
std::vector<std::size_t> order_of(std::size_t threads, std::size_t working, const std::vector<std::size_t>& work) {
  const Executor one(threads, [&](std::size_t, const Executor::Part& part) { part(working); });
  std::vector<std::size_t> order;
  WorkRunner().run(
      one, work.size(), [&](std::size_t i) { return work[i]; }, [&](std::size_t i) { order.push_back(i); });
  return order;
}

TEST(WorkRunner, AThreadBeginsWithTheMostWorkOfItsShareAndGoesOnWithOthers) {
  using Parts = std::vector<std::size_t>;
  const std::vector<std::size_t> spread{100, 110, 120, 100, 130, 110};
  EXPECT_EQ(order_of(2, 0, spread), (Parts{2, 1, 0, 4, 5, 3}));
  EXPECT_EQ(order_of(2, 1, spread), (Parts{4, 5, 3, 2, 1, 0}));
  EXPECT_EQ(order_of(3, 2, spread), (Parts{4, 5, 1, 0, 2, 3}));
  const std::vector<std::size_t> most_in_one{10, 10, 10, 900, 10};
  EXPECT_EQ(order_of(2, 0, most_in_one), (Parts{0, 1, 2, 3, 4}));
  EXPECT_EQ(order_of(2, 1, most_in_one), (Parts{3, 4, 0, 1, 2}));
  EXPECT_EQ(order_of(2, 1, {0, 0, 0, 0}), (Parts{2, 3, 0, 1})) << "where nothing is known of the work";
  EXPECT_EQ(order_of(9, 2, {5, 5, 5}), (Parts{2, 0, 1})) << "no more shares than parts";
}

/// The calling thread runs what the others had no memory for.
TEST(WorkRunner, APartThatCouldNotBeFinishedIsRunAgain) {
  const Executor threads = a_thread_for_each_part(2);
  const std::thread::id here = std::this_thread::get_id();
  std::atomic<std::size_t> failed = 0, done = 0;
  WorkRunner runner;
  const auto run = [&](std::size_t i) {
    if (i % 2 == 0 && std::this_thread::get_id() != here) {
      ++failed;
      throw std::bad_alloc();
    }
    ++done;
  };
  runner.run(threads, 8, alike, run);
  EXPECT_EQ(failed, 4U);
  EXPECT_EQ(done, 8U);
  const auto fail = [](std::size_t) { throw std::bad_alloc(); };
  EXPECT_THROW(runner.run(threads, 2, alike, fail), std::bad_alloc);
}

TEST(WorkRunner, RunsOnTheCallingThreadWhatNoOtherMayRun) {
  WorkRunner runner;
  const Executor upwards(2, [&](std::size_t count, const Executor::Part& part) {
    rounding_upwards(2).run(count, part);
    for (const WorkRunner::WorkItem& turn : runner.items()) EXPECT_FALSE(turn.is_done);
  });
  std::size_t done = 0;
  runner.run(upwards, 5, alike, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 5U);
}

}  // namespace work_runner_test
