// SPDX-License-Identifier: MIT
// A million cases of all families and the hashes of their answers. The answers are the same bit for bit, whatever compiled
// the kernel. tests/builds.sh runs this test with other compilers, at other optimisation levels, with and without FMA, and
// on other platforms.
#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <variant>

#include "cases/ask.h"
#include "occlude/fuzz/cases.h"
#include "occlude/kernel/overlap.h"
#include "sanitized.h"

namespace answers_test {

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

/// The hashes of the answers. Those of `plain` depend on rounding, but they are the same everywhere too, because rounding
/// follows IEEE 754 and nothing is contracted.
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

/// There are ten slices of 100,000 cases each, which run in parallel. Case i is of family i modulo the number of families.
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

/// A change of the generator changes the cases, and with them all of these. While the cases are the same, nothing may change
/// the first column, and only a change of the paper's arithmetic, or of how planes are rounded to doubles, may change the
/// second.
constexpr Expected kExpected[] = {
    {0xf176a2d4aae1ee85, 0x9e148a3b61458094}, {0xe263d58f7084f625, 0x97fe3f9957fe83f7},
    {0x5014dd552f8b0dab, 0x194f3ec666ed8aff}, {0xd5b2732ea4b0d399, 0x9e05d149ecd5eebf},
    {0x65d72c2299ae369a, 0x9be7ef6af12eb59b}, {0x4d6b0abf14457541, 0xdea0b7e1e94fdd13},
    {0xd6904eff8105a334, 0x445a9c9658fd9bf3}, {0x79e61e86de9d4739, 0xdefa47d0a6233f75},
    {0x1790155c67da9f24, 0x1e47162507d78bd9}, {0xbbfeead3def7ad9c, 0x0eb833710e04fe51},
};

constexpr std::size_t kSlices = unless_sanitized(std::size(kExpected), std::size_t{1});

class Answers : public testing::TestWithParam<std::size_t> {};

TEST_P(Answers, HaveTheHashOfEveryBuild) {
  const Hashes hashes = hash_slice(GetParam());
  std::printf("{0x%016" PRIx64 ", 0x%016" PRIx64 "},\n", hashes.certified.value(), hashes.plain.value());
  EXPECT_EQ(hashes.certified.value(), kExpected[GetParam()].certified);
  EXPECT_EQ(hashes.plain.value(), kExpected[GetParam()].plain);
}

INSTANTIATE_TEST_SUITE_P(Slices, Answers, testing::Range(std::size_t{0}, kSlices));

}  // namespace answers_test
