// SPDX-License-Identifier: MIT
// Which models the cullers take.
#pragma once

#include <stdexcept>
#include <string>

#include "bounds.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// Throws std::invalid_argument, with the vertex and the reason, for a coordinate that is not finite or out of the kernel's
/// legal range.
inline void require_legal(const PolygonSoup& soup) {
  for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
    if (const auto refusal = kernel::check(to_kernel(soup.vertices[v])); refusal != kernel::Refusal::none) {
      throw std::invalid_argument("vertex " + std::to_string(v) + ": " + std::string(kernel::to_string(refusal)));
    }
  }
}

}  // namespace occlude::culler
