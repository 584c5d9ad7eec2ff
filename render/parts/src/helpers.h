// SPDX-License-Identifier: MIT
// How the first rank and its helpers talk during a stage.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <thread>

#include "dealer.h"

namespace occlude::render {

/// What all ranks must agree on.
struct StageKey {
  std::uint64_t job = 0;
  unsigned stage = 0;
  friend bool operator==(const StageKey&, const StageKey&) = default;
};

/// On the first rank: deals to the helpers on a thread of its own. The destructor waits until all of them have been told
/// that nothing is left, or the user interrupts.
class Helpers {
 public:
  Helpers(Dealer& dealer, StageKey key);

 private:
  std::jthread thread_;
};

/// On a helper: works on parts until nothing is left. If the first rank ends, so does this process.
void help(StageKey key, const std::function<std::string(const std::string& input)>& work);

}  // namespace occlude::render
