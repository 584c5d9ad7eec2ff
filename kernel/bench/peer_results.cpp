// SPDX-License-Identifier: MIT
#include "peer_results.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "line_program.h"

namespace occlude::bench {

using Json = nlohmann::ordered_json;

std::string peer_line(const PeerSummary& peer) { return Json{{"peer", peer.name}, {"version", peer.version}}.dump(); }

std::string round_line(std::size_t round) { return Json{{"round", round}}.dump(); }

std::string measurement_line(const Measurement& m) {
  return Json{{"subject", m.subject}, {"workload", m.workload}, {"ns", m.ns}, {"wrong", m.wrong}, {"gjk", m.gjk}}.dump();
}

PeerResults run_peers(const std::vector<std::string>& command, const Progress& progress) {
  PeerResults results;
  std::size_t round = 0;
  const auto take = [&](const Json& object) {
    if (object.contains("round")) {
      round = object.at("round");
    } else if (object.contains("peer")) {
      results.peers.push_back({object.at("peer"), object.at("version")});
    } else {
      results.measurements.push_back(
          {object.at("subject"), object.at("workload"), object.at("ns"), object.at("wrong"), object.at("gjk")});
    }
  };
  try {
    LineProgram program(command);
    while (const std::optional<std::string> line = program.next([&] { progress(round); })) {
      take(Json::parse(*line));
      progress(round);
    }
    if (!program.ends_well()) throw PeersFault(command[0] + ": fails");
  } catch (const std::system_error& error) {
    throw PeersFault(error.what());
  } catch (const Json::exception& error) {
    throw PeersFault(command[0] + ": " + error.what());
  }
  return results;
}

}  // namespace occlude::bench
