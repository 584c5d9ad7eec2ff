// SPDX-License-Identifier: MIT
// EXT_meshopt_compression. Only gltf_meshopt.cpp knows the library.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gltf_document.h"

namespace occlude::render::gltf {

/// The bytes of a bufferView. `extension` is its EXT_meshopt_compression, `bytes` the compressed ones.
[[nodiscard]] std::vector<std::byte> decode_meshopt(const json& extension, std::span<const std::byte> bytes);

}  // namespace occlude::render::gltf
