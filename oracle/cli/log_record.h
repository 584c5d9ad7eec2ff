// SPDX-License-Identifier: MIT
// A record of a log of culls (docs/audit.md): a frame, or what an object consists of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "camera_picture.h"
#include "cases/json_input.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/block_reader.h"

namespace occlude::cli {

using cases::LineError;

/// Polygons by their numbers in the model file.
struct ObjectRecord {
  std::uint32_t object = 0;
  std::vector<culler::PolygonRange> polygons;
};

/// What was culled, or all that was drawn: polygons or objects.
struct FrameRecord {
  std::uint32_t frame = 0;
  proof::AnyCamera camera;
  std::uint32_t width = 0, height = 0;
  bool is_drawn = false, is_of_objects = false;
  std::vector<culler::PolygonRange> polygons;
  std::vector<std::uint32_t> objects;
};

using LogRecord = std::variant<ObjectRecord, FrameRecord>;

/// The record on a line of JSON. Throws LineError.
[[nodiscard]] LogRecord json_record(std::string_view line);

/// The first byte of binary logs, with which no JSON begins.
inline constexpr char kBinaryBegin = 'O';

/// A binary log, record by record.
class BinaryRecords {
 public:
  /// Of a model with so many polygons. REQUIRES: `blocks` outlives this object.
  BinaryRecords(render::BlockReader& blocks, std::size_t polygons) : blocks_(blocks), polygons_(polygons) {}

  /// The next record, none at the end, of a log with so many objects before it. Throws LineError, also for a log that is cut
  /// off and for a list that is longer than there are polygons or objects, and as BlockReader.
  [[nodiscard]] std::optional<LogRecord> next(std::size_t objects);

 private:
  template <class Number>
  [[nodiscard]] Number number();
  /// The number of entries of a list.
  [[nodiscard]] std::uint32_t length(std::size_t most, const char* of);
  [[nodiscard]] std::vector<culler::PolygonRange> ranges();
  [[nodiscard]] ObjectRecord object();
  [[nodiscard]] FrameRecord frame(bool by_matrix, std::size_t objects);
  void read_head();

  render::BlockReader& blocks_;
  std::size_t polygons_;
  bool has_head_ = false;
};

}  // namespace occlude::cli
