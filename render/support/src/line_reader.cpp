// SPDX-License-Identifier: MIT
#include "occlude/render/line_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "occlude/render/errors.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/progress.h"

namespace occlude::render {
namespace {

constexpr std::size_t kPipeBuffer = 1U << 16U;  // the size of a pipe on Linux

}  // namespace

LineReader::LineReader(const std::string& file) : name_(file == "-" ? "standard input" : file), file_(STDIN_FILENO) {
  if (file == "-") return;
  std::error_code error;
  const bool is_folder = std::filesystem::is_directory(file, error);
  file_ = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (is_folder) errno = EISDIR;
  if (file_ < 0 || is_folder) fail("cannot be opened");
  if (std::filesystem::is_regular_file(file, error)) size_ = std::filesystem::file_size(file, error);
}

LineReader::~LineReader() {
  if (file_ > STDIN_FILENO) close(file_);
}

bool LineReader::next(std::string& line) {
  check_interrupt();
  line.clear();
  if (used_ >= buffer_.size() && !refill()) return false;
  ++number_;
  std::size_t end = 0;
  do {
    end = std::min(buffer_.find('\n', used_), buffer_.size());
    line.append(buffer_, used_, end - used_);
    if (line.size() > kMostJson) {
      throw InputError(fmt::format("{}:{}: the line is longer than {}", name_, number_, in_mebibytes(kMostJson)));
    }
    used_ = end + 1;
  } while (end == buffer_.size() && refill());
  return true;
}

bool LineReader::refill() {
  buffer_.resize(kPipeBuffer);
  ssize_t length = 0;
  do {
    length = ::read(file_, buffer_.data(), buffer_.size());
    if (length < 0) check_interrupt();
  } while (length < 0 && errno == EINTR);
  if (length < 0) fail("cannot be read");
  buffer_.resize(static_cast<std::size_t>(length));
  used_ = 0;
  read_ += buffer_.size();
  return length > 0;
}

void LineReader::fail(const char* what) const {
  const int error = errno;
  check_interrupt();
  throw InputError(name_ + ": " + what + ": " + std::generic_category().message(error));
}

}  // namespace occlude::render
