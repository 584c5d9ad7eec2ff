// SPDX-License-Identifier: MIT
// Cases of the kernel's question, made from a seed, in families that each aim at one way of being wrong.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "occlude/fuzz/case.h"

namespace occlude::fuzz {

/// What each is: fuzz/README.md. The name tells the kind: with `obb` the box is oriented, with `polytope` the occluder is
/// one, with `orthographic` the viewpoint is a direction.
enum class Family {
#define FAMILY(name, ...) name,
#include "occlude/fuzz/families.inc"
};

[[nodiscard]] std::span<const Family> families();

[[nodiscard]] std::string_view name(Family family);

/// The same case for the same arguments, on every machine. A few in a hundred are not legal (see the README).
[[nodiscard]] Case make_case(Family family, std::uint64_t seed);

}  // namespace occlude::fuzz
