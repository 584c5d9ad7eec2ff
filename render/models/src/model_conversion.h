// SPDX-License-Identifier: MIT
// Models in metres, with z up.
#pragma once

#include <filesystem>

#include "occlude/render/convention.h"
#include "occlude/render/model.h"

namespace occlude::render {

/// Does what is asked for, and says in the notes what coordinates mean. A turn is exact; a product with the unit is rounded
/// once, and is exact where the unit is a power of two. Throws InputError if neither the file nor the user says what is to
/// be converted, and if a coordinate leaves the range of legal ones.
void convert(Model& model, const Conversion& conversion, const std::filesystem::path& file);

}  // namespace occlude::render
