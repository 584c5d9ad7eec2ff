// SPDX-License-Identifier: MIT
// The subcommands of `occlude`. Each adds itself to the command line; its callback does the work. It sets the exit code to 1
// as soon as a check has failed: that stands, whatever goes wrong afterwards. Bad input, and output that cannot be written,
// is thrown as InputError.
#pragma once

#include <CLI/CLI.hpp>

namespace occlude::cli {

inline constexpr int kDone = 0, kCheckFailed = 1, kBadInput = 2, kInterrupted = 130;  // 128 + SIGINT, as shells expect

void add_generate(CLI::App& app, int& exit_code);
void add_preprocess(CLI::App& app, int& exit_code);
void add_walk(CLI::App& app, int& exit_code);
void add_classify(CLI::App& app, int& exit_code);
void add_why(CLI::App& app, int& exit_code);
void add_validate(CLI::App& app, int& exit_code);
void add_fuzz(CLI::App& app, int& exit_code);

/// Of the command `bench`.
void add_bench_kernel(CLI::App& bench, int& exit_code);
void add_bench_culler(CLI::App& bench, int& exit_code);

}  // namespace occlude::cli
