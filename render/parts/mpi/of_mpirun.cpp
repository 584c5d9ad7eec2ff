// SPDX-License-Identifier: MIT
// Ranks of Open MPI. MPI is initialised when a rank needs another one for the first time, so without mpirun it costs
// nothing.
//
// A helper sends the first rank its last result, or none, and gets a part, or the end of the stage. After the last stage it
// waits for leave. Nobody waits inside MPI, which would take a processor.
#include <fmt/format.h>
#include <mpi.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "blocked.h"
#include "helpers.h"
#include "occlude/render/errors.h"
#include "occlude/render/packing.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"
#include "occlude/render/ranks.h"

namespace occlude::render {
namespace {

/// Tags of messages. A helper that asks for a part of stage s sends kAsk + s, because it may be a stage ahead.
enum Tag { kPart, kEnd, kLeave, kFault, kAsk };

constexpr int kFirst = 0;

struct Message {
  int rank = 0, tag = 0;
  std::string bytes;
};

bool is_initialised() {
  int flag = 0;
  MPI_Initialized(&flag);
  return flag != 0;
}

void initialise() {
  if (is_initialised()) return;
  int provided = 0;
  const Blocked blocked;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  if (provided < MPI_THREAD_SERIALIZED) throw InputError("mpirun: this MPI does not allow threads");
}

void send(int rank, int tag, const std::string& bytes = {}) {
  if (bytes.size() > std::numeric_limits<int>::max()) throw InputError("mpirun: a part is larger than MPI can send");
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, tag, MPI_COMM_WORLD);
}

/// A message that has arrived.
std::optional<Message> receive(int rank, int tag) {
  int has_come = 0;
  MPI_Status status;
  MPI_Iprobe(rank, tag, MPI_COMM_WORLD, &has_come, &status);
  if (has_come == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{status.MPI_SOURCE, status.MPI_TAG, std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.rank, message.tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

/// Short beside a part. Throws Interrupted.
void pause() {
  check_interrupt();
  std::this_thread::sleep_for(std::chrono::microseconds(200));
}

[[noreturn]] void leave_helper() {
  MPI_Finalize();
  std::_Exit(EXIT_SUCCESS);  // the first rank has the exit code
}

Message wait_for_first_rank() {
  for (;;) {
    std::optional<Message> message = receive(kFirst, MPI_ANY_TAG);
    if (!message) {
      pause();
    } else if (message->tag == kLeave) {
      leave_helper();
    } else {
      return std::move(*message);
    }
  }
}

/// The first rank's side of a stage.
class Counter {
 public:
  Counter(Dealer& dealer, StageKey key) : dealer_(dealer), key_(key) {
    for (int helper = 1; helper < static_cast<int>(ranks()); ++helper) served_.insert(helper);
  }

  void serve() {
    while (!served_.empty()) {
      if (const auto asked = receive(MPI_ANY_SOURCE, kAsk + static_cast<int>(key_.stage))) {
        if (!answer(*asked)) served_.erase(asked->rank);
      } else if (const auto fault = receive(MPI_ANY_SOURCE, kFault)) {
        fail(*fault, fault->bytes);
        served_.erase(fault->rank);  // unless it had been told the end: it may fail with what comes next
      } else {
        pause();
      }
    }
  }

 private:
  /// Returns whether there was a part to give.
  bool answer(const Message& asked) {
    try {
      Unpacker message(asked.bytes);
      if (message.get<StageKey>() != key_) {
        fail(asked, "it has other input, or another program, than the first rank");
      } else if (!message.is_empty()) {
        const auto number = message.get<std::uint64_t>();
        dealer_.accept(number, message.text(), static_cast<std::size_t>(asked.rank));
        message.finish();
      }
    } catch (const PartError& error) {
      fail(asked, error.what());
    }
    const std::optional<Dealer::Part> part = dealer_.next();
    if (part) {
      send(asked.rank, kPart, Packer().put(part->number).put(part->input).bytes());
    } else {
      send(asked.rank, kEnd);
    }
    return part.has_value();
  }

  void fail(const Message& from, const std::string& fault) {
    dealer_.fail(std::make_exception_ptr(InputError(fmt::format("rank {}: {}", from.rank, fault))));
  }

  Dealer& dealer_;
  StageKey key_;
  std::set<int> served_;  ///< the helpers that will ask again. Who is left out would wait for ever
};

}  // namespace

Helpers::Helpers(Dealer& dealer, StageKey key) {
  if (ranks() == 1) return;
  initialise();
  thread_ = std::jthread([&dealer, key] {
    try {
      Counter(dealer, key).serve();
    } catch (...) {
      dealer.fail(std::current_exception());
    }
  });
}

void help(StageKey key, const std::function<std::string(const std::string&)>& work) {
  initialise();
  std::string last = Packer().put(key).bytes();
  for (;;) {
    send(kFirst, kAsk + static_cast<int>(key.stage), last);
    const Message answer = wait_for_first_rank();
    if (answer.tag == kEnd) return;
    Unpacker part(answer.bytes);
    const auto number = part.get<std::uint64_t>();
    last = Packer().put(key).put(number).put(work(part.text())).bytes();
  }
}

void tell_first_rank(const std::string& fault) {
  if (is_first_rank()) return;
  initialise();
  send(kFirst, kFault, printable(fault));
}

void leave_ranks() {
  if (ranks() == 1 || !is_initialised()) return;
  if (!is_first_rank()) wait_for_first_rank();
  for (int helper = 1; helper < static_cast<int>(ranks()); ++helper) send(helper, kLeave);
  // Not Blocked: ended at once, mpirun would take what is done for a failure.
  MPI_Finalize();
}

}  // namespace occlude::render
