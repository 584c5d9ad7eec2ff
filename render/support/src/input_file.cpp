// SPDX-License-Identifier: MIT
#include "occlude/render/input_file.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
  throw InputError(file.string() + ": cannot read: " + reason);
}

struct Opened {
  std::ifstream in;
  std::uint64_t size;
};

Opened open_file(const fs::path& file, std::uint64_t most) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) fail(file, error ? error.message() : "no such file");
  if (fs::is_directory(status)) fail(file, "it is a directory");
  // A pipe or device has no size, and may never end.
  if (!fs::is_regular_file(status)) fail(file, "it is not a regular file");
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) fail(file, error.message());
  if (size > most) fail(file, "it is larger than " + in_mebibytes(most));
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) fail(file, std::generic_category().message(errno));
  return {std::move(in), size};
}

/// Neither zero nor a blank of C. Without branches, so that the compiler counts many at a time.
bool is_content(char c) {
  const bool is_control_blank = (c >= '\t') & (c <= '\r');
  return (c != '\0') & (c != ' ') & !is_control_blank;
}

}  // namespace

std::string in_mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20U) + " MiB"; }

std::string read_input(const fs::path& file, std::uint64_t most) {
  Opened opened = open_file(file, most);
  std::string bytes(static_cast<std::size_t>(opened.size), '\0');
  opened.in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::uintmax_t>(opened.in.gcount()) != opened.size) fail(file, "it changed while it was read");
  return bytes;
}

void require_readable(const fs::path& file, std::uint64_t most) { static_cast<void>(open_file(file, most)); }

std::uint64_t content_of(const fs::path& file, std::uint64_t most) {
  std::ifstream in = open_file(file, most).in;
  std::vector<char> piece(std::size_t{1} << 20U);
  std::uint64_t content = 0;
  do {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    content += static_cast<std::uint64_t>(std::count_if(piece.begin(), piece.begin() + in.gcount(), is_content));
  } while (in);
  if (in.bad()) fail(file, "it changed while it was read");
  return content;
}

}  // namespace occlude::render
