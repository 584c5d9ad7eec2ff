// SPDX-License-Identifier: MIT
#include "line_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

namespace occlude::bench {
namespace {

void check(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// Starts the program with its standard output connected to `output`.
pid_t spawn(std::vector<std::string> command, int output) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  check(posix_spawn_file_actions_init(&actions), "starting a program");
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  pid_t process = 0;
  const int error = posix_spawn(&process, command[0].c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  check(error, command[0].c_str());
  return process;
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

}  // namespace

LineProgram::LineProgram(const std::vector<std::string>& command) {
  std::array<int, 2> ends{};
  check(pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno, "a pipe");
  const auto [from, to] = ends;
  lines_.reset(fdopen(from, "r"));
  try {
    process_ = spawn(command, to);
  } catch (...) {
    close(to);
    throw;
  }
  close(to);
}

LineProgram::~LineProgram() {
  if (process_ == 0) return;
  kill(process_, SIGKILL);
  wait_for(process_);
}

std::optional<std::string> LineProgram::next(const std::function<void()>& on_signal) {
  std::string line;
  for (;;) {
    const int byte = std::getc(lines_.get());
    if (byte == '\n') return line;
    if (byte != EOF) {
      line += static_cast<char>(byte);
    } else if (std::feof(lines_.get()) != 0) {
      return std::nullopt;
    } else {
      on_signal();
      std::clearerr(lines_.get());
    }
  }
}

bool LineProgram::ends_well() {
  const int status = wait_for(std::exchange(process_, 0));
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace occlude::bench
