// SPDX-License-Identifier: MIT
// The polytopes of shells: made before, or each when it is first asked for.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "occlude/kernel/convex_polytope.h"

namespace occlude::culler {

/// May be asked on several threads at once.
class ShellPolytopes {
 public:
  /// None of `count` is made.
  explicit ShellPolytopes(std::size_t count) : later_(count) {}
  /// All are made.
  explicit ShellPolytopes(std::vector<kernel::ConvexPolytope> made) : made_(std::move(made)) {}
  ShellPolytopes(const ShellPolytopes&) = delete;
  ShellPolytopes& operator=(const ShellPolytopes&) = delete;
  ~ShellPolytopes() {
    for (const auto& one : later_) delete one.load();
  }

  /// Polytope i. It is the result of make() if none was there.
  template <class Make>
  const kernel::ConvexPolytope& get(std::size_t i, const Make& make) {
    if (!made_.empty()) return made_[i];
    std::atomic<const kernel::ConvexPolytope*>& place = later_[i];
    const kernel::ConvexPolytope* there = place.load(std::memory_order_acquire);
    if (there) return *there;
    auto mine = std::make_unique<const kernel::ConvexPolytope>(make());
    // Of several threads that make it, the first keeps its own, which is the same as the others'.
    if (!place.compare_exchange_strong(there, mine.get(), std::memory_order_acq_rel)) return *there;
    return *mine.release();
  }

 private:
  std::vector<kernel::ConvexPolytope> made_;
  std::vector<std::atomic<const kernel::ConvexPolytope*>> later_;
};

}  // namespace occlude::culler
