// SPDX-License-Identifier: MIT
#include "allocations.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <string>

namespace allocations_test {

std::atomic<std::size_t> count = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++count;
  void* const memory = alignment <= alignof(std::max_align_t)
                           ? std::malloc(size == 0 ? 1 : size)
                           : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace allocations_test

std::size_t allocations() { return allocations_test::count; }

// The library makes the forms for arrays, and those that do not throw, from these.
void* operator new(std::size_t size) { return allocations_test::counted(size, 1); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocations_test::counted(size, static_cast<std::size_t>(alignment));
}
// Not inlined: where GCC inlines these alone, it takes them for a mistake.
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace allocations_test {

TEST(Allocations, AreCounted) {
  const std::size_t before = allocations();
  const std::string longer_than_fits_inside(1000, 'x');
  EXPECT_EQ(allocations(), before + 1);
}

}  // namespace allocations_test
