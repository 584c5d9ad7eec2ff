// SPDX-License-Identifier: MIT
#include "occlude/render/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "occlude/render/errors.h"
#include "occlude/render/progress.h"

namespace occlude::render {
namespace {

[[noreturn]] void fail() {
  const int error = errno;
  check_interrupt();  // ends a write that waits
  throw InputError("standard output: cannot be written: " + std::generic_category().message(error));
}

}  // namespace

void hold_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // The lowest free number is that of the stream. Opened the wrong way round, it refuses what it is asked.
    if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) _exit(2);
  }
}

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail();
}

void finish_printing() {
  if (std::fflush(stdout) != 0) fail();
}

void say(std::string_view text) {
  // A whole message is one write, which other processes on the same terminal cannot come between; stderr has no buffer.
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

}  // namespace occlude::render
