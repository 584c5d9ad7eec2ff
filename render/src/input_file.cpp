// SPDX-License-Identifier: MIT
#include "input_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
  throw InputError(file.string() + ": cannot read: " + reason);
}

std::ifstream open(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) fail(file, error ? error.message() : "no such file");
  if (fs::is_directory(status)) fail(file, "it is a directory");
  // A pipe or device has no size to check counts against, and may never end.
  if (!fs::is_regular_file(status)) fail(file, "it is not a regular file");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) fail(file, std::generic_category().message(errno));
  return in;
}

}  // namespace

std::string read_input(const fs::path& file) {
  std::ifstream in = open(file);
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) fail(file, error.message());
  std::string bytes(static_cast<std::size_t>(size), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::uintmax_t>(in.gcount()) != size) fail(file, "it changed while it was read");
  return bytes;
}

void require_readable(const fs::path& file) { static_cast<void>(open(file)); }

}  // namespace occlude::render
