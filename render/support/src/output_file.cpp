// SPDX-License-Identifier: MIT
#include "occlude/render/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "occlude/render/errors.h"
#include "occlude/render/interrupt.h"

namespace occlude::render {
namespace fs = std::filesystem;
namespace {

/// With blocks of this size the cost of a system call is negligible.
constexpr std::size_t kBlock = 1U << 16U;

/// The name by which the system finds an open file that has none.
std::string link_to(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

/// Opens a file in the folder that has no name: nothing is left of it, however the process ends. Not every file system has
/// such files; then errno is EOPNOTSUPP.
int open_nameless(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
  if (descriptor < 0 || access(link_to(descriptor).c_str(), F_OK) == 0) return descriptor;
  ::close(descriptor);
  errno = EOPNOTSUPP;  // without /proc it could not be given a name
  return -1;
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), place_(path_) {
  if (place_.is_device()) {
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    descriptor_ = open_nameless(place_.path().parent_path());
    if (descriptor_ < 0 && errno == EOPNOTSUPP) open_named();
  }
  if (descriptor_ < 0) fail("cannot create", errno);
  if (place_.permissions()) fchmod(descriptor_, *place_.permissions());
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::string_view text) {
  if (buffer_.size() + text.size() > kBlock) flush();
  if (text.size() > kBlock) {
    send(text);
  } else {
    buffer_ += text;
  }
}

void OutputFile::close() {
  flush();
  if (!place_.is_device() && !temporary_) give_name();
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("cannot write", errno);
}

void OutputFile::commit() {
  if (descriptor_ >= 0) close();
  if (!temporary_) return;
  if (!temporary_->rename_to(place_.path())) fail("cannot create", errno);
  temporary_.reset();
}

void OutputFile::open_named() {
  make_temporary([this](const char* name) {
    descriptor_ = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return descriptor_ >= 0;
  });
}

void OutputFile::give_name() {
  make_temporary([this](const char* name) {
    return linkat(AT_FDCWD, link_to(descriptor_).c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
  });
  if (!temporary_) fail("cannot create", errno);
}

void OutputFile::make_temporary(const std::function<bool(const char* name)>& make) {
  for (unsigned number = 0; !temporary_; ++number) {
    const fs::path file = place_.path().parent_path() / fmt::format(".occlude.tmp-{}-{}", getpid(), number);
    std::optional<Leftover> made = Leftover::make(file, [&] { return make(file.c_str()); });
    if (!made && errno != EEXIST) return;
    if (made) temporary_.emplace(std::move(*made));
  }
}

void OutputFile::flush() {
  send(buffer_);
  buffer_.clear();
}

void OutputFile::send(std::string_view text) const {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno != EINTR) fail("cannot write", errno);
    if (written < 0) check_interrupt();
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::fail(const char* what, int error) const {
  check_interrupt();
  throw InputError(fmt::format("{}: {}: {}", path_.string(), what, std::generic_category().message(error)));
}

}  // namespace occlude::render
