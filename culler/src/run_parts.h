// SPDX-License-Identifier: MIT
// Parts of a frame on the threads of the caller.
#pragma once

#include <cstddef>
#include <functional>
#include <new>
#include <span>

#include "occlude/culler/executor.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// Calls work(part) for each of the parts, on any threads, and sets part.is_done. A part whose thread rounds otherwise, or
/// has no memory, is worked on by the calling thread when all have returned. What the executor throws, and what work throws
/// there, is thrown on. REQUIRES: no part is done; work begins anew with a part that it could not finish.
template <class Part, class Work>
void run_parts(const Executor& executor, std::span<Part> parts, const Work& work) {
  const auto finish = [&](Part& part) {
    work(part);
    part.is_done = true;
  };
  const auto try_part = [&](std::size_t i) {
    if (kernel::check_rounding() != kernel::Refusal::none) return;
    try {
      finish(parts[i]);
    } catch (const std::bad_alloc&) {
      // It is not done.
    }
  };
  executor.run(parts.size(), std::cref(try_part));
  for (Part& part : parts) {
    if (!part.is_done) finish(part);
  }
}

}  // namespace occlude::culler
