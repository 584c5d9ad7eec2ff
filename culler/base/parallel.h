// SPDX-License-Identifier: MIT
// The same work on several threads.
#pragma once

#include <cstddef>

#include "occlude/culler/executor.h"

namespace occlude::culler {

/// Calls checkpoint() and then work(i), once for every i < count, by the executor of the checkpoint. Returns when all calls
/// have returned. If a call throws, no further calls begin. Once those that run have returned, the first exception is thrown
/// on. Threads that do not round to nearest call nothing; what they leave, the calling thread does.
void parallel_for(std::size_t count, const Executor::Part& work, const Checkpoint& checkpoint = {});

}  // namespace occlude::culler
