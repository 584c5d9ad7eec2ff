// SPDX-License-Identifier: MIT
// A log of what a culler culled, frame by frame (docs/audit.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "log_record.h"
#include "occlude/render/line_reader.h"

namespace occlude::cli {

struct LoggedFrame {
  std::uint32_t number = 0;
  proof::AnyCamera camera;    ///< without a fault; if it is a matrix, one of perspective
  culler::Camera shown;       ///< the same camera or, around a matrix, one whose picture has all of the matrix's
  int width = 0, height = 0;  ///< of the picture, in pixels
  std::vector<bool> culled;   ///< for each polygon of the model file
};

class CullLog {
 public:
  static constexpr std::uint32_t kNoObject = std::numeric_limits<std::uint32_t>::max();

  /// Of a model with so many polygons in its file. "-" is standard input; the log may be compressed by gzip. Throws
  /// InputError, also from next(), with file and line, or record, for what cannot be read.
  CullLog(const std::string& file, std::size_t polygons);

  /// The next frame, none at the end.
  [[nodiscard]] std::optional<LoggedFrame> next();
  /// The object that a polygon belongs to, or kNoObject.
  [[nodiscard]] std::uint32_t object_of(std::size_t polygon) const {
    return object_of_.empty() ? kNoObject : object_of_[polygon];
  }

  /// Bytes of the file read so far, and its size; the size of a pipe is 0.
  [[nodiscard]] std::size_t read() const { return lines_.read(); }
  [[nodiscard]] std::size_t size() const { return lines_.size(); }

 private:
  [[nodiscard]] std::optional<LogRecord> next_record();
  void require(const std::vector<culler::PolygonRange>& ranges) const;
  void add(const ObjectRecord& object);
  [[nodiscard]] std::vector<bool> culled_by(const FrameRecord& frame) const;
  [[nodiscard]] LoggedFrame logged(const FrameRecord& frame);

  render::LineReader lines_;
  std::optional<BinaryRecords> binary_;
  std::size_t records_ = 0;
  std::size_t polygons_;
  std::map<std::uint32_t, std::vector<culler::PolygonRange>> objects_;
  std::vector<std::uint32_t> object_of_;  ///< empty as long as there are none
  std::set<std::uint32_t> frames_;
};

}  // namespace occlude::cli
