// SPDX-License-Identifier: MIT
// The result of an audit, as text, as JSON and as files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cull_log.h"
#include "frame_audit.h"
#include "occlude/render/output_file.h"
#include "occlude/render/output_folder.h"
#include "occlude/render/picture_set.h"

namespace occlude::cli {

/// Sums over the frames.
struct AuditSums {
  std::size_t frames = 0, wrong_frames = 0;
  std::size_t culled = 0, hidden = 0, visible = 0, unsettled = 0;
  std::size_t drawn = 0, needless = 0;

  void add(const FrameAudit& frame);
};

[[nodiscard]] std::string to_text(const AuditSums& sums);
[[nodiscard]] std::string to_json(const AuditSums& sums);

/// A line of false_culls.jsonl, without its picture.
[[nodiscard]] nlohmann::ordered_json json_of(const SeenPolygon& polygon, const LoggedFrame& frame, const CullLog& log);

/// summary.json, frames.jsonl with the counts of each frame, false_culls.jsonl, and a picture of each of the first frames
/// that have a false cull.
class AuditFiles {
 public:
  /// Throws InputError for a folder that cannot be written to.
  explicit AuditFiles(const std::filesystem::path& folder);

  void add(const FrameAudit& audit, const LoggedFrame& frame, const CullLog& log, Auditor& auditor);
  /// Completes the files and gives them their names.
  void commit(const AuditSums& sums);

 private:
  render::OutputFolder folder_;
  render::OutputFile summary_, frames_, lines_;
  render::PictureSet pictures_;
  std::size_t drawn_ = 0;
};

}  // namespace occlude::cli
