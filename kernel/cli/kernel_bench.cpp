// SPDX-License-Identifier: MIT
#include "kernel_bench.h"

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "occlude/render/console.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"

namespace occlude::cli {
namespace {

/// The path of the program that measures other projects' tests, or empty where it was not built. It is in the same folder as
/// this program.
std::string peers_program() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error).replace_filename("occlude_peers");
  return std::filesystem::exists(program, error) ? program.string() : "";
}

}  // namespace

bench::Result measure_kernel(bench::Options options) {
  options.peers = peers_program();
  std::optional<render::Progress> progress(std::in_place, "round", options.repetitions * (options.peers.empty() ? 1 : 2));
  const bench::Result result = bench::run(options, [&](std::size_t done) {
    render::check_interrupt();
    progress->update(done);
  });
  progress.reset();
  if (!result.peers_fault.empty())
    render::say(render::printable(result.peers_fault) + ": other projects are not measured\n");
  return result;
}

}  // namespace occlude::cli
