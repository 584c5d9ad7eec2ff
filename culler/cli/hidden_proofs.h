// SPDX-License-Identifier: MIT
// Lines that prove what is hidden, as `occlude validate` reads them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "command_arguments.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/types.h"
#include "occlude/render/output_file.h"

namespace occlude::cli {

/// The options for writing proofs.
struct ProofArguments {
  std::string file;
  double share = 1;

  /// `what` is what there is a share of.
  void add_to(Command command, const std::string& what);
  /// Whether number i is in the share. Those that are lie at even distances.
  [[nodiscard]] bool has(std::size_t i) const;
};

/// Appends what proves that these polygons are hidden from everywhere in `from`: those of the covers that have one of them.
/// REQUIRES: `from` lies in the eyes of the picture, of whose frame the covers are; polygons are ascending.
void append_hidden(std::vector<std::string>& lines, const culler::Hierarchy& hierarchy, const kernel::Aabb& from,
                   const culler::Camera& picture, std::span<const std::uint32_t> polygons,
                   std::span<const culler::CoverWitness> covers);

void write_lines(render::OutputFile& file, const std::vector<std::string>& lines);

}  // namespace occlude::cli
