// SPDX-License-Identifier: MIT
// Runs another program and reads the lines that it prints.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace occlude::bench {

/// The program runs until it ends by itself, or until this object is destroyed.
class LineProgram {
 public:
  /// `command` is the path of the program and its arguments. Throws std::system_error.
  explicit LineProgram(const std::vector<std::string>& command);
  ~LineProgram();
  LineProgram(const LineProgram&) = delete;
  LineProgram& operator=(const LineProgram&) = delete;

  /// The next line without its line break, or nothing at the end. Calls `on_signal` when a signal arrives while it waits.
  /// `on_signal` may throw.
  [[nodiscard]] std::optional<std::string> next(const std::function<void()>& on_signal);

  /// Waits for the program to end. Returns whether its exit code is 0.
  [[nodiscard]] bool ends_well();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::unique_ptr<std::FILE, Close> lines_;
  pid_t process_ = 0;  ///< 0 after the program has ended
};

}  // namespace occlude::bench
