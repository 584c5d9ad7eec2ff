// SPDX-License-Identifier: MIT
#include "child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <new>
#include <system_error>
#include <thread>

#include "occlude/render/progress.h"

namespace occlude::render {
namespace {

// Exit codes of the child.
constexpr int kDone = 0, kFailed = 1, kOutOfMemory = 2;

[[noreturn]] void throw_errno(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// Address space in use, bytes.
std::uint64_t memory_in_use() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void set_limit(int resource, rlim_t value) {
  const rlimit limit{value, value};
  setrlimit(resource, &limit);
}

void restrict_self(const ChildLimits& limits) {
  // What this process does on a crash or on Ctrl-C is not for its copy to do.
  for (const int signal : {SIGINT, SIGTERM, SIGALRM, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL}) {
    std::signal(signal, SIG_DFL);
  }
  set_limit(RLIMIT_AS, memory_in_use() + limits.memory_bytes);
  set_limit(RLIMIT_CORE, 0);
  // What is read into memory is what is written: a write beyond this fails.
  std::signal(SIGXFSZ, SIG_IGN);
  set_limit(RLIMIT_FSIZE, limits.memory_bytes);
  // It does not outlive who asked for it.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  alarm(limits.seconds);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

int work_in_child(const ChildLimits& limits, const std::function<void(std::FILE*)>& work, std::FILE* out) {
  try {
    restrict_self(limits);
    work(out);
    return std::fflush(out) == 0 && std::ferror(out) == 0 ? kDone : kFailed;
  } catch (const std::bad_alloc&) {
    return kOutOfMemory;
  } catch (...) {
    return kFailed;
  }
}

/// How the child ended. Ends it when the user interrupts.
int wait_for(pid_t child) {
  int status = 0;
  pid_t ended = 0;
  while ((ended = waitpid(child, &status, WNOHANG)) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    try {
      check_interrupt();
    } catch (...) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      throw;
    }
  }
  if (ended < 0) throw_errno("waiting for a process");
  return status;
}

}  // namespace

File run_in_child(const ChildLimits& limits, const std::function<void(std::FILE*)>& work) {
  File file(std::tmpfile(), std::fclose);
  if (!file) throw_errno("a temporary file");
  const pid_t child = fork();
  if (child < 0) throw_errno("starting a process");
  if (child == 0) _exit(work_in_child(limits, work, file.get()));
  const int status = wait_for(child);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) {
    throw ChildFailure(fmt::format("takes longer than {} seconds", limits.seconds));
  }
  if (WIFSIGNALED(status)) throw ChildFailure("crashes");
  if (WEXITSTATUS(status) == kOutOfMemory) throw ChildFailure("needs more memory than it may have");
  if (WEXITSTATUS(status) != kDone) throw ChildFailure("fails");
  std::rewind(file.get());
  return file;
}

}  // namespace occlude::render
