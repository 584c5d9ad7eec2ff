// SPDX-License-Identifier: MIT
// Another program, and the lines that it prints.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace occlude::bench {

/// Runs until it ends or this does.
class LineProgram {
 public:
  /// The path of the program, and its arguments. Throws std::system_error.
  explicit LineProgram(const std::vector<std::string>& command);
  ~LineProgram();
  LineProgram(const LineProgram&) = delete;
  LineProgram& operator=(const LineProgram&) = delete;

  /// The next line, without its break; none at the end. Calls `on_signal` when one comes meanwhile; it may throw.
  [[nodiscard]] std::optional<std::string> next(const std::function<void()>& on_signal);

  /// Waits for the end; whether the exit code is 0.
  [[nodiscard]] bool ends_well();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::unique_ptr<std::FILE, Close> lines_;
  pid_t process_ = 0;  ///< 0 once it has ended
};

}  // namespace occlude::bench
