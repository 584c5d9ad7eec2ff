// SPDX-License-Identifier: MIT
// A million cases of all families and the hash of their answers: the same bit for bit whatever compiled the kernel.
// tests/builds.sh runs this in builds by other compilers, at other levels of optimisation, with and without FMA.
#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <variant>

#include "occlude/fuzz/ask.h"
#include "occlude/fuzz/cases.h"
#include "occlude/kernel/overlap.h"

namespace {

using namespace occlude;

/// FNV-1a, 64 bits.
class Hash {
 public:
  template <class Enum>
  void add(Enum value) {
    state_ = (state_ ^ static_cast<std::uint64_t>(value)) * 0x100000001b3U;
  }
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// What the hashes are taken of. The relations of `plain` are whatever rounding makes them, but rounding is IEEE's and
/// nothing is contracted: they are the same everywhere too.
struct Hashes {
  Hash certified, plain;
};

void add_answers(const fuzz::Case& c, Hashes& hashes) {
  const auto made = fuzz::make_frustum(c);
  hashes.certified.add(made.refusal);
  hashes.certified.add(fuzz::check(c.box));
  if (!made.frustum || fuzz::check(c.box) != kernel::Refusal::none) return;
  hashes.certified.add(fuzz::overlap(*made.frustum, c.box).relation);
  hashes.certified.add(fuzz::conservative(*made.frustum, c.box).relation);
  std::visit(
      [&](const auto& box) {
        hashes.plain.add(kernel::overlap_plain(*made.frustum, box));
        hashes.plain.add(kernel::conservative_plain(*made.frustum, box));
      },
      c.box);
}

/// Ten slices that run side by side, 100,000 cases each: case i is of family i modulo their number.
constexpr std::size_t kSliceSize = 100'000;

Hashes hash_slice(std::size_t slice) {
  const auto families = fuzz::families();
  Hashes hashes;
  for (std::size_t i = slice * kSliceSize; i < (slice + 1) * kSliceSize; ++i) {
    add_answers(fuzz::make_case(families[i % families.size()], i / families.size()), hashes);
  }
  return hashes;
}

struct Expected {
  std::uint64_t certified, plain;
};

/// A change of the generator changes the cases and all of these. While the cases are the same, nothing may change the
/// first column, and only a change of the paper's arithmetic the second.
constexpr Expected kExpected[] = {
    {0x8e00054fd19c641c, 0x8867f210a4472b63}, {0x1b777f65394faa59, 0x6afba8f9b9bd7ffa},
    {0x3de113bba7357ac0, 0xbdaa78a622063ca9}, {0x9837cec256a7b0aa, 0x4e6b2f0c9cbb2c5e},
    {0xe51e14a384034f43, 0xd7edcc497d2b81e6}, {0x5d8279bfcfda3117, 0xc3a8fa99bf63a2e7},
    {0x6df043996c3f4194, 0x7c11e528e614ad1b}, {0xc3d96013f5d935cf, 0x6a0def1263dbfa0a},
    {0x4a4d658aca914993, 0x743c2b3031222a8d}, {0x21bade867332b05a, 0xd7959e0f166c52e3},
};

// The checks that sanitizers compile in cost ten times the work and see as much in a tenth of it.
#ifdef OCCLUDE_SANITIZED
constexpr std::size_t kSlices = 1;
#else
constexpr std::size_t kSlices = std::size(kExpected);
#endif

class Answers : public testing::TestWithParam<std::size_t> {};

TEST_P(Answers, HaveTheHashOfEveryBuild) {
  const Hashes hashes = hash_slice(GetParam());
  std::printf("{0x%016" PRIx64 ", 0x%016" PRIx64 "},\n", hashes.certified.value(), hashes.plain.value());
  EXPECT_EQ(hashes.certified.value(), kExpected[GetParam()].certified);
  EXPECT_EQ(hashes.plain.value(), kExpected[GetParam()].plain);
}

INSTANTIATE_TEST_SUITE_P(Slices, Answers, testing::Range(std::size_t{0}, kSlices));

}  // namespace
