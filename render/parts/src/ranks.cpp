// SPDX-License-Identifier: MIT
#include "occlude/render/ranks.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace occlude::render {
namespace {

/// What mpirun of Open MPI tells its processes, before MPI is initialised.
std::size_t number_of(const char* variable, std::size_t otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

}  // namespace

bool is_of_mpirun() { return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr; }

std::size_t ranks() {
  static const std::size_t count = std::max<std::size_t>(number_of("OMPI_COMM_WORLD_SIZE", 1), 1);
  return count;
}

bool is_first_rank() {
  static const bool is_first = number_of("OMPI_COMM_WORLD_RANK", 0) == 0;
  return is_first;
}

bool mpirun_has_terminal() {
  if (!is_of_mpirun()) return false;
  std::error_code error;  // mpirun may be on another machine, and the parent is another program there
  const std::string target = std::filesystem::read_symlink(fmt::format("/proc/{}/fd/2", getppid()), error).string();
  return target.starts_with("/dev/pts/") || target.starts_with("/dev/tty");
}

}  // namespace occlude::render
