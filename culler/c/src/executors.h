// SPDX-License-Identifier: MIT
// Threads of the caller.
#pragma once

#include <stdexcept>
#include <string>

#include "occlude.h"
#include "occlude/culler/executor.h"
#include "status.h"
#include "structs.h"

namespace occlude::c {

/// The executor of the caller.
[[nodiscard]] inline culler::Executor to_executor(const occlude_executor* given) {
  using culler::Executor;
  const auto executor = read(given, occlude_executor OCCLUDE_EXECUTOR_INIT, "executor");
  if (executor.run == nullptr) throw std::invalid_argument("run of the executor is null");
  if (executor.threads == 0 || executor.threads > Executor::kMostThreads) {
    throw std::invalid_argument("threads of the executor is " + std::to_string(executor.threads) + ", must be 1 to 65536");
  }
  const auto run = [run = executor.run, context = executor.context](std::size_t count, const Executor::Part& part) {
    const auto call = [](void* work, std::size_t i) { (*static_cast<const Executor::Part*>(work))(i); };
    run(context, count, call, const_cast<Executor::Part*>(&part));
  };
  return {executor.threads, run};
}

}  // namespace occlude::c
