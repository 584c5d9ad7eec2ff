// SPDX-License-Identifier: MIT
// The machine on which a figure was measured.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace occlude::render {

/// The machine and software of a measurement.
struct Machine {
  std::string processor, compiler;
  unsigned threads = 0;
  std::string renderer;  ///< the driver's own name for itself; empty if nothing was drawn
};

[[nodiscard]] Machine this_machine(const std::string& renderer = {});

/// How many processes wanted to run in the last minute, on average, of all users; none where the system does not tell.
[[nodiscard]] std::optional<double> load_of_machine();

/// All but the renderer, in a line.
[[nodiscard]] std::string text_of(const Machine& machine);
[[nodiscard]] nlohmann::ordered_json json_of(const Machine& machine);

}  // namespace occlude::render
