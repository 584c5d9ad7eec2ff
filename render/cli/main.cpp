// SPDX-License-Identifier: MIT
// The command `occlude`: assembles the subcommands and turns their exceptions into one line and an exit code.
#include <fmt/format.h>
#include <unistd.h>

#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/oracle/memory.h"
#include "occlude/render/console.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/paint.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"
#include "occlude/render/ranks.h"
#include "occlude/render/resource_limits.h"

namespace {

using occlude::cli::kBadInput;
using occlude::cli::kInterrupted;

/// Of the process. A signal may end it at any time.
int exit_code = occlude::cli::kDone;

/// The command line, which a shell reads as the same words.
std::string as_typed(int argc, char** argv) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,%@";
  std::string line = "occlude";
  for (const std::string_view word : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
    const bool is_plain = !word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos;
    line += is_plain ? fmt::format(" {}", word) : " '";
    if (is_plain) continue;
    for (const char c : word) line += c == '\'' ? "'\\''" : std::string(1, c);
    line += "'";
  }
  return occlude::render::printable(line);
}

void add_bench(occlude::cli::Command app) {
  occlude::cli::Command bench = app.add_command("bench", "Measure the speed of the kernel, the culler and scenes");
  bench.require_command();
  bench.footer("Example: occlude bench kernel");
  occlude::cli::add_bench_kernel(bench, exit_code);
  occlude::cli::add_bench_culler(bench, exit_code);
  occlude::cli::add_bench_scene(bench, exit_code);
  occlude::cli::add_bench_town(bench);
  occlude::cli::add_bench_held(bench);
  occlude::cli::add_bench_rivals(bench);
  occlude::cli::add_bench_all(bench, exit_code);
}

void run(int argc, char** argv) {
  const auto declare = [&](occlude::cli::Command app) {
    occlude::cli::add_generate(app, exit_code);
    occlude::cli::add_preprocess(app, exit_code);
    occlude::cli::add_walk(app, exit_code, as_typed(argc, argv));
    occlude::cli::add_render(app, exit_code);
    occlude::cli::add_inspect(app, exit_code);
    occlude::cli::add_compare(app, exit_code);
    occlude::cli::add_why(app, exit_code);
    occlude::cli::add_classify(app, exit_code);
    occlude::cli::add_validate(app, exit_code);
    occlude::cli::add_audit(app, exit_code);
    occlude::cli::add_bake(app, exit_code);
    occlude::cli::add_prune(app, exit_code);
    occlude::cli::add_fuzz(app, exit_code);
    add_bench(app);
    occlude::cli::add_help(app, exit_code);
  };
  const std::string told = occlude::cli::run_program(
      {.name = "occlude",
       .text = "Occlusion culling with shadow frusta, certified: nothing visible is ever culled.",
       .footer = occlude::cli::formats_help() +
                 "\nExample: occlude walk MODEL\n"
                 "Example: occlude generate city --out city.ply --path city.json && occlude walk city.ply --path city.json",
       .version = OCCLUDE_VERSION},
      argc, argv, declare);
  if (!told.empty()) occlude::render::print(told);
  occlude::render::finish_printing();
}

/// The line that says what went wrong.
std::string error_line(const std::string& what) {
  const occlude::render::Paint paint(STDERR_FILENO);
  return fmt::format("{} {}\n", paint(occlude::render::Colour::red, "occlude:"), what);
}

void run_and_report(int argc, char** argv) {
  const auto failed = [&](int code, const std::string& what) {
    if (code != kInterrupted) occlude::render::tell_first_rank(what);
    if (exit_code == occlude::cli::kDone) exit_code = code;  // a failed check stands
    occlude::render::settle();
    occlude::render::say(error_line(what));
  };
  try {
    occlude::render::require_stack();
    occlude::render::follow_mpirun();
    run(argc, argv);
    occlude::render::settle();
  } catch (const occlude::render::Interrupted& error) {
    failed(kInterrupted, error.what());
  } catch (const std::bad_alloc&) {
    // The command line names the file that is too large.
    const std::string command = fmt::format("{}", fmt::join(argv + 1, argv + argc, " "));
    const std::string limit = occlude::render::in_mebibytes(occlude::render::memory_limit());
    failed(kBadInput, occlude::render::printable(fmt::format("out of memory (limit {}): {}", limit, command)));
  } catch (const std::exception& error) {
    failed(kBadInput, occlude::render::printable(error.what()));
  }
}

/// The end, together with other ranks.
void leave() {
  try {
    occlude::render::leave_ranks();
  } catch (const occlude::render::Interrupted&) {
    exit_code = kInterrupted;
  }
}

}  // namespace

int main(int argc, char** argv) {
  occlude::render::hold_standard_streams();
  const bool is_first = occlude::render::is_first_rank();
  occlude::render::catch_interrupts(exit_code, kInterrupted,
                                    is_first ? error_line(occlude::render::Interrupted().what()) : "");
  occlude::render::limit_memory();
  occlude::oracle::throw_when_memory_is_out();
  if (!is_first) occlude::render::be_silent();
  if (occlude::render::mpirun_has_terminal()) occlude::render::show_progress();
  run_and_report(argc, argv);
  if (exit_code != kInterrupted) leave();
  return exit_code;
}
