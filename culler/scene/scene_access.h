// SPDX-License-Identifier: MIT
// What the project itself asks of a scene, beside what programs do.
#pragma once

#include <shared_mutex>

#include "occlude/culler/scene.h"

namespace occlude::culler {

struct SceneAccess {
  /// While this is kept, update() waits.
  [[nodiscard]] static std::shared_lock<std::shared_mutex> keep_from_updates(const Scene& scene);
};

}  // namespace occlude::culler
