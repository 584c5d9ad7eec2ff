// SPDX-License-Identifier: MIT
#include "cull_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "command_arguments.h"
#include "occlude/kernel/validity.h"
#include "occlude/render/errors.h"

namespace occlude::cli {
namespace {

/// What a number below the kernel's least counts as: 0.
culler::Camera flushed(culler::Camera camera) {
  for (glm::dvec3* point : {&camera.eye, &camera.target, &camera.up}) {
    for (int axis = 0; axis < 3; ++axis) (*point)[axis] = kernel::flushed((*point)[axis]);
  }
  return camera;
}

template <class AnyCamera>
void require_sound(const AnyCamera& camera) {
  if (const std::string reason = culler::fault(camera); !reason.empty()) throw LineError("the camera: " + reason);
}

/// The least depth, as the camera sees it, of the matrix's near plane within the matrix's picture; infinite if it is nowhere
/// there. A plane n . p + d = 0 is met on the line from the eye through c at t = -(n . eye + d) / (n . c), which is least at
/// a corner.
double least_near(const culler::MatrixCamera& matrix, const culler::Camera& camera) {
  const oracle::Picture picture = proof::picture_of(matrix, 0);
  const auto normal = [](const oracle::HalfSpaceCoefficients& h) { return glm::dvec3(h[0], h[1], h[2]); };
  const oracle::HalfSpaceCoefficients& near = picture.depth.front();
  const glm::dvec3 forward = camera.axes().forward;
  const double before = -(glm::dot(normal(near), camera.eye) + near[3]);
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t x : {0U, 1U}) {
    for (const std::size_t y : {2U, 3U}) {
      const glm::dvec3 along = glm::cross(normal(picture.sides[x]), normal(picture.sides[y]));
      const glm::dvec3 corner = along / glm::dot(forward, along);
      const double slope = glm::dot(normal(near), corner);
      if (slope > 0) least = std::min(least, before / slope);
    }
  }
  return least;
}

/// A camera whose picture has all that the matrix shows.
culler::Camera around(const culler::MatrixCamera& camera) {
  const glm::dmat4& m = camera.matrix;
  if (m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0) {
    throw LineError("the matrix has parallel rays: give \"eye\", \"target\" and \"projection\":\"orthographic\"");
  }
  require_sound(camera);
  try {
    constexpr double kNearer = 1 - 0x1p-20;  // more than rounds
    culler::Camera shown = culler::ahead(camera, {}, 0, {.aside = 0, .up = 0});
    shown.eyes = {};
    shown.near_plane = std::min(shown.near_plane, kNearer * least_near(camera, shown));
    return shown;
  } catch (const std::invalid_argument&) {
    throw LineError("the matrix: its eye is too far away, or its picture too large, for doubles");
  }
}

void mark(std::vector<bool>& marks, const std::vector<culler::PolygonRange>& ranges, bool value) {
  for (const culler::PolygonRange& range : ranges) {
    std::fill_n(marks.begin() + static_cast<std::ptrdiff_t>(range.first), range.count, value);
  }
}

}  // namespace

CullLog::CullLog(const std::string& file, std::size_t polygons) : lines_(file), polygons_(polygons) {
  if (lines_.blocks().ahead().starts_with(kBinaryBegin)) binary_.emplace(lines_.blocks(), polygons_);
}

std::optional<LogRecord> CullLog::next_record() {
  ++records_;
  if (binary_) return binary_->next(objects_.size());
  for (std::string line; lines_.next(line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) return json_record(line);
  }
  return std::nullopt;
}

std::optional<LoggedFrame> CullLog::next() {
  try {
    while (std::optional<LogRecord> record = next_record()) {
      if (const auto* frame = std::get_if<FrameRecord>(&*record)) return logged(*frame);
      add(std::get<ObjectRecord>(*record));
    }
  } catch (const LineError& error) {
    const std::string place = binary_ ? fmt::format(" record {}", records_) : fmt::format("{}", lines_.number());
    throw render::InputError(fmt::format("{}:{}: {}", lines_.name(), place, error.what()));
  }
  if (frames_.empty()) throw render::InputError(lines_.name() + ": no frames");
  return std::nullopt;
}

void CullLog::require(const std::vector<culler::PolygonRange>& ranges) const {
  std::uint64_t listed = 0;
  for (const auto& [first, count] : ranges) {
    if (count == 0) throw LineError(fmt::format("the range [{}, 0] is empty", first));
    const std::uint64_t end = std::uint64_t{first} + count;
    if (end > polygons_) {
      throw LineError(fmt::format("polygons {} to {}: the model has {}", first, end - 1, polygons_));
    }
    listed += count;
  }
  if (listed > polygons_) throw LineError("it lists polygons twice");
}

void CullLog::add(const ObjectRecord& object) {
  require(object.polygons);
  if (object.object == kNoObject) throw LineError("an object may not have this number");
  if (!objects_.try_emplace(object.object, object.polygons).second) {
    throw LineError(fmt::format("object {} is there twice", object.object));
  }
  object_of_.resize(polygons_, kNoObject);
  for (const auto& [first, count] : object.polygons) {
    for (std::uint32_t p = first; p < first + count; ++p) {
      if (object_of_[p] != kNoObject)
        throw LineError(fmt::format("polygon {} belongs to object {} already", p, object_of_[p]));
      object_of_[p] = object.object;
    }
  }
}

std::vector<bool> CullLog::culled_by(const FrameRecord& frame) const {
  std::vector<bool> culled(polygons_, frame.is_drawn && !frame.is_of_objects);
  require(frame.polygons);
  mark(culled, frame.polygons, !frame.is_drawn);
  if (!frame.is_of_objects) return culled;
  if (frame.is_drawn) {
    for (const auto& [id, polygons] : objects_) mark(culled, polygons, true);
  }
  std::set<std::uint32_t> listed;
  for (const std::uint32_t id : frame.objects) {
    const auto object = objects_.find(id);
    if (object == objects_.end()) throw LineError(fmt::format("no object {}", id));
    if (!listed.insert(id).second) throw LineError(fmt::format("it lists object {} twice", id));
    mark(culled, object->second, !frame.is_drawn);
  }
  return culled;
}

LoggedFrame CullLog::logged(const FrameRecord& frame) {
  for (const std::uint32_t side : {frame.width, frame.height}) {
    if (side < 1 || side > kLargestSide) throw LineError(fmt::format("width and height must be from 1 to {}", kLargestSide));
  }
  if (!frames_.insert(frame.frame).second) throw LineError(fmt::format("frame {} is there twice", frame.frame));
  LoggedFrame result{.number = frame.frame,
                     .camera = frame.camera,
                     .shown = {},
                     .width = static_cast<int>(frame.width),
                     .height = static_cast<int>(frame.height),
                     .culled = culled_by(frame)};
  if (auto* camera = std::get_if<culler::Camera>(&result.camera)) {
    *camera = flushed(*camera);
    camera->aspect = static_cast<double>(frame.width) / frame.height;
    require_sound(*camera);
    result.shown = *camera;
  } else {
    result.shown = around(std::get<culler::MatrixCamera>(result.camera));
  }
  return result;
}

}  // namespace occlude::cli
