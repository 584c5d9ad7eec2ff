// SPDX-License-Identifier: MIT
// occlude bench kernel
#include "bench.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

#include "command_arguments.h"
#include "commands.h"
#include "occlude/render/console.h"
#include "occlude/render/machine.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"
#include "report.h"

namespace occlude::cli {
namespace {

struct Arguments {
  bench::Options options;
  std::string seed = std::to_string(bench::kDefaultSeed);
  bool json = false;
};

/// The path of the program that measures other projects' tests, or empty where it was not built. It is in the same folder as
/// this program.
std::string peers_program() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error).replace_filename("occlude_peers");
  return std::filesystem::exists(program, error) ? program.string() : "";
}

void bench_kernel(Arguments& arguments) {
  arguments.options.seed = whole_number("--seed", arguments.seed);
  arguments.options.peers = peers_program();
  const std::size_t rounds = arguments.options.repetitions * (arguments.options.peers.empty() ? 1 : 2);
  std::optional<render::Progress> progress(std::in_place, "round", rounds);
  const bench::Result result = bench::run(arguments.options, [&](std::size_t done) {
    render::check_interrupt();
    progress->update(done);
  });
  progress.reset();
  if (!result.peers_fault.empty())
    render::say(render::printable(result.peers_fault) + ": other projects are not measured\n");
  const bench::Machine machine{.processor = render::processor_name(),
                               .compiler = render::compiler_name(),
                               .flags = OCCLUDE_BENCH_FLAGS,
                               .threads = std::thread::hardware_concurrency()};
  arguments.json ? render::print(report_json(result, machine)) : render::tell(report_text(result, machine));
}

}  // namespace

void add_bench_kernel(Command bench, int&) {
  Command kernel = bench.add_command("kernel", "The kernel's tests, certified and plain, beside those of other projects");
  kernel.footer("Example: occlude bench kernel --boxes 32768 --repetitions 15 --json");
  const auto arguments = std::make_shared<Arguments>();
  kernel.add("--boxes", arguments->options.boxes, "boxes in each workload")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{262'144});
  kernel.add("--repetitions", arguments->options.repetitions, "rounds in which everything is measured once")
      .show_default()
      .in_range(std::size_t{1}, std::size_t{1000});
  kernel.add("--seed", arguments->seed, "whole number; same seed, same boxes, on any machine").show_default();
  kernel.add_flag("--json", arguments->json, "print everything measured as JSON");
  kernel.run([arguments] { bench_kernel(*arguments); });
}

}  // namespace occlude::cli
