// SPDX-License-Identifier: MIT
// The subcommands of `occlude`. Each adds itself to the command line; its callback does the work and sets the exit code:
// 0 done, 1 a check failed. Bad input is thrown as InputError.
#pragma once

#include <CLI/CLI.hpp>

namespace occlude::cli {

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
