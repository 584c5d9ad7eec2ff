// SPDX-License-Identifier: MIT
#include "peak_memory.h"

#include <gtest/gtest.h>

#include <vector>

namespace peak_memory_test {

using occlude::experiments::PeakMemory;

constexpr std::size_t kBytes = std::size_t{64} << 20U;

/// What was freed counts for the peak, but not as held. Sizes are in whole pages, and the process allocates memory for other
/// things too, so a quarter more or less is accepted.
TEST(PeakMemory, TellsThePeakFromWhatIsHeld) {
#ifdef OCCLUDE_SANITIZED
  GTEST_SKIP() << "sanitizers keep what is freed";
#endif
  const PeakMemory memory;
  if (!memory.peak_bytes()) GTEST_SKIP() << "the system does not tell";
  const std::vector<char> kept(kBytes, 1);
  { const std::vector<char> freed(kBytes, 1); }
  // Small pieces come from the heap, and return to it when they are freed.
  { const std::vector<std::vector<char>> pieces(kBytes / 1024, std::vector<char>(1000, 1)); }
  EXPECT_NEAR(static_cast<double>(*memory.peak_bytes()), 2.0 * kBytes, kBytes / 4.0);
  EXPECT_NEAR(static_cast<double>(*memory.held_bytes()), 1.0 * kBytes, kBytes / 4.0);
  const PeakMemory later;
  EXPECT_LT(*later.peak_bytes(), kBytes / 4);
}

}  // namespace peak_memory_test
