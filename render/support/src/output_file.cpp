// SPDX-License-Identifier: MIT
#include "occlude/render/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "occlude/render/errors.h"
#include "occlude/render/interrupt.h"

namespace occlude::render {
namespace fs = std::filesystem;
namespace {

/// With blocks of this size the cost of a system call is negligible.
constexpr std::size_t kBlock = 1U << 16U;

/// Creates a file with an unused name in the folder. The name is short: that of the output may have the longest length.
std::pair<int, std::optional<Leftover>> make_temporary(const fs::path& folder) {
  for (unsigned number = 0;; ++number) {
    const fs::path file = folder / fmt::format(".occlude.tmp-{}-{}", getpid(), number);
    int descriptor = -1;
    std::optional<Leftover> made = Leftover::make(file, [&] {
      descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      return descriptor >= 0;
    });
    if (made || errno != EEXIST) return {descriptor, std::move(made)};
  }
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), place_(path_) {
  if (place_.is_device()) {
    descriptor_ = open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    auto [descriptor, temporary] = make_temporary(place_.path().parent_path());
    descriptor_ = descriptor;
    if (temporary) temporary_.emplace(std::move(*temporary));
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
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("cannot write", errno);
}

void OutputFile::commit() {
  if (descriptor_ >= 0) close();
  if (!temporary_) return;
  if (!temporary_->rename_to(place_.path())) fail("cannot create", errno);
  temporary_.reset();
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
