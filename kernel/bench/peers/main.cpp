// SPDX-License-Identifier: MIT
// occlude_peers BOXES ROUNDS SEED: measures other projects' libraries for `occlude bench kernel`, which runs it.
#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "kernel_subjects.h"
#include "peer_results.h"
#include "peers.h"

namespace {

using namespace occlude::bench;

void print(const std::string& line) {
  std::puts(line.c_str());
  std::fflush(stdout);  // a round may take a while
}

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_DFL);  // when nobody reads any more, the program ends
  const auto argument = [&](int i) { return i < argc ? number(argv[i]) : std::nullopt; };
  const auto boxes = argument(1), rounds = argument(2), seed = argument(3);
  if (argc != 4 || !boxes || !rounds || !seed) {
    std::fputs("Usage: occlude_peers BOXES ROUNDS SEED, as occlude bench kernel runs it\n", stderr);
    return 2;
  }
  std::vector<Peer> installed = peers();
  if (installed.empty()) return 0;
  std::vector<Subject> subjects{reference_subject()};
  for (Peer& peer : installed) {
    print(peer_line({peer.name, peer.version}));
    std::ranges::move(peer.subjects, std::back_inserter(subjects));
  }
  const std::vector<Workload> workloads = make_workloads(*boxes, *seed);
  const auto on_round = [](std::size_t done) { print(round_line(done)); };
  for (const Measurement& measurement : measure(workloads, subjects, *rounds, on_round))
    print(measurement_line(measurement));
  return 0;
}
