// SPDX-License-Identifier: MIT
#include "occlude/render/child_process.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <new>
#include <string>
#include <vector>

namespace occlude::render {
namespace child_process_test {

constexpr ChildLimits kAmple{1ULL << 30U, 60};

std::string failure(const ChildLimits& limits, const std::function<void(std::FILE*)>& work) {
  try {
    static_cast<void>(run_in_child(limits, work));
  } catch (const ChildFailure& failure) {
    return failure.what();
  }
  return "no failure";
}

TEST(ChildProcess, HandsOverWhatItWrites) {
  int changed = 0;
  const File file = run_in_child(kAmple, [&](std::FILE* out) {
    changed = 1;
    std::fputs("some text", out);
  });
  std::string text(100, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file.get()));
  EXPECT_EQ(text, "some text");
  EXPECT_EQ(changed, 0);
}

TEST(ChildProcess, CrashesAlone) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) {
    EXPECT_EQ(failure(kAmple, [&](std::FILE*) { raise(signal); }), "crashes");
  }
}

TEST(ChildProcess, FailsAlone) {
  EXPECT_EQ(failure(kAmple, [](std::FILE*) { throw 1; }), "fails");
  EXPECT_EQ(failure(kAmple, [](std::FILE*) { _exit(3); }), "fails");
}

TEST(ChildProcess, IsEndedWhenItDoesNotEnd) {
  const auto never_end = [](std::FILE*) {
    for (volatile unsigned i = 0;;) i = i + 1;
  };
  EXPECT_EQ(failure({kAmple.memory_bytes, 1}, never_end), "exceeds its time limit");
}

TEST(ChildProcess, GetsNoMoreMemoryThanItMayHave) {
  const auto allocate = [](std::size_t bytes) { return [bytes](std::FILE*) { ::operator delete(::operator new(bytes)); }; };
  EXPECT_EQ(failure(kAmple, allocate(kAmple.memory_bytes / 2)), "no failure");
  // "exceeds its memory limit", or however a sanitizer ends the process.
  EXPECT_NE(failure(kAmple, allocate(2 * kAmple.memory_bytes)), "no failure");
}

TEST(ChildProcess, GetsNoMoreInSmallPieces) {
  const auto allocate = [](std::size_t bytes) {
    return [bytes](std::FILE*) {
      std::vector<std::vector<char>> pieces;
      for (std::size_t sum = 0; sum < bytes; sum += pieces.back().size()) pieces.emplace_back(1U << 10U);
    };
  };
  const ChildLimits small{64U << 20U, 60};
  EXPECT_EQ(failure(small, allocate(small.memory_bytes / 4)), "no failure");
  // What tests before this one gave back is there already.
  EXPECT_NE(failure(small, allocate(2 * small.memory_bytes + mallinfo2().fordblks)), "no failure");
}

TEST(ChildProcess, MayBeGivenMoreOnTheWay) {
  const auto ask_for = [](std::size_t bytes) {
    return [bytes](std::FILE*) {
      change_limits(kAmple);
      ::operator delete(::operator new(bytes));
    };
  };
  const ChildLimits small{16U << 20U, 60};
  EXPECT_EQ(failure(small, ask_for(kAmple.memory_bytes / 2)), "no failure");
  EXPECT_NE(failure(small, ask_for(2 * kAmple.memory_bytes)), "no failure");
}

TEST(ChildProcess, WritesNoMoreThanItMayHave) {
  const std::string mebibyte(1U << 20U, 'x');
  const auto write = [&](std::size_t times) {
    return [&, times](std::FILE* out) {
      for (std::size_t i = 0; i < times; ++i) std::fwrite(mebibyte.data(), 1, mebibyte.size(), out);
    };
  };
  const ChildLimits small{16U << 20U, 60};
  EXPECT_EQ(failure(small, write(15)), "no failure");
  EXPECT_EQ(failure(small, write(17)), "fails");
}

}  // namespace child_process_test
}  // namespace occlude::render
