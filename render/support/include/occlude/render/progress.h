// SPDX-License-Identifier: MIT
// One rewritten line on stderr while a command works, and the wish of the user to stop it.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace occlude::render {

/// Shows "LABEL done/total  time left" once a second has passed, only when stderr is a terminal; the destructor clears it.
/// A total of 0 is not known: "LABEL done".
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
  bool terminal_, shown_ = false;
};

/// Progress as work reports it that knows its total when it begins: called with (done, total). Throws Interrupted when the
/// user wishes to stop.
class Watch {
 public:
  explicit Watch(std::string label) : label_(std::move(label)) {}

  void operator()(std::size_t done, std::size_t total);

 private:
  std::string label_;
  std::optional<Progress> progress_;
};

/// From now on Ctrl-C (and SIGTERM, SIGHUP, the end of `ulimit -t`) only sets a flag, and a closed pipe and the end of
/// `ulimit -f` are errors of writing.
void catch_interrupts();

/// Throws Interrupted when the flag is set. Long work calls it between its steps.
void check_interrupt();

}  // namespace occlude::render
