// SPDX-License-Identifier: MIT
#include "occlude/render/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace fs = std::filesystem;
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

/// Where the bytes go until commit(). A device or pipe (`--out /dev/stdout`) is written directly: renaming a file over it
/// would replace it.
fs::path temporary_name(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) return path;
  return path.parent_path() / ("." + path.filename().string() + ".tmp-" + std::to_string(getpid()));
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), temporary_(temporary_name(path_)) {
  const bool is_folder = !path_.has_filename() || fs::is_directory(path_);
  errno = is_folder ? EISDIR : 0;
  if (!is_folder) stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_.is_open()) throw InputError(path_.string() + ": cannot create: " + reason(errno));
}

OutputFile::~OutputFile() {
  if (committed_ || temporary_ == path_) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void OutputFile::commit() {
  errno = 0;
  stream_.close();
  if (stream_.fail()) throw InputError(path_.string() + ": cannot write: " + reason(errno != 0 ? errno : EIO));
  std::error_code error;
  if (temporary_ != path_) fs::rename(temporary_, path_, error);
  if (error) throw InputError(path_.string() + ": cannot create: " + error.message());
  committed_ = true;
}

}  // namespace occlude::render
