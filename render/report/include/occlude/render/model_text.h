// SPDX-License-Identifier: MIT
// What was read of a model, in words.
#pragma once

#include <string>

#include "occlude/culler/hierarchy.h"
#include "occlude/render/convention.h"

namespace occlude::render {

/// A line that says how many polygons the model has, how many of them have no area, light passes through, or are drawn as
/// several; how large it is, in which unit, and which axis is up.
[[nodiscard]] std::string text_of_model(const std::string& name, const culler::Hierarchy& hierarchy,
                                        const Convention& convention);

}  // namespace occlude::render
