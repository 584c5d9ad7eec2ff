// SPDX-License-Identifier: MIT
// Cases of any family, for experiments that are not about one family.
#pragma once

#include <optional>
#include <stdexcept>
#include <utility>

#include "cases/ask.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/neighbours.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

[[nodiscard]] inline Case any_case(Random& random) {
  const Family family = families()[random.index(families().size())];
  return make_case(family, random.bits() >> 16U);
}

/// Calls `draw` until it returns a legal value, and returns that. Nearly all that is drawn is legal. Throws
/// std::runtime_error when a thousand in a row are not.
template <class Draw>
[[nodiscard]] auto first_legal(const Draw& draw) {
  for (int tries = 0; tries < 1000; ++tries) {
    if (auto drawn = draw()) return *std::move(drawn);
  }
  throw std::runtime_error("the kernel refuses a thousand in a row");
}

/// A case whose occluder and box the kernel accepts.
[[nodiscard]] inline Case any_legal_case(Random& random) {
  return first_legal([&]() -> std::optional<Case> {
    Case c = any_case(random);
    const bool is_legal = make_frustum(c).frustum && check(c.box) == kernel::Refusal::none;
    return is_legal ? std::optional(std::move(c)) : std::nullopt;
  });
}

/// A neighbour of the box that the kernel accepts.
[[nodiscard]] inline Box legal_neighbour(Random& random, const Box& box) {
  return first_legal([&]() -> std::optional<Box> {
    Box moved = neighbour(box, random.bits());
    return check(moved) == kernel::Refusal::none ? std::optional(moved) : std::nullopt;
  });
}

}  // namespace occlude::fuzz
