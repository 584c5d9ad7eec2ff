// SPDX-License-Identifier: MIT
// The extensions of glTF: which are read, and which do not matter for geometry.
#pragma once

#include <string>
#include <vector>

#include "gltf_document.h"

namespace occlude::render::gltf {

/// Refuses a file that requires an extension that is neither read nor known to leave geometry alone. Returns a warning for
/// each other one that it uses.
[[nodiscard]] std::vector<std::string> check_extensions(const Document& document);

}  // namespace occlude::render::gltf
