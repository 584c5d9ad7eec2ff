// SPDX-License-Identifier: MIT
#include "occlude/render/line_reader.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "occlude/render/errors.h"
#include "occlude/render/progress.h"

namespace occlude::render {

LineReader::LineReader(const std::string& file) : name_(file == "-" ? "standard input" : file), file_(stdin) {
  if (file == "-") return;
  errno = std::filesystem::is_directory(file) ? EISDIR : 0;
  if (errno == 0) opened_.reset(std::fopen(file.c_str(), "r"));
  file_ = opened_.get();
  if (file_ == nullptr) fail("cannot be opened");
  std::error_code error;
  if (std::filesystem::is_regular_file(file, error)) size_ = std::filesystem::file_size(file, error);
}

bool LineReader::next(std::string& line) {
  check_interrupt();
  char* text = buffer_.release();
  errno = 0;
  const ssize_t length = getline(&text, &capacity_, file_);
  buffer_.reset(text);
  if (length < 0) {
    if (std::feof(file_) == 0) fail("cannot be read");
    return false;
  }
  ++number_;
  read_ += static_cast<std::size_t>(length);
  const bool has_break = text[length - 1] == '\n';
  line.assign(text, static_cast<std::size_t>(length) - (has_break ? 1 : 0));
  return true;
}

void LineReader::fail(const char* what) const {
  const int error = errno;
  check_interrupt();
  throw InputError(name_ + ": " + what + ": " + std::generic_category().message(error != 0 ? error : EIO));
}

}  // namespace occlude::render
