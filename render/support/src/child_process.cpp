// SPDX-License-Identifier: MIT
#include "occlude/render/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <new>
#include <system_error>
#include <thread>

#include "occlude/render/progress.h"
#include "occlude/render/resource_limits.h"

namespace occlude::render {
namespace {

// Exit codes of the child.
constexpr int kDone = 0, kFailed = 1, kOutOfMemory = 2;

[[noreturn]] void throw_errno(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

void restrict_self(const ChildLimits& limits) {
  // The child must not run the handlers of its parent.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGXCPU}) {
    std::signal(signal, SIG_DFL);
  }
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit fails
  limit_resource(RLIMIT_CORE, 0);
  change_limits(limits);
  // The child must not outlive its parent.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
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

/// Returns the exit status of the child. Kills it on Ctrl-C.
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
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) throw ChildFailure("exceeds its time limit", true);
  if (WIFSIGNALED(status)) throw ChildFailure("crashes", false);
  if (WEXITSTATUS(status) == kOutOfMemory) throw ChildFailure("exceeds its memory limit", true);
  if (WEXITSTATUS(status) != kDone) throw ChildFailure("fails", false);
  std::rewind(file.get());
  return file;
}

void change_limits(const ChildLimits& limits) {
  // Sanitizers reserve all their address space at the start, so writable memory is limited as well.
  static const std::uint64_t space_before = address_space_in_use(), data_before = data_in_use();
  limit_resource(RLIMIT_AS, space_before + limits.memory_bytes);
  limit_resource(RLIMIT_DATA, data_before + limits.memory_bytes);
  limit_resource(RLIMIT_FSIZE, limits.memory_bytes);
  limit_resource(RLIMIT_CPU, limits.seconds);
}

}  // namespace occlude::render
