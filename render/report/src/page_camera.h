// SPDX-License-Identifier: MIT
// A camera as pages have it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "occlude/culler/camera.h"

namespace occlude::render {

[[nodiscard]] nlohmann::ordered_json page_json(const glm::dvec3& v);

/// What all cameras of a path share: all but eye and target.
[[nodiscard]] nlohmann::ordered_json page_lens(const culler::Camera& camera);

}  // namespace occlude::render
