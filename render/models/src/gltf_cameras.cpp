// SPDX-License-Identifier: MIT
// Cameras of glTF files, and the animations that move them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "camera_motion.h"
#include "gltf_accessor.h"
#include "gltf_document.h"
#include "gltf_file.h"
#include "gltf_nodes.h"
#include "gltf_transform.h"
#include "import_child.h"
#include "node_motion.h"

namespace occlude::render {
namespace gltf {
namespace {

constexpr List kCameras{"cameras", "camera"}, kAnimations{"animations", "animation"};

class CameraReader {
 public:
  CameraReader(const Document& document, Buffers& buffers) : document_(document), buffers_(buffers) {}

  CameraMotion read(const std::string& name) {
    CameraMotion motion;
    std::optional<std::uint64_t> found;
    for (std::uint64_t i = 0; i < document_.count(kNodes); ++i) {
      if (find(document_.item(kNodes, i), "camera") == nullptr) continue;
      if (add_name(motion, name_of(i)) == name) found = i;
    }
    if (!found) return motion;
    read_nodes();
    const auto node = static_cast<std::size_t>(*found);
    animate(node);
    motion.lens = lens_of(document_.item(kCameras, whole_in(document_.item(kNodes, *found), "camera")));
    motion.poses = poses_of(nodes_, node);
    return motion;
  }

 private:
  [[nodiscard]] std::string name_of(std::uint64_t node) const {
    const json& item = document_.item(kNodes, node);
    const std::uint64_t camera = whole_in(item, "camera");
    const std::string own = text_in(item, "name", ""), of_camera = text_in(document_.item(kCameras, camera), "name", "");
    return !own.empty() ? own : !of_camera.empty() ? of_camera : fmt::format("{}", camera);
  }

  void read_nodes() {
    nodes_.resize(document_.count(kNodes));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      at([&] { return document_.label(kNodes, i); }, [&] { read_node(i); });
    }
  }

  void read_node(std::size_t index) {
    const json& item = document_.item(kNodes, index);
    MovingNode& node = nodes_[index];
    node.translation = translation_of(item);
    node.rotation = rotation_of(item);
    node.scale = scale_of(item);
    node.rest = matrix_of(item).value_or(placement(node.translation, node.rotation, node.scale));
    for (const json& child : array_in(item, "children")) {
      if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes_.size())
        refuse("children: there is no such node");
      nodes_[child.get<std::size_t>()].parent = index;
    }
  }

  /// Takes the first animation that moves the node.
  void animate(std::size_t node) {
    const std::vector<std::size_t> line = line_of(nodes_, node);
    for (std::uint64_t i = 0; i < document_.count(kAnimations); ++i) {
      const json& animation = document_.item(kAnimations, i);
      at([&] { return document_.label(kAnimations, i); },
         [&] {
           for (const json& channel : array_in(animation, "channels")) read_channel(animation, channel, line);
         });
      if (std::ranges::any_of(line, [&](std::size_t n) { return nodes_[n].moves(); })) return;
    }
  }

  void read_channel(const json& animation, const json& channel, std::span<const std::size_t> line) {
    const json& target = object_in(channel, "target");
    const auto target_node = find_whole(target, "node");
    if (!target_node || std::ranges::find(line, *target_node) == line.end()) return;
    MovingNode& node = nodes_[static_cast<std::size_t>(*target_node)];
    const json& samplers = array_in(animation, "samplers");
    const std::uint64_t index = whole_in(channel, "sampler");
    if (index >= samplers.size() || !samplers[index].is_object()) refuse(fmt::format("sampler {}: there is none", index));
    const std::string path = text_in(target, "path", "");
    if (path == "translation") read_track(samplers[index], 3, node.translations);
    if (path == "scale") read_track(samplers[index], 3, node.scales);
    if (path == "rotation") read_track(samplers[index], 4, node.rotations);
  }

  template <class V>
  void read_track(const json& sampler, unsigned width, Track<V>& track) {
    const std::string manner = text_in(sampler, "interpolation", "LINEAR");
    track.between = manner == "STEP" ? Between::step : manner == "CUBICSPLINE" ? Between::cubic : Between::linear;
    track.times = numbers_of(whole_in(sampler, "input"), 1);
    const std::vector<double> values = numbers_of(whole_in(sampler, "output"), width);
    const std::size_t each = track.between == Between::cubic ? 3 : 1;
    if (values.size() != track.times.size() * each * width) refuse("sampler: times and values differ in number");
    const bool ascend =
        std::ranges::adjacent_find(track.times, [](double a, double b) { return !(a < b); }) == track.times.end();
    if (!ascend || !std::ranges::all_of(track.times, [](double t) { return std::isfinite(t); })) {
      refuse("sampler: the times do not ascend");
    }
    for (std::size_t i = 0; i < values.size(); i += width) {
      V value{};
      for (unsigned k = 0; k < width; ++k) value[static_cast<int>(k)] = values[i + k];
      track.values.push_back(value);
    }
  }

  [[nodiscard]] std::vector<double> numbers_of(std::uint64_t accessor, unsigned width) {
    const Accessor elements(document_, buffers_, accessor, width);
    std::vector<double> numbers;
    for (std::uint64_t i = 0; i < elements.size(); ++i) {
      for (unsigned k = 0; k < width; ++k) numbers.push_back(elements.number(i, k));
    }
    return numbers;
  }

  static CameraMotion::Lens lens_of(const json& camera) {
    CameraMotion::Lens lens;
    lens.is_perspective = text_in(camera, "type", "") == "perspective";
    const json& numbers = object_in(camera, lens.is_perspective ? "perspective" : "orthographic");
    lens.far = number_in(numbers, "zfar", lens.far);
    lens.near = number_in(numbers, "znear", lens.near);
    if (lens.is_perspective) lens.fov_y_deg = number_in(numbers, "yfov", 0) * 180 / std::numbers::pi;
    if (lens.is_perspective) return lens;
    lens.height = 2 * number_in(numbers, "ymag", 0);
    if (lens.near == 0) lens.near = 0x1p-20 * lens.far;  // legal in glTF; paths have a plane before the eye
    return lens;
  }

  const Document& document_;
  Buffers& buffers_;
  std::vector<MovingNode> nodes_;
};

}  // namespace
}  // namespace gltf

CameraMotion gltf_camera(const std::filesystem::path& file, const std::string& name) {
  return import_in_child(file, gltf::kReader, [&](CountedFiles& files) {
    try {
      return gltf::of_file(file, files, [&](const gltf::Document& document, gltf::Buffers& buffers) {
        return gltf::CameraReader(document, buffers).read(name);
      });
    } catch (const gltf::OldVersion&) {
      return import_camera_with_assimp(file, name, files);
    }
  });
}

}  // namespace occlude::render
