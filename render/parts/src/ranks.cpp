// SPDX-License-Identifier: MIT
#include "occlude/render/ranks.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>

namespace occlude::render {
namespace {

/// What mpirun of Open MPI tells its processes, before MPI is initialised.
std::size_t number_of(const char* variable, std::size_t otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

bool is_of_mpirun() { return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr; }

/// Costs nothing, and is short beside the second in which a command stops.
constexpr std::chrono::milliseconds kBetweenLooks(100);

/// Whether whoever reads standard error, mpirun, has ended. It may have done so before this process knew its parent.
bool is_unheard() {
  pollfd errors{STDERR_FILENO, 0, 0};
  return poll(&errors, 1, 0) > 0 && (errors.revents & POLLERR) != 0;
}

void interrupt_after(pid_t parent) {
  while (getppid() == parent && !is_unheard()) std::this_thread::sleep_for(kBetweenLooks);
  kill(getpid(), SIGTERM);
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

std::size_t ranks() {
  static const std::size_t count = std::max<std::size_t>(number_of("OMPI_COMM_WORLD_SIZE", 1), 1);
  return count;
}

bool is_first_rank() {
  static const bool is_first = number_of("OMPI_COMM_WORLD_RANK", 0) == 0;
  return is_first;
}

bool mpirun_has_terminal() {
  if (!is_of_mpirun()) return false;
  std::error_code error;  // mpirun may be on another machine, and the parent is another program there
  const std::string target = std::filesystem::read_symlink(fmt::format("/proc/{}/fd/2", getppid()), error).string();
  return target.starts_with("/dev/pts/") || target.starts_with("/dev/tty");
}

// The system can tell a process that its parent has ended (PR_SET_PDEATHSIG), but then means the thread that started it.
void follow_mpirun() {
  if (!is_of_mpirun()) return;
  start_undisturbed([parent = getppid()] { interrupt_after(parent); });
}

}  // namespace occlude::render
