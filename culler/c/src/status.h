// SPDX-License-Identifier: MIT
// Exceptions of the library as statuses.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "occlude.h"

namespace occlude::c {

/// An id of nothing that is in the scene.
struct UnknownId : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The caller wants no more.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped by the caller") {}
};

/// The status of the exception that is being handled, whose text becomes occlude_last_error().
[[nodiscard]] occlude_status status_of_exception() noexcept;

/// Runs the work of a function.
template <class Work>
[[nodiscard]] occlude_status guarded(Work&& work) noexcept {
  try {
    std::forward<Work>(work)();
    return OCCLUDE_OK;
  } catch (...) {
    return status_of_exception();
  }
}

inline void require(const void* pointer, const char* name) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + " is null");
}

[[noreturn]] inline void refuse_enumerator(const char* name, std::int32_t value) {
  throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + ", which is none of its enumerators");
}

}  // namespace occlude::c
