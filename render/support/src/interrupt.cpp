// SPDX-License-Identifier: MIT
#include "occlude/render/interrupt.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

/// How long a command may take to stop by itself: the least that alarm() counts, and half of what users are promised.
constexpr unsigned kSeconds = 1;

std::atomic<bool> interrupted = false;  // read by all threads
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may interrupt a read");

/// How the handler of SIGALRM ends the process.
struct Ending {
  std::atomic_flag lock;
  const int* exit_code = nullptr;  ///< so far
  int interrupted = 0;             ///< the exit code, while that is 0
  std::string line;                ///< said then
  bool is_settled = false;
  unsigned uninterrupted = 0;          ///< how many there are
  std::vector<std::string> leftovers;  ///< as they were made: a folder before what is in it
};

/// Never destroyed: a signal may come while the program ends.
Ending& ending() {
  static auto& ending = *new Ending;
  return ending;
}

/// Access to the ending, for microseconds. The handler only tries to get the lock, as it may interrupt who has it. Then it
/// never gives it back, and everybody else waits here for the end.
class Locked {
 public:
  Locked() {
    while (ending().lock.test_and_set()) std::this_thread::yield();
  }
  ~Locked() { ending().lock.clear(); }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

  Ending* operator->() const { return &ending(); }
};

// What follows, up to the handlers, they may call.

void remove_leftover(const std::string& path) {
  if (unlink(path.c_str()) != 0) rmdir(path.c_str());
}

/// Says nothing where it would have to wait for a reader.
void say_at_once(const std::string& line) {
  pollfd out{STDERR_FILENO, POLLOUT, 0};
  if (poll(&out, 1, 0) == 1) static_cast<void>(!write(STDERR_FILENO, line.data(), line.size()));
}

[[noreturn]] void end_at_once(const Ending& ending) {
  std::for_each(ending.leftovers.rbegin(), ending.leftovers.rend(), remove_leftover);
  if (!ending.is_settled) say_at_once(ending.line);
  _exit(ending.is_settled || *ending.exit_code != 0 ? *ending.exit_code : ending.interrupted);
}

extern "C" void on_interrupt(int) {
  if (!interrupted.exchange(true)) alarm(kSeconds);
}

extern "C" void on_alarm(int) {
  if (!ending().lock.test_and_set()) {
    if (ending().uninterrupted == 0) end_at_once(ending());
    ending().lock.clear();
  }
  alarm(kSeconds);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // without SA_RESTART, so that a waiting read returns
  sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  return action.sa_handler == SIG_IGN;
}

}  // namespace

void catch_interrupts(const int& exit_code, int interrupted, std::string line) {
  ending().exit_code = &exit_code;
  ending().interrupted = interrupted;
  ending().line = std::move(line);
  handle(SIGALRM, on_alarm);
  for (const int signal : {SIGINT, SIGTERM, SIGXCPU}) handle(signal, on_interrupt);
  if (!is_ignored(SIGHUP)) handle(SIGHUP, on_interrupt);  // nohup
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

void check_interrupt() {
  if (interrupted) throw Interrupted();
}

void settle() {
  const Locked ending;
  ending->is_settled = true;
}

Uninterrupted::Uninterrupted() {
  const Locked ending;
  check_interrupt();
  ++ending->uninterrupted;
}

Uninterrupted::~Uninterrupted() {
  const Locked ending;
  --ending->uninterrupted;
}

std::optional<Leftover> Leftover::make(const std::filesystem::path& path, const std::function<bool()>& make) {
  std::string name = path.native();
  const Locked ending;
  ending->leftovers.push_back(name);
  if (make()) return Leftover(std::move(name));
  ending->leftovers.pop_back();
  return std::nullopt;
}

Leftover::Leftover(Leftover&& other) noexcept : path_(std::exchange(other.path_, "")) {}

Leftover::~Leftover() {
  if (path_.empty()) return;
  const Locked ending;
  remove_leftover(path_);
  std::erase(ending->leftovers, path_);
}

bool Leftover::rename_to(const std::filesystem::path& path) {
  const Locked ending;
  if (std::rename(path_.c_str(), path.c_str()) != 0) return false;
  std::erase(ending->leftovers, std::exchange(path_, ""));
  return true;
}

}  // namespace occlude::render
