// SPDX-License-Identifier: MIT
// Another rounding mode of the processor, for tests that everything detects it.
#pragma once

#include <array>
#include <cfenv>

namespace occlude {

/// The rounding mode holds while this object lives.
class WithRounding {
 public:
  explicit WithRounding(int mode) : before_(std::fegetround()) { std::fesetround(mode); }
  ~WithRounding() { std::fesetround(before_); }
  WithRounding(const WithRounding&) = delete;
  WithRounding& operator=(const WithRounding&) = delete;

 private:
  int before_;
};

/// WebAssembly has no others, and does not say so when it is asked for one.
#ifdef __wasm__
inline constexpr bool kHasOtherRoundings = false;
#else
inline constexpr bool kHasOtherRoundings = true;
#endif
inline constexpr std::array kOtherRoundings{FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

}  // namespace occlude
