// SPDX-License-Identifier: MIT
// Cases of the kernel's question, made from a seed. Each family of cases aims at one way of being wrong.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "occlude/fuzz/case.h"

namespace occlude::fuzz {

/// docs/families.md describes the families. The name says what kind a family is: with `obb` the box is oriented, with
/// `polytope` the occluder is a polytope, with `orthographic` the viewpoint is a direction.
enum class Family {
#define FAMILY(name, ...) name,
#include "occlude/fuzz/families.inc"
};

[[nodiscard]] std::span<const Family> families();

[[nodiscard]] std::string_view name(Family family);

/// Makes a case. The same arguments give the same case on every machine. A few in a hundred are not legal.
[[nodiscard]] Case make_case(Family family, std::uint64_t seed);

}  // namespace occlude::fuzz
