// SPDX-License-Identifier: MIT
#include "occlude/render/input_limits.h"

#include <fmt/format.h>

#include "assimp_import.h"
#include "occlude/render/memory_limit.h"

namespace occlude::render {

std::string in_mebibytes(std::uint64_t bytes) { return fmt::format("{} MiB", bytes >> 20U); }

std::string limits_help() {
  return fmt::format(
      "Limits: a JSON file, and a line of JSON Lines, has at most {}, any other file {}. The import library (formats "
      "other\nthan PLY and OBJ) has {}. In all, a\n"
      "command takes at most {}, three quarters of the machine's memory.",
      in_mebibytes(kMostJson), in_mebibytes(kMostBytes), import_limits(), in_mebibytes(most_memory()));
}

}  // namespace occlude::render
