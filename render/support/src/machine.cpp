// SPDX-License-Identifier: MIT
#include "occlude/render/machine.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

namespace occlude::render {
namespace {

/// The processor's own name for itself.
std::string processor_name() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  std::string line;
  while (std::getline(cpuinfo, line)) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

/// The compiler of this program.
std::string compiler_name() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

Machine this_machine(const std::string& renderer) {
  return {processor_name(), compiler_name(), std::thread::hardware_concurrency(), renderer};
}

std::optional<double> load_of_machine() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? std::optional(load) : std::nullopt;
}

std::string text_of(const Machine& machine) {
  return fmt::format("{}, {} threads, {}", machine.processor, machine.threads, machine.compiler);
}

nlohmann::ordered_json json_of(const Machine& machine) {
  using Json = nlohmann::ordered_json;
  return {{"processor", machine.processor},
          {"threads", machine.threads},
          {"renderer", machine.renderer.empty() ? Json(nullptr) : Json(machine.renderer)},
          {"compiler", machine.compiler}};
}

}  // namespace occlude::render
