// SPDX-License-Identifier: MIT
// Signals that end a command, and what is removed when one does.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace occlude::render {

/// From now on Ctrl-C (and SIGTERM, SIGHUP, the limit of `ulimit -t`) sets a flag, and work stops at the next
/// check_interrupt(). If the process has not ended a second later, it is ended: each Leftover is removed, the line is
/// printed, and the exit code is `interrupted`, or `exit_code` once that is not 0: a failed check stands. A closed pipe and
/// the limit of `ulimit -f` become write errors. REQUIRES: `exit_code` lives until the process ends.
void catch_interrupts(const int& exit_code, int interrupted, std::string line);

/// Throws Interrupted if the flag is set. Long work calls this between steps.
void check_interrupt();

/// All is done and said, and the exit code is what it will be. A signal can still end a process that takes long to end, but
/// changes nothing else.
void settle();

/// While one lives, no signal ends the process: outputs get their names, all of them, or none where a signal has come
/// before.
class Uninterrupted {
 public:
  /// Throws Interrupted if the flag is set.
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
};

/// A file, or an empty folder, that is removed by its destructor, and also when a signal ends the process.
class Leftover {
 public:
  /// What make() makes at the path; none if it returns false.
  [[nodiscard]] static std::optional<Leftover> make(const std::filesystem::path& path, const std::function<bool()>& make);
  ~Leftover();
  Leftover(Leftover&& other) noexcept;
  Leftover& operator=(Leftover&&) = delete;

  /// Gives it its name, under which it stays. If that cannot be done, returns false and sets errno.
  [[nodiscard]] bool rename_to(const std::filesystem::path& path);

 private:
  explicit Leftover(std::string path) : path_(std::move(path)) {}

  std::string path_;  ///< empty once it is renamed or moved away
};

}  // namespace occlude::render
