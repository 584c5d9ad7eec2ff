// SPDX-License-Identifier: MIT
// The command `occlude`: assembles the subcommands and turns what they throw into one line and an exit code.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "commands.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/memory_limit.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"

namespace {

constexpr int kBadInput = 2;
constexpr int kInterrupted = 130;  // 128 + SIGINT, as shells expect

void add_bench(CLI::App& app, int& exit_code) {
  CLI::App* bench = app.add_subcommand("bench", "Measure how fast the answers come, and how much is culled");
  bench->require_subcommand(1);
  bench->footer("Example: occlude bench kernel");
  occlude::cli::add_bench_kernel(*bench, exit_code);
  occlude::cli::add_bench_culler(*bench, exit_code);
}

int run(int argc, char** argv) {
  int exit_code = 0;
  CLI::App app("Occlusion culling with shadow frusta, certified: nothing visible is ever culled.", "occlude");
  app.require_subcommand(0, 1);  // that there is one is checked below, after an unknown word has been named
  app.footer(
      "Example: occlude generate city --out city.ply --path city.json && occlude walk city.ply --path city.json --out "
      "report");
  app.set_version_flag("--version", OCCLUDE_VERSION);
  occlude::cli::add_generate(app, exit_code);
  occlude::cli::add_preprocess(app, exit_code);
  occlude::cli::add_walk(app, exit_code);
  occlude::cli::add_why(app, exit_code);
  occlude::cli::add_classify(app, exit_code);
  occlude::cli::add_validate(app, exit_code);
  occlude::cli::add_fuzz(app, exit_code);
  add_bench(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = error.get_exit_code();
    if (code == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);
    fmt::print(stderr, "occlude: {} (see occlude --help)\n", occlude::render::printable(error.what()));
    return kBadInput;
  }
  if (app.get_subcommands().empty()) {
    fmt::print(stderr, "occlude: which command? (see occlude --help)\n");
    return kBadInput;
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw occlude::render::InputError("standard output: cannot be written");
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  occlude::render::catch_interrupts();
  occlude::render::limit_memory();
  try {
    return run(argc, argv);
  } catch (const occlude::render::Interrupted&) {
    fmt::print(stderr, "occlude: interrupted, no file written\n");
    return kInterrupted;
  } catch (const std::bad_alloc&) {
    // What was asked for names the file that is too much.
    fmt::print(stderr, "occlude: out of memory ({} at most): {}\n",
               occlude::render::in_mebibytes(occlude::render::most_memory()),
               occlude::render::printable(fmt::format("{}", fmt::join(argv + 1, argv + argc, " "))));
  } catch (const std::exception& error) {
    fmt::print(stderr, "occlude: {}\n", occlude::render::printable(error.what()));
  }
  return kBadInput;
}
