// SPDX-License-Identifier: MIT
// Memory that lives as long as one call. It is on the stack; only occluders with very many vertices take memory from the
// heap.
#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>

namespace occlude::kernel {

class Scratch {
 public:
  Scratch() = default;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] std::pmr::memory_resource& memory() { return memory_; }

 private:
  /// A vector that grows by doubling leaves about as much memory behind as it holds. This is enough for the four vectors
  /// that a loop of 32 vertices, of 24 bytes each, needs.
  static constexpr std::size_t kBytes = 8192;

  alignas(std::max_align_t) std::array<std::byte, kBytes> buffer_;
  std::pmr::monotonic_buffer_resource memory_{buffer_.data(), buffer_.size()};
};

}  // namespace occlude::kernel
