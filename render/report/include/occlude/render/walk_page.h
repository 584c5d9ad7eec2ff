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

/// A walk that the page shows.
struct PageWalk {
  MethodWalk walk;
  const WalkRecording* recording;
};

/// What the page shows besides the summary.
struct WalkPageContent {
  std::vector<PageWalk> walks;        ///< of the same frames; the first is that of the summary
  std::vector<PagePicture> pictures;  ///< shown where the browser cannot draw the model
  std::string command;                ///< the command line of the walk; may be empty
  std::string path;                   ///< the file of its path
};

[[nodiscard]] std::string walk_page(const Summary& summary, const WalkPageContent& content);

}  // namespace occlude::render
