// SPDX-License-Identifier: MIT
// The coarse picture of a frame of a model, as the frame leaves it.
#pragma once

#include <memory>
#include <utility>

#include "cover/cover_buffer.h"
#include "frame/view_memory.h"
#include "occlude/culler/culler.h"

namespace occlude::culler {

/// Throws as Culler::cull(). REQUIRES: options.method is cover.
template <class AnyCamera>
[[nodiscard]] std::shared_ptr<const CoverBuffer> cover_of(const Culler& culler, const AnyCamera& camera,
                                                          const CullOptions& options) {
  View view;
  culler.cull(camera, options, view);
  return std::make_shared<const CoverBuffer>(std::move(memory_of(view).cover.buffer));
}

}  // namespace occlude::culler
