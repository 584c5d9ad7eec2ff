// SPDX-License-Identifier: MIT
// Camera paths as JSON files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "model_check.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/errors.h"
#include "occlude/render/json_text.h"
#include "occlude/render/output_file.h"

namespace occlude::render {
namespace {

using culler::Projection;
using nlohmann::json;

// Nine hours at 30 frames per second. The reader checks the camera of every frame, so the number must be bounded.
constexpr std::uint64_t kMostFrames = 1'000'000;

/// Reads the members of a path from JSON. Every error names the member.
class PathReader {
 public:
  explicit PathReader(const std::filesystem::path& file) : file_(file), root_(read_json(file)) {
    if (!root_.is_object()) throw InputError(file.string() + ": expected a JSON object");
  }

  CameraPath read() {
    read_model_name();
    read_frames();
    read_keyframes();
    read_manner();
    read_lens();
    check_frames();
    return std::move(path_);
  }

 private:
  [[noreturn]] void fail(std::string_view member, std::string_view reason) const {
    throw InputError(fmt::format("{}: {}: {}", file_.string(), member, reason));
  }

  const json& required(const json& object, const char* member, std::string_view name) const {
    const auto found = object.find(member);
    if (found == object.end()) fail(name, "missing");
    return *found;
  }

  double number(const json& value, std::string_view name) const {
    if (const auto number = number_of(value)) return *number;
    fail(name, "expected a number");
  }

  double positive(const char* member, double otherwise) const {
    if (!root_.contains(member)) return otherwise;
    const double value = number(root_[member], member);
    if (!(value > 0) || !std::isfinite(value)) fail(member, "must be finite and greater than 0");
    return value;
  }

  glm::dvec3 vector(const json& value, const std::string& name) const {
    if (!value.is_array() || value.size() != 3) fail(name, "expected three numbers [x, y, z]");
    const glm::dvec3 v(number(value[0], name), number(value[1], name), number(value[2], name));
    if (const auto fault = vertex_fault(v)) fail(name, *fault);
    return v;
  }

  void read_model_name() {
    const auto model = root_.find("model");
    if (model != root_.end() && model->is_string()) path_.model = model->get<std::string>();
  }

  void read_frames() {
    const json& frames = required(root_, "frames", "frames");
    if (!frames.is_number_unsigned() || frames.get<std::uint64_t>() < 2 || frames.get<std::uint64_t>() > kMostFrames)
      fail("frames", fmt::format("expected a whole number from 2 to {}", kMostFrames));
    path_.frames = frames.get<std::size_t>();
  }

  void read_keyframes() {
    const json& keyframes = required(root_, "keyframes", "keyframes");
    if (!keyframes.is_array() || keyframes.size() < 2) fail("keyframes", "expected an array of at least two");
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
      const std::string name = fmt::format("keyframes[{}]", i);
      if (!keyframes[i].is_object()) fail(name, "expected {\"eye\": [x, y, z], \"target\": [x, y, z]}");
      path_.keyframes.push_back({vector_in(keyframes[i], "eye", name), vector_in(keyframes[i], "target", name)});
    }
  }

  glm::dvec3 vector_in(const json& keyframe, const char* member, const std::string& name) const {
    const std::string full_name = name + "." + member;
    return vector(required(keyframe, member, full_name), full_name);
  }

  /// The index of the member's value in {first, second}; 0 if there is no such member.
  int choice(const char* member, std::string_view first, std::string_view second) const {
    if (!root_.contains(member)) return 0;
    const json& value = root_[member];
    if (value != first && value != second) fail(member, fmt::format("expected \"{}\" or \"{}\"", first, second));
    return value == second ? 1 : 0;
  }

  void read_manner() {
    using enum CameraPath::Interpolation;
    path_.interpolation = choice("interpolation", "linear", "smooth") == 0 ? linear : smooth;
    path_.projection =
        choice("projection", "perspective", "orthographic") == 0 ? Projection::perspective : Projection::orthographic;
  }

  void read_lens() {
    path_.fov_y_deg = positive("fov_y_deg", path_.fov_y_deg);
    if (path_.fov_y_deg < 0.001 || path_.fov_y_deg > 179) fail("fov_y_deg", "must be from 0.001 to 179");
    if (path_.projection == Projection::orthographic) static_cast<void>(required(root_, "height", "height"));
    path_.height = positive("height", path_.height);
    path_.near = positive("near", path_.near);
    path_.far = positive("far", path_.far);
    if (path_.far <= path_.near) fail("far", "must be greater than near");
    if (root_.contains("up")) path_.up = vector(root_["up"], "up");
    if (path_.up == glm::dvec3(0, 0, 0)) fail("up", "must not be zero");
  }

  void check_frames() const {
    for (std::size_t i = 0; i < path_.keyframes.size(); ++i) {
      const auto& [eye, target] = path_.keyframes[i];
      if (eye == target) fail(fmt::format("keyframes[{}]", i), "eye and target are the same point");
    }
    for (std::size_t frame = 0; frame < path_.frames; ++frame) {
      const std::string fault = culler::fault(path_.camera(frame, 1));
      if (!fault.empty()) fail("keyframes", fmt::format("in frame {} {}", frame, fault));
    }
  }

  const std::filesystem::path& file_;
  json root_;
  CameraPath path_;
};

/// Digits that read back to the same double, the same on every machine.
std::string text(double value) { return json(value).dump(); }

std::string text(const glm::dvec3& v) { return fmt::format("[{}, {}, {}]", text(v.x), text(v.y), text(v.z)); }

std::string manner(const CameraPath& path) {
  const bool linear = path.interpolation == CameraPath::Interpolation::linear;
  const bool perspective = path.projection == Projection::perspective;
  return fmt::format(" \"interpolation\": \"{}\", \"projection\": \"{}\", \"{}\": {}, \"near\": {},{} \"up\": {},\n",
                     linear ? "linear" : "smooth", perspective ? "perspective" : "orthographic",
                     perspective ? "fov_y_deg" : "height", text(perspective ? path.fov_y_deg : path.height), text(path.near),
                     std::isfinite(path.far) ? fmt::format(" \"far\": {},", text(path.far)) : "", text(path.up));
}

}  // namespace

CameraPath read_camera_path(const std::filesystem::path& file) { return PathReader(file).read(); }

void write_camera_path(OutputFile& output, const CameraPath& path) {
  output.write(fmt::format("{{\"frames\": {},\n", path.frames) + manner(path) + " \"keyframes\": [\n");
  const char* separator = "";
  for (const auto& [eye, target] : path.keyframes) {
    output.write(fmt::format("{}  {{\"eye\": {}, \"target\": {}}}", separator, text(eye), text(target)));
    separator = ",\n";
  }
  output.write("\n]}\n");
}

}  // namespace occlude::render
