// SPDX-License-Identifier: MIT
// Other projects' tests are measured by a separate program, `occlude_peers`. It is linked with their libraries, so that the
// command is not. It prints a line of JSON for each peer, round and measurement.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "measurement.h"

namespace occlude::bench {

/// The kernel's own test, measured in the same rounds as the peers. The peers are compared to it.
inline constexpr const char* kReference = "overlap_certified_with_peers";

struct PeerSummary {
  std::string name, version;  ///< the version is empty when the peer is not installed

  [[nodiscard]] std::string shown_version() const { return version.empty() ? "not installed" : version; }
};

struct KnownPeer {
  const char *name, *prefix;  ///< its subjects begin with the prefix
};
inline constexpr std::array<KnownPeer, 4> kKnownPeers{
    {{"libccd", "libccd_"}, {"FCL", "fcl_"}, {"Bullet", "bullet_"}, {"OpenSceneGraph", "osg_"}}};

struct PeerResults {
  std::vector<PeerSummary> peers;
  std::vector<Measurement> measurements;
};

/// Thrown when the program does not do what it should.
struct PeersFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[nodiscard]] std::string peer_line(const PeerSummary& peer);
[[nodiscard]] std::string round_line(std::size_t round);
[[nodiscard]] std::string measurement_line(const Measurement& measurement);

/// Runs the command line `command` and returns what it prints. Calls `progress` after each round and when a signal arrives.
/// Throws PeersFault, and whatever `progress` throws; the program is then ended.
[[nodiscard]] PeerResults run_peers(const std::vector<std::string>& command, const Progress& progress);

}  // namespace occlude::bench
