// SPDX-License-Identifier: MIT
#include "occlude/render/output_place.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace fs = std::filesystem;
namespace {

/// Identifies a file under any name.
using Identity = std::pair<dev_t, ino_t>;

struct stat status_of(int descriptor) {
  struct stat status {};
  fstat(descriptor, &status);
  return status;
}

Identity identity(const struct stat& status) { return {status.st_dev, status.st_ino}; }

// Global to the process, like its signals and standard streams.
std::set<Identity>& inputs() {
  static std::set<Identity> files;
  return files;
}

std::set<fs::path>& outputs() {
  static std::set<fs::path> places;
  return places;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw InputError(file.string() + ": cannot create: " + reason);
}

[[noreturn]] void refuse(const fs::path& file, int error) { refuse(file, std::generic_category().message(error)); }

/// The target of a link; the target need not exist.
fs::path beyond_links(const fs::path& file) {
  constexpr int kMostLinks = 40;  // the limit of Linux
  fs::path place = file;
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(place, error)); ++links) {
    if (links == kMostLinks) refuse(file, ELOOP);
    place = place.parent_path() / fs::read_symlink(place, error);
  }
  const fs::path folder = fs::canonical(place.has_parent_path() ? place.parent_path() : ".", error);
  if (error) refuse(file, error.message());
  return folder / place.filename();
}

/// The status of the file; none if it does not exist.
std::optional<struct stat> find(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) == 0) return status;
  if (errno != ENOENT) refuse(file, errno);
  return std::nullopt;
}

/// Checks the permission bits too: root can write read-only files, but should not replace them.
bool is_read_only(const fs::path& file, const struct stat& status) {
  constexpr mode_t kAnyone = S_IWUSR | S_IWGRP | S_IWOTH;
  return (status.st_mode & kAnyone) == 0 || access(file.c_str(), W_OK) != 0;
}

bool is_standard_stream(const struct stat& status) {
  constexpr std::array kStreams{STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO};
  return std::ranges::any_of(kStreams, [&](int stream) { return identity(status_of(stream)) == identity(status); });
}

}  // namespace

void keep_input(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return;
  if (identity(status) == identity(status_of(STDOUT_FILENO))) {
    throw InputError(file.string() + ": cannot read: named twice: it is standard output");
  }
  inputs().insert(identity(status));
}

OutputPlace::OutputPlace(const fs::path& file) : path_(file) {
  if (!file.has_filename()) refuse(file, file.empty() ? ENOENT : EISDIR);
  if (const std::optional<struct stat> found = find(file)) {
    if (S_ISDIR(found->st_mode)) refuse(file, EISDIR);
    is_device_ = !S_ISREG(found->st_mode);
    if (is_device_) return;
    if (inputs().contains(identity(*found))) refuse(file, "named twice: it is also an input");
    if (is_standard_stream(*found)) refuse(file, "named twice: it is standard input, output or error");
    if (is_read_only(file, *found)) refuse(file, "it is read-only");
    permissions_ = found->st_mode & 07777;
  }
  path_ = beyond_links(file);
  if (!outputs().insert(path_).second) refuse(file, "named twice: two outputs would be the same file");
}

OutputPlace::~OutputPlace() {
  if (!is_device_) outputs().erase(path_);
}

void require_places(const fs::path& folder, const std::function<bool(const std::string& name)>& is_such) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (is_such(entry.path().filename().string())) static_cast<void>(OutputPlace(entry.path()));
  }
  const fs::path place = fs::canonical(folder, error);
  if (error) refuse(folder, error.message());
  for (const fs::path& output : outputs()) {
    if (output.parent_path() == place && is_such(output.filename().string())) {
      refuse(output, "named twice: two outputs would be the same file");
    }
  }
}

}  // namespace occlude::render
