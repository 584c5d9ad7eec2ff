// SPDX-License-Identifier: MIT
// The memory that a piece of work takes.
#pragma once

#include <cstddef>
#include <optional>

namespace occlude::experiments {

/// Resident memory of the process beyond what it had at construction, as counted by the kernel: the peak, and the present
/// amount. Freed memory is returned to the system before each count except that of the peak. Otherwise the work could reuse
/// memory that was freed earlier, which would not be counted, and memory that it freed would count as held. Empty if the
/// system does not report it.
class PeakMemory {
 public:
  PeakMemory();

  [[nodiscard]] std::optional<std::size_t> peak_bytes() const;
  [[nodiscard]] std::optional<std::size_t> held_bytes() const;

 private:
  std::optional<std::size_t> before_;
};

}  // namespace occlude::experiments
