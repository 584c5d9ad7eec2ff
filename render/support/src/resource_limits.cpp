// SPDX-License-Identifier: MIT
#include "occlude/render/resource_limits.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

std::uint64_t page() { return static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)); }

/// Field `which` of /proc/self/statm, from 0, in bytes.
std::uint64_t memory_statistic(int which) {
  std::ifstream statistics("/proc/self/statm");
  std::uint64_t pages = 0;
  for (int i = 0; i <= which; ++i) statistics >> pages;
  return pages * page();
}

}  // namespace

std::uint64_t address_space_in_use() { return memory_statistic(0); }

std::uint64_t data_in_use() { return memory_statistic(5); }

bool can_have_memory(std::uint64_t bytes) {
  void* const memory = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) return false;
  munmap(memory, bytes);
  return true;
}

void limit_resource(int resource, rlim_t value) {
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_cur = std::min(value, limit.rlim_max);
  setrlimit(resource, &limit);
}

std::uint64_t most_memory() { return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) / 4 * 3 * page(); }

void limit_memory() { limit_resource(RLIMIT_AS, std::min(memory_limit(), address_space_in_use() + most_memory())); }

void require_stack() {
  constexpr rlim_t kLeast = rlim_t{1} << 20U;
  rlimit present{};
  getrlimit(RLIMIT_STACK, &present);
  if (present.rlim_cur >= kLeast) return;
  throw InputError(
      fmt::format("the stack is limited to {} KiB; at least 1024 KiB are needed (ulimit -s)", present.rlim_cur >> 10U));
}

std::uint64_t memory_limit() {
  rlimit present{};
  getrlimit(RLIMIT_AS, &present);
  return present.rlim_cur;
}

}  // namespace occlude::render
