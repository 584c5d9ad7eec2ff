// SPDX-License-Identifier: MIT
// The account of one polygon as text, JSON and pictures.
#pragma once

#include <filesystem>
#include <string>

#include "occlude/render/output_file.h"
#include "occlude/render/output_folder.h"
#include "occlude/render/why.h"

namespace occlude::render {

[[nodiscard]] std::string to_text(const ReplayedFrame& frame, const Account& account);
[[nodiscard]] std::string to_json(const ReplayedFrame& frame, const Account& account);

/// why.json, view.png and outside.png in a folder.
class WhyFiles {
 public:
  /// Throws InputError if the folder cannot be written.
  explicit WhyFiles(const std::filesystem::path& folder);

  /// REQUIRES: an OffscreenContext current on this thread.
  void write(const ReplayedFrame& frame, const Account& account);

 private:
  OutputFolder folder_;
  OutputFile json_, view_, outside_;
};

}  // namespace occlude::render
