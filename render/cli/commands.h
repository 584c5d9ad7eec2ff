// SPDX-License-Identifier: MIT
// The subcommands of `occlude`. Each adds itself to the command line, and its callback does the work. It sets the exit code
// to 1 as soon as a check fails; later errors do not change that. For bad input, and output that cannot be written, it
// throws InputError.
#pragma once

#include <string>

#include "command_line.h"

namespace occlude::cli {

inline constexpr int kDone = 0, kCheckFailed = 1, kBadInput = 2, kInterrupted = 130;  // 128 + SIGINT, as shells expect

void add_help(Command app, int& exit_code);
void add_generate(Command app, int& exit_code);
void add_preprocess(Command app, int& exit_code);
/// `command_line` is written into the report.
void add_walk(Command app, int& exit_code, const std::string& command_line);
void add_render(Command app, int& exit_code);
void add_compare(Command app, int& exit_code);
void add_inspect(Command app, int& exit_code);
void add_classify(Command app, int& exit_code);
void add_why(Command app, int& exit_code);
void add_validate(Command app, int& exit_code);
void add_audit(Command app, int& exit_code);
void add_bake(Command app, int& exit_code);
void add_prune(Command app, int& exit_code);
void add_fuzz(Command app, int& exit_code);

/// Subcommands of `bench`.
void add_bench_kernel(Command bench, int& exit_code);
void add_bench_culler(Command bench, int& exit_code);
void add_bench_scene(Command bench, int& exit_code);
void add_bench_town(Command bench);
void add_bench_held(Command bench);
void add_bench_rivals(Command bench);
void add_bench_all(Command bench, int& exit_code);

}  // namespace occlude::cli
