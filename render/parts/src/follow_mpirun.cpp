// SPDX-License-Identifier: MIT
// How a process of mpirun learns that it is to end.
#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <thread>

#include "blocked.h"
#include "occlude/render/errors.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/ranks.h"

namespace occlude::render {
namespace {

/// Costs nothing, and is short beside the second in which a command stops.
constexpr std::chrono::milliseconds kBetweenLooks(100);

/// Whether whoever reads standard error, mpirun, has ended. It may have done so before this process knew its parent.
bool is_unheard() {
  pollfd errors{STDERR_FILENO, 0, 0};
  return poll(&errors, 1, 0) > 0 && (errors.revents & POLLERR) != 0;
}

/// What the handler below knows: mpirun, and when it was last looked for, in milliseconds.
std::atomic<pid_t> mpirun_process = 0;
std::atomic<std::int64_t> last_look = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler may interrupt a write");

std::int64_t milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1000 + time.tv_nsec / 1'000'000;
}

std::atomic<bool> is_blocked = false;

void interrupt() { kill(getpid(), SIGTERM); }

bool is_interrupted() {
  try {
    check_interrupt();
  } catch (const Interrupted&) {
    return true;
  }
  return false;
}

[[noreturn]] void follow() {
  for (;; std::this_thread::sleep_for(kBetweenLooks)) {
    last_look = milliseconds();
    if (!is_interrupted() && (getppid() != mpirun_process || is_unheard())) interrupt();
    if (is_interrupted() && is_blocked) kill(getpid(), SIGALRM);  // the second is over
  }
}

/// mpirun wakes its processes a second before it tells them to end, in case that they were stopped. It may also go on with
/// processes that it has stopped; then nobody has looked for some time.
extern "C" void on_wake(int, siginfo_t* from, void*) {
  constexpr std::int64_t kStopped = 5 * kBetweenLooks.count();
  if (from->si_pid == mpirun_process && milliseconds() - last_look < kStopped) interrupt();
}

/// Starts a thread that no signal interrupts, so that they interrupt what the others wait for.
template <class Work>
void start_undisturbed(Work&& work) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread(work).detach();
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace

Blocked::Blocked() { is_blocked = true; }

Blocked::~Blocked() { is_blocked = false; }

// The system can tell a process that its parent has ended (PR_SET_PDEATHSIG), but then means the thread that started it.
void follow_mpirun() {
  if (!is_of_mpirun()) return;
  mpirun_process = getppid();
  struct sigaction action {};
  action.sa_sigaction = on_wake;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  sigaction(SIGCONT, &action, nullptr);
  start_undisturbed(follow);
}

}  // namespace occlude::render
