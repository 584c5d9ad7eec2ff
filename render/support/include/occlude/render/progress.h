// SPDX-License-Identifier: MIT
// A progress line on stderr.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "occlude/render/interrupt.h"

namespace occlude::render {

/// Shows "LABEL done/total  time left" after the first second, if stderr is a terminal, or show_progress() was called, and
/// --quiet is not given. The destructor clears the line. A total of 0 means unknown: "LABEL done".
class Progress {
 public:
  Progress(std::string label, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  std::size_t total_;
  Clock::time_point start_, last_;
  bool has_line_, shown_ = false;
};

/// Shows "LABEL, s: SECONDS" in the same way while it lives, of work that does not tell how far it is. One at a time, and
/// none beside a Progress.
class ShownStage {
 public:
  explicit ShownStage(std::string label);

 private:
  std::jthread shower_;
};

/// From now on progress is shown although stderr is no terminal, because what reads it writes to one.
void show_progress();

/// A progress callback, called with (done, total), for work that knows the total only once it begins. Throws Interrupted
/// on Ctrl-C.
class Watch {
 public:
  explicit Watch(std::string label) : label_(std::move(label)) {}

  void operator()(std::size_t done, std::size_t total);

 private:
  std::string label_;
  std::optional<Progress> progress_;
};

}  // namespace occlude::render
