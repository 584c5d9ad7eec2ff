// SPDX-License-Identifier: MIT
#include "occlude/render/progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "occlude/render/console.h"
#include "occlude/render/processor_time.h"

namespace occlude::render {
namespace progress_test {

TEST(Took, WaitingTakesNoTimeOfTheProcessor) {
  const Took waiting = took([] { std::this_thread::sleep_for(std::chrono::milliseconds(50)); });
  EXPECT_GE(waiting.ms, 50);
  EXPECT_LT(waiting.processor_ms, waiting.ms / 2);
}

/// Text that appears on stderr while `work` is done.
std::string said_during(const std::function<void()>& work) {
  testing::internal::CaptureStderr();
  work();
  return testing::internal::GetCapturedStderr();
}

TEST(ShownStage, IsShownAfterASecondAndCleared) {
  show_progress();
  const auto wait = [](int ms) {
    const ShownStage stage("waiting");
    std::this_thread::sleep_for(std::chrono::milliseconds(ms));
  };
  EXPECT_EQ(said_during([&] { wait(10); }), "");
  const std::string said = said_during([&] { wait(1700); });
  EXPECT_TRUE(said.starts_with("\r\033[Kwaiting, s: ")) << said;
  EXPECT_TRUE(said.ends_with("\r\033[K")) << said;
}

TEST(ShownStage, AMessageTakesItsPlace) {
  EXPECT_EQ(said_during([] {
              say_in_place("some work 3");
              say("a warning\n");
              say_in_place("some work 4");
              say("");
              say("an end\n");
            }),
            "\r\033[Ksome work 3\r\033[Ka warning\n\r\033[Ksome work 4\r\033[Kan end\n");
}

}  // namespace progress_test
}  // namespace occlude::render
