// SPDX-License-Identifier: MIT
// Reports what is culled and visible, with frame, polygon, witness and picture.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "item_buffers.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/render/output_file.h"
#include "occlude/render/output_folder.h"
#include "occlude/render/picture_set.h"
#include "visibility_check.h"

namespace occlude::cli {

/// The text of a frame's witness with this number, or its place in a file.
using WitnessText = std::function<std::string(std::size_t frame, std::size_t number)>;

/// How a frame's false culls were seen.
using SeenText = std::function<std::string(std::size_t frame)>;

/// One line about a false cull.
[[nodiscard]] std::string describe(const FalseCull& failure, const culler::Hierarchy& hierarchy, const WitnessText& witness,
                                   const SeenText& seen);

/// Writes failures.jsonl, with a line for each false cull that a check names. For each of the first frames that have one, it
/// also writes a picture of the whole model with these polygons in red.
class FailureFiles {
 public:
  /// Throws InputError for a folder that cannot be written to.
  explicit FailureFiles(const std::filesystem::path& folder);

  void write(const Visibility& visibility, const CheckedWalk& walk, const WitnessText& witness, const SeenText& seen,
             const std::function<ItemBuffers&()>& buffers);

 private:
  render::OutputFolder folder_;
  render::OutputFile lines_;
  render::PictureSet pictures_;
};

}  // namespace occlude::cli
