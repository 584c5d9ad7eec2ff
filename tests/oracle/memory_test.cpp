// SPDX-License-Identifier: MIT
#include "occlude/oracle/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <new>

namespace occlude::oracle {
namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

/// Takes all memory that this process may still have.
void exhaust_memory() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_AS, &none);
  constexpr std::size_t kLargest = std::size_t{1} << 24U, kLeast = 16;
  for (std::size_t size = kLargest; size >= kLeast; size /= 2) {
    while (static_cast<void*>(std::malloc(size)) != nullptr) {
    }
  }
}

/// Ends the process: with 0 if what is thrown within std::call_once() without any memory left is caught.
[[noreturn]] void throw_without_memory() {
  throw_when_memory_is_out();
  exhaust_memory();
  std::once_flag once;
  try {
    std::call_once(once, [] { throw std::bad_alloc(); });
  } catch (const std::bad_alloc&) {
    std::_Exit(0);
  }
  std::_Exit(1);
}

TEST(MemoryDeathTest, WhatIsThrownWithinCallOnceIsCaughtWithoutMemory) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // a process of its own, in which nothing was thrown before
  EXPECT_EXIT(throw_without_memory(), testing::ExitedWithCode(0), "");
}

#endif

}  // namespace
}  // namespace occlude::oracle
