// SPDX-License-Identifier: MIT
// Other projects' tests are measured by a program of its own, `occlude_peers`: it is linked with their libraries, and the
// command with none of them. What it prints is a line of JSON for each peer, round and measurement.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "measurement.h"

namespace occlude::bench {

/// The kernel's own test as measured in the same rounds as the peers, to which they are compared.
inline constexpr const char* kReference = "overlap_certified_with_peers";

struct PeerSummary {
  std::string name, version;  ///< no version: not installed
};

struct PeerResults {
  std::vector<PeerSummary> peers;
  std::vector<Measurement> measurements;
};

/// The program does not do what it should.
struct PeersFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[nodiscard]] std::string peer_line(const PeerSummary& peer);
[[nodiscard]] std::string round_line(std::size_t round);
[[nodiscard]] std::string measurement_line(const Measurement& measurement);

/// What the command line `command` prints. Throws PeersFault, and what `progress` throws, which is asked after each round
/// and when a signal comes; the program is then ended.
[[nodiscard]] PeerResults run_peers(const std::vector<std::string>& command, const Progress& progress);

}  // namespace occlude::bench
