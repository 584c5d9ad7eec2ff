// SPDX-License-Identifier: MIT
#include "counted_files.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/model_io.h"
#include "occlude/render/resource_limits.h"

namespace occlude::render {
namespace {

// Importers need about twenty times the size of a file (3MF, which is compressed, a hundred times), and read megabytes per
// second.
constexpr std::uint64_t kMemory = std::uint64_t{256} << 20U, kMemoryPerByte = 128;
constexpr std::uint64_t kSeconds = 20, kBytesPerSecond = 100'000;

/// Tells files apart, whatever names they are opened by.
std::pair<dev_t, ino_t> identity(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0)
    throw InputError(file.string() + ": cannot read: " + std::generic_category().message(errno));
  return {status.st_dev, status.st_ino};
}

}  // namespace

ChildLimits import_limits_for(std::uint64_t content) {
  // Half of the memory: this process holds the model too, once it is handed over.
  return {std::min(kMemory + kMemoryPerByte * content, most_memory() / 2), kSeconds + content / kBytesPerSecond};
}

std::string import_limits() {
  return fmt::format(
      "{} of memory and {} s of processor time, and {} bytes and {} us more for each byte that it reads but zeros "
      "and blanks",
      in_mebibytes(kMemory), kSeconds, kMemoryPerByte, 1'000'000 / kBytesPerSecond);
}

void CountedFiles::count(const std::filesystem::path& file) {
  require_readable(file);
  if (seen_.insert(identity(file)).second) change_limits(import_limits_for(content_ += content_of(file)));
}

}  // namespace occlude::render
