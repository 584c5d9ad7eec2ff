// SPDX-License-Identifier: MIT
#include "hidden_proofs.h"

#include <algorithm>
#include <cmath>

#include "camera_picture.h"
#include "cases/to_oracle.h"
#include "occlude/render/hidden_witness.h"

namespace occlude::cli {

void ProofArguments::add_to(Command command, const std::string& what) {
  add_output(command, "--witness", file, "file of what proves that polygons are hidden, for `occlude validate`");
  command.add("--witness-share", share, "share of " + what + " for which that is written").show_default().in_range(0.0, 1.0);
}

bool ProofArguments::has(std::size_t i) const {
  const auto below = [&](std::size_t n) { return std::floor(static_cast<double>(n) * share); };
  return below(i + 1) > below(i);
}

void append_hidden(std::vector<std::string>& lines, const culler::Hierarchy& hierarchy, const kernel::Aabb& from,
                   const culler::Camera& picture, std::span<const std::uint32_t> polygons,
                   std::span<const culler::CoverWitness> covers) {
  const oracle::Aabb model = cases::to_oracle(hierarchy.nodes()[0].box);
  const oracle::HalfSpaceCoefficients drawn =
      picture.eyes.is_point() ? proof::drawn(picture, model) : proof::drawn_of_sheets(picture, model);
  for (const culler::CoverWitness& cover : covers) {
    const auto first = std::ranges::lower_bound(polygons, cover.range.first),
               end = std::ranges::lower_bound(first, polygons.end(), cover.range.first + cover.range.count);
    const std::span<const std::uint32_t> hidden(first, end);
    for (std::size_t i = 0; i < hidden.size(); i += render::kMostInLine) {
      const auto part = hidden.subspan(i, std::min(render::kMostInLine, hidden.size() - i));
      lines.push_back(render::hidden_witness(hierarchy, part, from, picture, drawn, cover));
    }
  }
}

void write_lines(render::OutputFile& file, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) file.write(line + "\n");
}

}  // namespace occlude::cli
