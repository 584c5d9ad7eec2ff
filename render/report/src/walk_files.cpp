// SPDX-License-Identifier: MIT
#include "occlude/render/walk_files.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "occlude/render/log_line.h"
#include "occlude/render/plates.h"

namespace occlude::render {
namespace {

/// In half its size and with fewer colours, which a PNG file stores in much fewer bytes.
Image small(const Image& image) {
  const auto coarse = [](std::uint8_t channel) { return static_cast<std::uint8_t>((channel & 0xF0U) | channel >> 4U); };
  Image result = halved(image);
  for (Rgba& pixel : result.pixels) pixel = {coarse(pixel.r), coarse(pixel.g), coarse(pixel.b), pixel.a};
  return result;
}

}  // namespace

WalkFiles::WalkFiles(const std::filesystem::path& folder, const WalkOptions& options, std::string command, bool writes_path)
    : options_(options),
      folder_(folder),
      plates_folder_(folder / "plates"),
      csv_(folder / "frames.csv"),
      report_(folder / "report.html"),
      summary_(folder / "summary.json"),
      path_(writes_path ? std::optional<OutputFile>(std::in_place, folder / kPathFile) : std::nullopt),
      witness_(options.witness ? std::optional<OutputFile>(std::in_place, *options.witness) : std::nullopt),
      log_(options.log ? std::optional<OutputFile>(std::in_place, *options.log) : std::nullopt),
      pictures_(folder / "plates", is_plate),
      recorded_(1),
      command_(std::move(command)) {}

void WalkFiles::add_model(const culler::Culler& culler) {
  recorded_.front().add_model(culler);
  hierarchy_ = &culler.hierarchy();
}

void WalkFiles::add_frame(const ShownFrame& frame) {
  recorded_.front().add_frame(frame);
  if (log_) log_->write(log_line(frame, *hierarchy_, options_) + '\n');
}

void WalkFiles::add_witness(std::string_view line) {
  witness_->write(line);
  witness_->write("\n");
}

void WalkFiles::add_plate(const Plate& plate, const Image& image) {
  pictures_.add(plate.file, image);
  constexpr std::size_t kInPage = 2;  // the plates of one frame, which are only for old browsers
  if (page_pictures_.size() < kInPage) page_pictures_.push_back({plate.caption, png_of(small(image))});
}

WalkOutput& WalkFiles::add_method() { return recorded_.emplace_back(); }

void WalkFiles::write(const std::vector<MethodWalk>& walks, const Summary& summary, const CameraPath& path) {
  csv_.write(frames_csv(*walks.front().walk));
  WalkPageContent content{{}, page_pictures_, command_, json_of(path)};
  for (std::size_t i = 0; i < walks.size(); ++i) content.walks.push_back({walks[i], &*recorded_[i].recording});
  report_.write(walk_page(summary, content));
  summary_.write(json_of(summary).dump(2) + "\n");
  if (path_) write_camera_path(*path_, path);
  for (OutputFile* file : files()) file->close();
}

void WalkFiles::commit() {
  pictures_.commit();
  for (OutputFile* file : files()) file->commit();
}

std::vector<OutputFile*> WalkFiles::files() {
  std::vector<OutputFile*> files{&csv_, &report_, &summary_};
  for (std::optional<OutputFile>* file : {&path_, &witness_, &log_}) {
    if (*file) files.push_back(&**file);
  }
  return files;
}

}  // namespace occlude::render
