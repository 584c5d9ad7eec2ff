// SPDX-License-Identifier: MIT
// Camera paths as JSON files.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "matrix_poses.h"
#include "model_check.h"
#include "noise.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/errors.h"
#include "occlude/render/json_text.h"
#include "occlude/render/output_file.h"
#include "path_readers.h"

namespace occlude::render {
namespace {

using culler::Projection;
using nlohmann::json;

/// Reads the members of a path from JSON. Every error names the member.
class PathReader {
 public:
  PathReader(const std::filesystem::path& file, const PathDefaults& defaults)
      : file_(file), defaults_(defaults), root_(read_json(file)) {
    path_.up = defaults.up;
    if (root_.is_array()) root_ = json{{"matrices", std::move(root_)}};
    if (!root_.is_object()) throw InputError(file.string() + ": expected a JSON object");
  }

  CameraPath read() {
    read_model_name();
    read_up();
    read_frames();
    has_matrices() ? read_matrices() : read_keyframes();
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
    return {number(value[0], name), number(value[1], name), number(value[2], name)};
  }

  void require_legal(const glm::dvec3& v, const std::string& name) const {
    if (const auto fault = vertex_fault(v)) fail(name, *fault);
  }

  glm::dvec3 up_in(const json& value, const std::string& name) {
    glm::dvec3 up = vector(value, name);
    path_.noise += drop_noise({&up});
    require_legal(up, name);
    if (up == glm::dvec3(0, 0, 0)) fail(name, "must not be zero");
    return up;
  }

  void read_up() {
    if (root_.contains("up")) path_.up = up_in(root_["up"], "up");
  }

  void read_model_name() {
    const auto model = root_.find("model");
    if (model != root_.end() && model->is_string()) path_.model = model->get<std::string>();
  }

  [[nodiscard]] bool has_matrices() const { return root_.contains("matrices") && !root_.contains("keyframes"); }

  void read_frames() {
    if (has_matrices() && !root_.contains("frames")) return;
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
      read_keyframe(keyframes[i], name);
    }
  }

  void read_keyframe(const json& keyframe, const std::string& name) {
    CameraPath::Keyframe key{vector_in(keyframe, "eye", name), vector_in(keyframe, "target", name)};
    path_.noise += drop_noise({&key.eye, &key.target});
    require_legal(key.eye, name + ".eye");
    require_legal(key.target, name + ".target");
    if (keyframe.contains("up")) key.up = up_in(keyframe["up"], name + ".up");
    if (key.eye == key.target) fail(name, "eye and target are the same point");
    path_.keyframes.push_back(key);
  }

  void read_matrices() {
    const json& list = root_["matrices"];
    if (!list.is_array() || list.size() < 2 || list.size() > kMostFrames) {
      fail("matrices", fmt::format("expected an array of 2 to {}", kMostFrames));
    }
    std::optional<MatrixOrder> order = defaults_.order;
    if (root_.contains("order")) order = choice("order", "row", "column") == 0 ? MatrixOrder::row : MatrixOrder::column;
    std::vector<MatrixNumbers> matrices;
    for (std::size_t i = 0; i < list.size(); ++i) matrices.push_back(matrix(list[i], fmt::format("matrices[{}]", i)));
    if (path_.frames == 0) path_.frames = matrices.size();
    add_keyframes(path_, matrices, order, R"(write "order": "row" or "order": "column")");
  }

  /// A list of numbers, or of rows or columns of them. Where the last row is left out, these are told apart by their length.
  [[nodiscard]] MatrixNumbers matrix(const json& value, const std::string& name) const {
    MatrixNumbers result{{}, fmt::format("{}: {}", file_.string(), name)};
    if (!value.is_array()) fail(name, "expected an array of numbers");
    const bool has_columns = value.size() == 4 && value[0].is_array() && value[0].size() == 3;
    for (std::size_t i = 0; i < value.size(); ++i) {
      const json& line = value[i];
      if (line.size() > 4) fail(name, "expected rows of 4 numbers");
      if (line.is_array()) {
        for (const json& item : line) result.numbers.push_back(number(item, name));
        if (has_columns) result.numbers.push_back(i == 3 ? 1 : 0);
      } else {
        result.numbers.push_back(number(line, name));
      }
    }
    if (value.size() == 3 && value[0].is_array()) result.numbers.insert(result.numbers.end(), {0, 0, 0, 1});
    return result;
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
  }

  void check_frames() const {
    const auto fault = fault_of(path_);
    if (!fault) return;
    const bool lacks_up = fault->is_of_up && !root_.contains("up");
    fail(has_matrices() ? "matrices" : "keyframes", fault->text + (lacks_up ? R"(: write "up": [x, y, z])" : ""));
  }

  const std::filesystem::path& file_;
  const PathDefaults& defaults_;
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

CameraPath read_json_path(const std::filesystem::path& file, const PathDefaults& defaults) {
  return PathReader(file, defaults).read();
}

std::string json_of(const CameraPath& path) {
  const std::string model = path.model.empty() ? "" : fmt::format("\"model\": {}, ", json(path.model).dump());
  std::string result = fmt::format("{{{}\"frames\": {},\n", model, path.frames) + manner(path) + " \"keyframes\": [\n";
  const char* separator = "";
  for (const auto& [eye, target, up] : path.keyframes) {
    result += fmt::format("{}  {{\"eye\": {}, \"target\": {}{}}}", separator, text(eye), text(target),
                          up ? fmt::format(", \"up\": {}", text(*up)) : "");
    separator = ",\n";
  }
  return result + "\n]}\n";
}

void write_camera_path(OutputFile& output, const CameraPath& path) { output.write(json_of(path)); }

}  // namespace occlude::render
