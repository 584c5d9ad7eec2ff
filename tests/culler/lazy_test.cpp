// SPDX-License-Identifier: MIT
// What is made when it is first asked for, and what is zero until it is used.
#include "base/lazy.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "base/sparse_zero_array.h"

namespace lazy_test {

using occlude::culler::Lazy;
using occlude::culler::SparseZeroArray;

/// With MinGW std::call_once() keeps a lock for each address, which a throw leaves taken: what comes to lie there waits.
TEST(Lazy, TriesAgainAfterAThrow) {
  for (int i = 0; i < 100; ++i) {
    Lazy<int> lazy;
    EXPECT_THROW(static_cast<void>(lazy.get([]() -> int { throw std::runtime_error("not now"); })), std::runtime_error);
    EXPECT_EQ(lazy.get([&] { return i; }), i);
    EXPECT_EQ(lazy.get([]() -> int { throw std::logic_error("it is made"); }), i);
  }
}

TEST(Lazy, IsMadeOnceForAllThreads) {
  for (int i = 0; i < 100; ++i) {
    Lazy<std::vector<int>> lazy;
    std::atomic<int> made = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&] {
        const std::vector<int>& got = lazy.get([&] { return std::vector<int>(100, ++made); });
        EXPECT_EQ(got, std::vector<int>(100, 1));
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(made, 1);
  }
}

TEST(SparseZeroArray, StayAsTheyAreWhenThereAreMore) {
  SparseZeroArray<std::uint32_t> zeros;
  EXPECT_EQ(zeros.size(), 0U);
  zeros.grow(3);
  zeros[2] = 7;
  zeros.grow(2);
  EXPECT_EQ(zeros[2], 7U);
  zeros.grow(1'000'000);
  ASSERT_GE(zeros.size(), 1'000'000U);
  EXPECT_EQ(zeros[2], 7U);
  for (std::size_t i = 3; i < zeros.size(); ++i) ASSERT_EQ(zeros.get(i), 0U) << i;
  for (std::size_t i = 3; i < zeros.size(); ++i) ASSERT_EQ(zeros[i]++, 0U) << i;
  for (std::size_t i = 3; i < zeros.size(); ++i) ASSERT_EQ(zeros.get(i), 1U) << i;
  SparseZeroArray<std::uint32_t> moved = std::move(zeros);
  EXPECT_EQ(moved.get(2), 7U);
  moved = {};
  EXPECT_EQ(moved.size(), 0U);
}

TEST(SparseZeroArray, KeepEachPageThatWasWritten) {
  SparseZeroArray<std::uint32_t> zeros;
  zeros.grow(5000);
  const std::size_t last = zeros.size() - 1;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1023}, std::size_t{1024}, last})
    zeros[i] = static_cast<std::uint32_t>(i + 1);
  zeros.grow(20000);
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const bool is_written = i == 0 || i == 1023 || i == 1024 || i == last;
    ASSERT_EQ(zeros.get(i), is_written ? i + 1 : 0) << i;
  }
}

#ifdef __linux__
TEST(SparseZeroArray, AreNotTouchedToBeRead) {
  const auto faults = [] {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_minflt;
  };
  SparseZeroArray<std::uint32_t> zeros;
  zeros.grow(std::size_t{1} << 24U);  // 64 MiB
  std::uint32_t sum = zeros.get(0);
  const long before = faults();
  for (std::size_t i = 0; i < zeros.size(); ++i) sum += zeros.get(i);
  EXPECT_LT(faults() - before, 8) << "even of large pages there would be 32";
  EXPECT_EQ(sum, 0U);
}
#endif

}  // namespace lazy_test
