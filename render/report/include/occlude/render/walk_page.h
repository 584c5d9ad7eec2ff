// SPDX-License-Identifier: MIT
// The report of a walk as one HTML page, which needs no other file and no network.
#pragma once

#include <string>
#include <vector>

#include "occlude/render/summary.h"
#include "occlude/render/walk_recording.h"

namespace occlude::render {

/// A picture inside the page.
struct PagePicture {
  std::string caption;
  std::string png;
};

/// What the page shows besides the summary.
struct WalkPageContent {
  const std::vector<FrameRecord>& frames;
  const std::vector<RegionRecord>& regions;                  ///< as in WalkResult
  const std::vector<culler::MissedReasons::Counts>& missed;  ///< as in WalkResult
  const WalkRecording& recording;
  std::vector<PagePicture> pictures;  ///< shown where the browser cannot draw the model
  std::string command;                ///< the command line of the walk; may be empty
  std::string path;                   ///< the file of its path
};

[[nodiscard]] std::string walk_page(const Summary& summary, const WalkPageContent& content);

}  // namespace occlude::render
