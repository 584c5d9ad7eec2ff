// SPDX-License-Identifier: MIT
#include "occlude/render/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

#include "occlude/render/console.h"
#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

bool reaches_terminal = false;

std::atomic<bool> interrupted = false;  // read by all threads
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may interrupt a read");

extern "C" void on_interrupt(int) { interrupted = true; }

bool is_ignored(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

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

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;  // without SA_RESTART, so that a waiting read returns
  for (const int signal : {SIGINT, SIGTERM, SIGXCPU}) sigaction(signal, &action, nullptr);
  if (!is_ignored(SIGHUP)) sigaction(SIGHUP, &action, nullptr);  // nohup
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

void check_interrupt() {
  if (interrupted) throw Interrupted();
}

}  // namespace occlude::render
