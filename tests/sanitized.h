// SPDX-License-Identifier: MIT
// How much tests do under sanitizers.
#pragma once

namespace occlude {

/// `usual`, or `sanitized` under sanitizers, which make tests three to ten times slower, and find as much in fewer cases.
template <class T>
[[nodiscard]] constexpr T unless_sanitized([[maybe_unused]] T usual, [[maybe_unused]] T sanitized) {
#ifdef OCCLUDE_SANITIZED
  return sanitized;
#else
  return usual;
#endif
}

}  // namespace occlude
