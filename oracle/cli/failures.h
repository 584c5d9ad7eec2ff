// SPDX-License-Identifier: MIT
// What is culled and shows: each with frame, polygon, witness and picture.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "item_buffers.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/render/camera_path.h"
#include "visibility_check.h"

namespace occlude::cli {

/// The witness with this number of the frame: its text, or where it stands.
using WitnessText = std::function<std::string(std::size_t frame, std::size_t number)>;

/// One line, about one of them.
[[nodiscard]] std::string describe(const FalseCull& failure, const culler::Hierarchy& hierarchy, const WitnessText& witness);

/// Writes failures.jsonl into `folder`, a line for each, and of the first frames that have one a picture of the whole model
/// from there with such polygons in red.
void write_failures(const std::string& folder, const Visibility& visibility, const culler::Hierarchy& hierarchy,
                    const render::CameraPath& path, double aspect, const WitnessText& witness, ItemBuffers& buffers);

}  // namespace occlude::cli
