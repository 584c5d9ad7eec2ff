// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <bit>
#include <string>

#include "log_record.h"

namespace occlude::cli {
namespace {

constexpr std::string_view kHead = "OCCLLOG1";
static_assert(kHead.front() == kBinaryBegin);

enum Kind : std::uint32_t { kMatrixFrame = 1, kEyeFrame = 2, kObject = 3 };
enum What : std::uint32_t { kDrawn = 1, kOfObjects = 2, kAll = kDrawn | kOfObjects };  // bits

}  // namespace

/// Numbers are little-endian.
template <class Number>
Number BinaryRecords::number() {
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  static_assert(sizeof(Number) == sizeof(Bits));
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(Bits); ++i) {
    const std::string_view ahead = blocks_.ahead();
    if (ahead.empty()) throw LineError("the log is cut off in it");
    bits |= Bits{static_cast<unsigned char>(ahead.front())} << (8 * i);
    blocks_.use(1);
  }
  return std::bit_cast<Number>(bits);
}

void BinaryRecords::read_head() {
  for (const char expected : kHead) {
    const std::string_view ahead = blocks_.ahead();
    if (ahead.empty() || ahead.front() != expected)
      throw LineError("not a log: it does not begin with OCCLLOG1, nor with {");
    blocks_.use(1);
  }
  has_head_ = true;
}

std::uint32_t BinaryRecords::length(std::size_t most, const char* of) {
  const auto count = number<std::uint32_t>();
  if (count > most) throw LineError(fmt::format("it lists {} {}: there are {}", count, of, most));
  return count;
}

std::vector<culler::PolygonRange> BinaryRecords::ranges() {
  std::vector<culler::PolygonRange> result;
  for (std::uint32_t i = 0, count = length(polygons_, "ranges of polygons"); i < count; ++i) {
    const auto first = number<std::uint32_t>();
    result.push_back({first, number<std::uint32_t>()});
  }
  return result;
}

ObjectRecord BinaryRecords::object() {
  const auto object = number<std::uint32_t>();
  return {object, ranges()};
}

FrameRecord BinaryRecords::frame(bool by_matrix, std::size_t objects) {
  FrameRecord frame;
  std::uint32_t what = 0;
  for (std::uint32_t* field : {&frame.frame, &frame.width, &frame.height, &what}) *field = number<std::uint32_t>();
  if (what > kAll) throw LineError("what is listed is neither culled nor drawn: " + std::to_string(what));
  frame.is_drawn = (what & kDrawn) != 0;
  frame.is_of_objects = (what & kOfObjects) != 0;
  if (by_matrix) {
    std::array<double, 16> numbers;
    for (double& value : numbers) value = number<double>();
    const auto depth = number<std::uint32_t>();
    if (depth > 1) throw LineError("the depth of the clip volume is neither 0 nor 1: " + std::to_string(depth));
    frame.camera = culler::MatrixCamera::from_columns(
        numbers.data(), depth == 0 ? culler::ClipDepth::minus_w_to_w : culler::ClipDepth::zero_to_w);
  } else {
    culler::Camera camera;
    for (glm::dvec3* point : {&camera.eye, &camera.target, &camera.up}) {
      for (int axis = 0; axis < 3; ++axis) (*point)[axis] = number<double>();
    }
    for (double* value : {&camera.fov_y_deg, &camera.near_plane, &camera.far_plane}) *value = number<double>();
    frame.camera = camera;
  }
  if (frame.is_of_objects) {
    frame.objects.resize(length(objects, "objects"));
    for (std::uint32_t& id : frame.objects) id = number<std::uint32_t>();
  } else {
    frame.polygons = ranges();
  }
  return frame;
}

std::optional<LogRecord> BinaryRecords::next(std::size_t objects) {
  if (!has_head_) read_head();
  if (blocks_.ahead().empty()) return std::nullopt;
  const auto kind = number<std::uint32_t>();
  switch (kind) {
    case kMatrixFrame:
    case kEyeFrame:
      return frame(kind == kMatrixFrame, objects);
    case kObject:
      return object();
    default:
      throw LineError("no kind of record: " + std::to_string(kind));
  }
}

}  // namespace occlude::cli
