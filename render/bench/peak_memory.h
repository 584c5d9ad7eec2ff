// SPDX-License-Identifier: MIT
// Memory that a piece of work takes.
#pragma once

#include <cstddef>
#include <optional>

namespace occlude::experiments {

/// Memory of the process beyond what it had when this was made, in pages that are really there (resident), as the kernel
/// counts them: what the work took at its worst, and what it has now. What was freed is given back to the system before each
/// count but that of the peak: else the work could live unseen on what the process freed before it, and what it freed itself
/// would count as held. Nothing where the system does not tell.
class PeakMemory {
 public:
  PeakMemory();

  [[nodiscard]] std::optional<std::size_t> peak_bytes() const;
  [[nodiscard]] std::optional<std::size_t> held_bytes() const;

 private:
  std::optional<std::size_t> before_;
};

}  // namespace occlude::experiments
