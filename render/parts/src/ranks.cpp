// SPDX-License-Identifier: MIT
#include "occlude/render/ranks.h"

#include <algorithm>
#include <cstdlib>

namespace occlude::render {
namespace {

/// What mpirun of Open MPI tells its processes, before MPI is initialised.
std::size_t number_of(const char* variable, std::size_t otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

}  // namespace

std::size_t ranks() {
  static const std::size_t count = std::max<std::size_t>(number_of("OMPI_COMM_WORLD_SIZE", 1), 1);
  return count;
}

bool is_first_rank() {
  static const bool is_first = number_of("OMPI_COMM_WORLD_RANK", 0) == 0;
  return is_first;
}

}  // namespace occlude::render
