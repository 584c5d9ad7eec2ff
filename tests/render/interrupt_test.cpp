// SPDX-License-Identifier: MIT
#include "occlude/render/interrupt.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "occlude/render/errors.h"
#include "occlude/render/output_file.h"
#include "occlude/render/output_folder.h"

namespace occlude::render {
namespace interrupt_test {

namespace fs = std::filesystem;

constexpr int kInterrupted = 130;

struct Ended {
  int code;
  std::string said;
};

/// A process that catches signals and does the work. If the work returns, the exit code is 77.
Ended run(int exit_code, const std::function<void()>& work) {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDERR_FILENO);
    std::signal(SIGHUP, SIG_DFL);  // the tests may run under nohup
    catch_interrupts(exit_code, kInterrupted, "interrupted\n");
    work();
    _exit(77);
  }
  close(ends[1]);
  std::string said(100, '\0');
  said.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(ends[0], said.data(), said.size()))));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said};
}

/// Work that asks for no interrupt.
void never_end() {
  for (;;) sleep(1);
}

class InterruptTest : public testing::Test {
 protected:
  InterruptTest() { fs::create_directories(folder_); }
  ~InterruptTest() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::temp_directory_path() / ("occlude_interrupt_" + std::to_string(getpid()));
};

TEST_F(InterruptTest, IsThrownWhereWorkAsks) {
  const Ended ended = run(0, [] {
    raise(SIGTERM);
    try {
      check_interrupt();
    } catch (const Interrupted&) {
      _exit(7);
    }
  });
  EXPECT_EQ(ended.code, 7);
  EXPECT_EQ(ended.said, "");
}

TEST_F(InterruptTest, EndsWorkThatDoesNotAsk) {
  std::ofstream(folder_ / "old") << "old";
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    const Ended ended = run(0, [&] {
      const OutputFolder made(folder_ / "made" / "in it");
      const OutputFile unfinished(folder_ / "made" / "in it" / "unfinished"), old(folder_ / "old");
      OutputFile finished(folder_ / ("finished" + std::to_string(signal)));
      finished.commit();
      raise(signal);
      never_end();
    });
    EXPECT_EQ(ended.code, kInterrupted);
    EXPECT_EQ(ended.said, "interrupted\n");
    EXPECT_TRUE(fs::remove(folder_ / ("finished" + std::to_string(signal))));
  }
  EXPECT_TRUE(fs::remove(folder_ / "old"));
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(InterruptTest, LeavesAFolderInWhichSomethingIs) {
  const Ended ended = run(0, [&] {
    const OutputFolder made(folder_ / "made");
    std::ofstream(folder_ / "made" / "of others") << "text";
    raise(SIGINT);
    never_end();
  });
  EXPECT_EQ(ended.code, kInterrupted);
  EXPECT_TRUE(fs::exists(folder_ / "made" / "of others"));
}

TEST_F(InterruptTest, LetsAFailedCheckStand) {
  const Ended ended = run(1, [] {
    raise(SIGINT);
    never_end();
  });
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.said, "interrupted\n");
}

TEST_F(InterruptTest, ChangesNothingWhenAllIsDone) {
  const Ended ended = run(0, [] {
    settle();
    raise(SIGINT);
    never_end();
  });
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.said, "");
}

TEST_F(InterruptTest, WaitsForNobodyWhoShouldRead) {
  const Ended ended = run(0, [] {
    std::array<int, 2> full{};
    static_cast<void>(pipe(full.data()));
    const std::string much(1 << 16, ' ');
    static_cast<void>(!write(full[1], much.data(), much.size()));
    dup2(full[1], STDERR_FILENO);
    raise(SIGINT);
    never_end();
  });
  EXPECT_EQ(ended.code, kInterrupted);
}

TEST_F(InterruptTest, GivesOutputsTheirNamesTogether) {
  const Ended ended = run(0, [&] {
    OutputFile a(folder_ / "a"), b(folder_ / "b");
    {
      const Uninterrupted together;
      raise(SIGINT);
      a.commit();
      const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(2500);  // longer than the patience
      while (std::chrono::steady_clock::now() < until) usleep(1000);
      b.commit();
    }
    never_end();
  });
  EXPECT_EQ(ended.code, kInterrupted);
  EXPECT_TRUE(fs::exists(folder_ / "a"));
  EXPECT_TRUE(fs::exists(folder_ / "b"));
}

TEST_F(InterruptTest, BeginsNoOutputsThatItWouldDivide) {
  const Ended ended = run(0, [&] {
    raise(SIGINT);
    try {
      const Uninterrupted together;
    } catch (const Interrupted&) {
      _exit(7);
    }
  });
  EXPECT_EQ(ended.code, 7);
}

}  // namespace interrupt_test
}  // namespace occlude::render
