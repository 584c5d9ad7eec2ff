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
    {0x9defa64d079acef3, 0x3c16fad45dac3604}, {0x8f608cb510b02a91, 0xada78f9eacd4832e},
    {0xb9af45f0f0b00df9, 0x2973043a69ede737}, {0x86aa52869c769a7b, 0xc03acf0c70d2859d},
    {0x969722f1580185f0, 0x76f29a0dfcb01a94}, {0x0206bde509c82e3c, 0x5034204aca331074},
    {0x40a954b7c443c0bd, 0x6cb548d61c58164a}, {0x9b3c1ab054f7c60a, 0xbbb64ac22cb0cc0c},
    {0x17b3803f454da7b2, 0x6ff99359f7f617f9}, {0xad87b6a15d35a665, 0xb02fd74f0e1e271c},
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
