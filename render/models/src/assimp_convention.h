// SPDX-License-Identifier: MIT
// What files of the import library say of their unit and of the axis that is up.
#pragma once

#include <assimp/scene.h>

#include <string_view>

#include "occlude/render/convention.h"

namespace occlude::render {

/// What the file says, or its format. Where the importer of this name has turned or scaled the scene for that, takes it back
/// from the placement of the root.
[[nodiscard]] Convention take_convention(const aiScene& scene, std::string_view importer);

}  // namespace occlude::render
