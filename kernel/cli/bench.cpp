// SPDX-License-Identifier: MIT
// occlude bench kernel
#include <memory>
#include <string>

#include "command_arguments.h"
#include "commands.h"
#include "kernel_bench.h"
#include "occlude/render/console.h"

namespace occlude::cli {
namespace {

struct BenchArguments {
  bench::Options options;
  std::string seed = std::to_string(bench::kDefaultSeed);
  bool json = false;
};

void bench_kernel(BenchArguments& arguments) {
  arguments.options.seed = whole_number("--seed", arguments.seed);
  const bench::Result result = measure_kernel(arguments.options);
  arguments.json ? render::print(report_json(result)) : render::tell(report_text(result));
}

}  // namespace

void add_bench_kernel(Command bench, int&) {
  Command kernel = bench.add_command("kernel", "The kernel's tests, certified and plain, beside those of other projects");
  kernel.footer("Example: occlude bench kernel --boxes 32768 --repetitions 15 --json");
  const auto arguments = std::make_shared<BenchArguments>();
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
