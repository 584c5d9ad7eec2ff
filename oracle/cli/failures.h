// SPDX-License-Identifier: MIT
// What is culled and shows: each with frame, polygon, witness and picture.
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

/// The witness with this number of the frame: its text, or where it stands.
using WitnessText = std::function<std::string(std::size_t frame, std::size_t number)>;

/// One line, about one of them.
[[nodiscard]] std::string describe(const FalseCull& failure, const culler::Hierarchy& hierarchy, const WitnessText& witness);

/// failures.jsonl, a line for each that a check names, and of the first frames that have one a picture of the whole model
/// from there with such polygons in red.
class FailureFiles {
 public:
  /// Throws InputError for a folder that cannot be written to.
  explicit FailureFiles(const std::filesystem::path& folder);

  void write(const Visibility& visibility, const CheckedWalk& walk, const WitnessText& witness,
             const std::function<ItemBuffers&()>& buffers);

 private:
  render::OutputFolder folder_;
  render::OutputFile lines_;
  render::PictureSet pictures_;
};

}  // namespace occlude::cli
