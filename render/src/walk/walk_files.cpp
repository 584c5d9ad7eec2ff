// SPDX-License-Identifier: MIT
#include "occlude/render/walk_files.h"

#include <vector>

#include "occlude/render/progress.h"
#include "report.h"
#include "summary.h"

namespace occlude::render {
namespace {

bool is_plate(const std::string& name) {
  return name.starts_with("frame_") && (name.ends_with("_view.png") || name.ends_with("_outside.png"));
}

}  // namespace

WalkFiles::WalkFiles(const std::filesystem::path& folder, const WalkOptions& options)
    : folder_(folder),
      plates_folder_(folder / "plates"),
      csv_(folder / "frames.csv"),
      report_(folder / "report.html"),
      summary_(folder / "summary.json"),
      witness_(options.witness ? std::optional<OutputFile>(std::in_place, *options.witness) : std::nullopt),
      plates_(folder / "plates", is_plate) {}

void WalkFiles::add_witness(std::string_view line) {
  witness_->write(line);
  witness_->write("\n");
}

void WalkFiles::add_plate(const Plate& plate, const Image& image) { plates_.add(plate.file, image); }

void WalkFiles::commit(const WalkResult& result, const WalkOptions& options, const std::string& model_name) {
  const nlohmann::ordered_json summary = summarise(result, options, model_name);
  csv_.write(frames_csv(result));
  report_.write(report_html(result, summary));
  summary_.write(summary.dump(2) + "\n");
  std::vector<OutputFile*> files{&csv_, &report_, &summary_};
  if (witness_) files.push_back(&*witness_);
  check_interrupt();
  for (OutputFile* file : files) file->close();
  plates_.commit();
  for (OutputFile* file : files) file->commit();
}

}  // namespace occlude::render
