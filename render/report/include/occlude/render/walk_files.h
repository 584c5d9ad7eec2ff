// SPDX-License-Identifier: MIT
// The output files of a walk.
#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "occlude/render/camera_path.h"
#include "occlude/render/output_file.h"
#include "occlude/render/output_folder.h"
#include "occlude/render/picture_set.h"
#include "occlude/render/summary.h"
#include "occlude/render/walk_page.h"
#include "occlude/render/walk_recording.h"

namespace occlude::render {

/// The path of a walk, in the folder of its report.
inline constexpr const char* kPathFile = "path.json";

/// frames.csv, summary.json, report.html, path.json and plates/*.png in a folder, and the witness file and the log that the
/// options name.
class WalkFiles : public WalkOutput {
 public:
  /// Opens all files before the work starts. Throws InputError if one cannot be written. `command` is the command line, for
  /// the report. The path is written unless the walk has read it from there. The options must outlive this object.
  WalkFiles(const std::filesystem::path& folder, const WalkOptions& options, std::string command, bool writes_path);

  void add_model(const culler::Culler& culler) override;
  void add_frame(const ShownFrame& frame) override;
  void add_witness(std::string_view line) override;
  void add_plate(const Plate& plate, const Image& image) override;
  /// Takes what another method shows of the same frames, for the report.
  [[nodiscard]] WalkOutput& add_method();
  /// Writes the reports. All files are complete then. `walks` has the walk of the summary, then those of add_method() in
  /// their order.
  void write(const std::vector<MethodWalk>& walks, const Summary& summary, const CameraPath& path);
  /// Gives all files their names.
  void commit();

 private:
  /// The page alone.
  class Recorded : public WalkOutput {
   public:
    void add_model(const culler::Culler& culler) override { recording.emplace(culler); }
    void add_frame(const ShownFrame& frame) override { recording->add_frame(frame); }
    void add_witness(std::string_view /*line*/) override {}
    void add_plate(const Plate& /*plate*/, const Image& /*image*/) override {}

    std::optional<WalkRecording> recording;
  };

  [[nodiscard]] std::vector<OutputFile*> files();

  const WalkOptions& options_;
  OutputFolder folder_, plates_folder_;
  OutputFile csv_, report_, summary_;
  std::optional<OutputFile> path_, witness_, log_;
  PictureSet pictures_;
  std::deque<Recorded> recorded_;                 ///< the first is that of the walk itself
  const culler::Hierarchy* hierarchy_ = nullptr;  ///< of the model
  std::vector<PagePicture> page_pictures_;
  std::string command_;
};

}  // namespace occlude::render
