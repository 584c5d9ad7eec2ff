// SPDX-License-Identifier: MIT
#include "witness_file.h"

#include <fmt/format.h>

#include <utility>

#include "hidden_proof.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/packing.h"
#include "proof.h"

namespace occlude::cli {

WitnessFile::WitnessFile(const std::string& name) : lines_(name), next_(read_next()) {
  if (!next_) return;
  try {
    leaf_size_ = proof::leaf_size_of(next_->line);
    has_claims_ = proof::is_claim(next_->line);
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

std::vector<Place> next_part(const std::function<std::optional<Place>()>& next) {
  constexpr std::size_t kMost = 2048;
  // Parsed JSON takes many times as much memory as it has bytes.
  constexpr std::size_t kMostBytes = render::kMostJson;
  std::vector<Place> places;
  for (std::size_t bytes = 0; places.size() < kMost && bytes < kMostBytes; bytes += places.back().line.size()) {
    std::optional<Place> place = next();
    if (!place) break;
    places.push_back(std::move(*place));
  }
  return places;
}

std::string pack_lines(const std::vector<Place>& places) {
  render::Packer packer;
  for (const Place& place : places) packer.put(place.line);
  return packer.bytes();
}

std::vector<std::string> unpack_lines(const std::string& bytes) {
  std::vector<std::string> lines;
  for (render::Unpacker unpacker(bytes); !unpacker.is_empty();) lines.push_back(unpacker.text());
  return lines;
}

}  // namespace occlude::cli
