// SPDX-License-Identifier: MIT
// Reports that something is wrong: one line, and the end of the process, which is what fuzzers look for.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace occlude::harness {

[[noreturn]] inline void finding(const std::string& what) {
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}

}  // namespace occlude::harness
