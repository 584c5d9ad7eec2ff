// SPDX-License-Identifier: MIT
// What frames cull and what shows in them as bytes, for parts of a validation.
#pragma once

#include <string>

#include "culled_sets.h"
#include "visibility_check.h"

namespace occlude::cli {

[[nodiscard]] std::string pack(const CulledSets& culled);
[[nodiscard]] CulledSets unpack_culled(const std::string& bytes);

[[nodiscard]] std::string pack(const Visibility& visibility);
/// Of the frames of this part of a walk. Throws render::PartError where it cannot be.
[[nodiscard]] Visibility unpack_visibility(const std::string& bytes, const CheckedWalk& walk, const CulledSets& part);

/// Adds the frames of `part` behind those of `whole`.
void append(Visibility& whole, Visibility&& part);

}  // namespace occlude::cli
