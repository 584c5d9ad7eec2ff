// SPDX-License-Identifier: MIT
// Memory for what lives as long as a call: on the stack, and from the heap only for occluders with very many vertices.
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
  /// Vectors that grow by doubling leave as much behind as they hold: enough for the four that a loop of 32 vertices, each
  /// of 24 bytes, takes.
  static constexpr std::size_t kBytes = 8192;

  alignas(std::max_align_t) std::array<std::byte, kBytes> buffer_;
  std::pmr::monotonic_buffer_resource memory_{buffer_.data(), buffer_.size()};
};

}  // namespace occlude::kernel
