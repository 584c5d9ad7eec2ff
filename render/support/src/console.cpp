// SPDX-License-Identifier: MIT
#include "occlude/render/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "occlude/render/errors.h"
#include "occlude/render/progress.h"

namespace occlude::render {
namespace {

bool quiet = false, silent = false;

constexpr const char* kClear = "\r\033[K";
std::atomic<bool> is_line_open = false;

void write_error(const std::string& text) {
  if (silent) return;
  // stderr is unbuffered, so a message is one write and does not mix with those of other processes.
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

[[noreturn]] void fail() {
  const int error = errno;
  check_interrupt();  // Ctrl-C ends a write that waits
  throw InputError("standard output: cannot be written: " + std::generic_category().message(error));
}

}  // namespace

void hold_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // open() takes the lowest free number, which is the stream's. Opened in the wrong direction, every use of it fails.
    if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) _exit(2);
  }
}

void be_quiet() { quiet = true; }

bool is_quiet() { return quiet; }

void be_silent() { quiet = silent = true; }

void tell(std::string_view text) {
  if (!quiet) print(text);
}

void print(std::string_view text) {
  if (silent) return;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail();
}

void finish_printing() {
  if (std::fflush(stdout) != 0) fail();
}

void say(std::string_view text) { write_error((is_line_open.exchange(false) ? kClear : "") + std::string(text)); }

void say_in_place(std::string_view line) {
  is_line_open = true;
  write_error(kClear + std::string(line));
}

}  // namespace occlude::render
