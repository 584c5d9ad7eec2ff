// SPDX-License-Identifier: MIT
#include "peak_memory.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace occlude::experiments {
namespace {

/// A member of /proc/self/status, which is in units of 1024 bytes.
std::optional<std::size_t> status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name + ":")) return std::stoull(line.substr(name.size() + 1)) * 1024;
  }
  return std::nullopt;
}

/// Sets the peak to the resident memory of now (proc(5): clear_refs).
bool reset_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;
  return file.good();
}

std::optional<std::size_t> beyond(std::optional<std::size_t> before, std::optional<std::size_t> now) {
  if (!before || !now) return std::nullopt;
  return *now - std::min(*before, *now);
}

}  // namespace

PeakMemory::PeakMemory() {
  // Large blocks get their own pages, as in a fresh process, so that the count does not depend on the state of the heap.
  // Without this call the threshold grows with the size of freed blocks.
  mallopt(M_MMAP_THRESHOLD, 128 * 1024);
  malloc_trim(0);
  if (reset_peak()) before_ = status_bytes("VmRSS");
}

std::optional<std::size_t> PeakMemory::peak_bytes() const { return beyond(before_, status_bytes("VmHWM")); }

std::optional<std::size_t> PeakMemory::held_bytes() const {
  malloc_trim(0);
  return beyond(before_, status_bytes("VmRSS"));
}

}  // namespace occlude::experiments
