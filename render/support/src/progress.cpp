// SPDX-License-Identifier: MIT
#include "occlude/render/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <condition_variable>
#include <mutex>

#include "occlude/render/console.h"
#include "occlude/render/stopwatch.h"

namespace occlude::render {
namespace {

bool reaches_terminal = false;

bool is_shown() { return (reaches_terminal || isatty(STDERR_FILENO) != 0) && !is_quiet(); }

/// Until it is told to stop.
void show_seconds(const std::stop_token& stop, const std::string& label) {
  const Stopwatch stopwatch;
  Progress progress(label + ", s:", 0);
  std::mutex mutex;
  std::condition_variable_any told;
  std::unique_lock lock(mutex);
  while (!told.wait_for(lock, stop, std::chrono::milliseconds(100), [&] { return stop.stop_requested(); })) {
    progress.update(static_cast<std::size_t>(stopwatch.seconds()));
  }
}

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), start_(Clock::now()), last_(start_), has_line_(is_shown()) {}

Progress::~Progress() {
  if (shown_) say("");
}

void Progress::update(std::size_t done) {
  const Clock::time_point now = Clock::now();
  // Two updates a second look smooth, and the first second needs no line.
  if (!has_line_ || now - start_ < std::chrono::seconds(1) || now - last_ < std::chrono::milliseconds(500)) return;
  last_ = now;
  shown_ = true;
  if (total_ == 0) {
    say_in_place(fmt::format("{} {}", label_, done));
    return;
  }
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = done == 0 ? 0 : elapsed / static_cast<double>(done) * static_cast<double>(total_ - done);
  say_in_place(fmt::format("{} {}/{}  {:.0f} s left", label_, done, total_, left));
}

ShownStage::ShownStage(std::string label) {
  if (is_shown()) shower_ = std::jthread(show_seconds, std::move(label));
}

void show_progress() { reaches_terminal = true; }

void Watch::operator()(std::size_t done, std::size_t total) {
  check_interrupt();
  if (!progress_) progress_.emplace(label_, total);
  progress_->update(done);
}

}  // namespace occlude::render
