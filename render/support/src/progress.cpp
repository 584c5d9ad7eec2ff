// SPDX-License-Identifier: MIT
#include "occlude/render/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include "occlude/render/console.h"

namespace occlude::render {
namespace {

bool reaches_terminal = false;

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(total),
      start_(Clock::now()),
      last_(start_),
      has_line_((reaches_terminal || isatty(STDERR_FILENO) != 0) && !is_quiet()) {}

Progress::~Progress() {
  if (shown_) say("\r\033[K");
}

void Progress::update(std::size_t done) {
  const Clock::time_point now = Clock::now();
  // Two updates a second look smooth, and the first second needs no line.
  if (!has_line_ || now - start_ < std::chrono::seconds(1) || now - last_ < std::chrono::milliseconds(500)) return;
  last_ = now;
  shown_ = true;
  if (total_ == 0) {
    say(fmt::format("\r\033[K{} {}", label_, done));
    return;
  }
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = done == 0 ? 0 : elapsed / static_cast<double>(done) * static_cast<double>(total_ - done);
  say(fmt::format("\r\033[K{} {}/{}  {:.0f} s left", label_, done, total_, left));
}

void show_progress() { reaches_terminal = true; }

void Watch::operator()(std::size_t done, std::size_t total) {
  check_interrupt();
  if (!progress_) progress_.emplace(label_, total);
  progress_->update(done);
}

}  // namespace occlude::render
