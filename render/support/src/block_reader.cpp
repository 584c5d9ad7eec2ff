// SPDX-License-Identifier: MIT
#include "occlude/render/block_reader.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "gunzip.h"
#include "occlude/render/errors.h"
#include "occlude/render/progress.h"

namespace occlude::render {
namespace {

constexpr std::size_t kPipeBuffer = 1U << 16U;  // the size of a pipe on Linux

}  // namespace

BlockReader::BlockReader(const std::string& file) : name_(file == "-" ? "standard input" : file), file_(STDIN_FILENO) {
  if (file == "-") return;
  std::error_code error;
  const bool is_folder = std::filesystem::is_directory(file, error);
  file_ = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (is_folder) errno = EISDIR;
  if (file_ < 0 || is_folder) fail("cannot be opened");
  if (std::filesystem::is_regular_file(file, error)) size_ = std::filesystem::file_size(file, error);
}

BlockReader::~BlockReader() {
  if (file_ > STDIN_FILENO) close(file_);
}

std::string_view BlockReader::ahead() {
  while (used_ >= block_.size()) {
    used_ = 0;
    if (gunzip_) {
      if (!gunzip_->next(block_)) throw InputError(name_ + ": the compressed data are damaged");
      if (!block_.empty()) break;
    }
    const bool is_first = read_ == 0;
    std::string block;
    while (refill(block) && is_first && block.size() < Gunzip::kBegin.size() && Gunzip::kBegin.starts_with(block)) {
    }
    if (block.empty()) {
      if (gunzip_ && !gunzip_->is_complete()) throw InputError(name_ + ": the compressed data are cut off");
      block_.clear();
      break;
    }
    if (is_first && block.starts_with(Gunzip::kBegin)) gunzip_ = std::make_unique<Gunzip>();
    gunzip_ ? gunzip_->feed(std::move(block)) : block_.swap(block);
  }
  return std::string_view(block_).substr(used_);
}

bool BlockReader::refill(std::string& block) {
  const std::size_t before = block.size();
  block.resize(before + kPipeBuffer);
  ssize_t length = 0;
  do {
    length = ::read(file_, block.data() + before, kPipeBuffer);
    if (length < 0) check_interrupt();
  } while (length < 0 && errno == EINTR);
  if (length < 0) fail("cannot be read");
  block.resize(before + static_cast<std::size_t>(length));
  read_ += static_cast<std::size_t>(length);
  return length > 0;
}

void BlockReader::fail(const char* what) const {
  const int error = errno;
  check_interrupt();
  throw InputError(name_ + ": " + what + ": " + std::generic_category().message(error));
}

}  // namespace occlude::render
