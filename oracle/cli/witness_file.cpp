// SPDX-License-Identifier: MIT
#include "witness_file.h"

#include <fmt/format.h>

#include <utility>

#include "occlude/render/errors.h"
#include "proof.h"

namespace occlude::cli {

WitnessFile::WitnessFile(const std::string& name) : lines_(name), next_(read_next()) {
  if (!next_) return;
  try {
    leaf_size_ = proof::leaf_size_of(next_->line);
  } catch (const cases::LineError& error) {
    throw render::InputError(fmt::format("{}: {}", next_->name, error.what()));
  }
}

std::optional<Place> WitnessFile::next() { return std::exchange(next_, read_next()); }

std::optional<Place> WitnessFile::read_next() {
  for (std::string line; lines_.next(line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    return Place{std::move(line), fmt::format("{}:{}", lines_.name(), lines_.number()), lines_.number()};
  }
  return std::nullopt;
}

}  // namespace occlude::cli
