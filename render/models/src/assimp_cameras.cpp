// SPDX-License-Identifier: MIT
// Cameras of the import library's scenes.
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "assimp_scene.h"
#include "camera_motion.h"
#include "import_child.h"
#include "node_motion.h"

namespace occlude::render {
namespace {

using glm::dvec3;

dvec3 vector_of(const aiVector3D& v) { return {v.x, v.y, v.z}; }
glm::dvec4 quaternion_of(const aiQuaternion& q) { return {q.x, q.y, q.z, q.w}; }

/// The nodes of a scene, those that an animation has not moved yet at rest.
class SceneNodes {
 public:
  explicit SceneNodes(const aiScene& scene) {
    // An explicit stack: the file decides how deep the tree is.
    std::vector<std::pair<const aiNode*, std::optional<std::size_t>>> stack{{scene.mRootNode, std::nullopt}};
    while (!stack.empty()) {
      const auto [node, parent] = stack.back();
      stack.pop_back();
      MovingNode moving;
      moving.parent = parent;
      moving.rest = placement_of(*node);
      numbers_.emplace(node->mName.C_Str(), nodes_.size());
      nodes_.push_back(moving);
      for (const aiNode* child : std::span(node->mChildren, node->mNumChildren))
        stack.emplace_back(child, nodes_.size() - 1);
    }
  }

  [[nodiscard]] std::optional<std::size_t> number(const std::string& name) const {
    const auto found = numbers_.find(name);
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }

  /// Takes the animation if it moves the node or one above it.
  bool animate(const aiAnimation& animation, std::size_t node) {
    const std::vector<std::size_t> line = line_of(nodes_, node);
    bool moves = false;
    for (const aiNodeAnim* channel : std::span(animation.mChannels, animation.mNumChannels)) {
      const auto target = number(channel->mNodeName.C_Str());
      if (!target || std::ranges::find(line, *target) == line.end()) continue;
      add(*channel, animation.mTicksPerSecond, nodes_[*target]);
      moves = true;
    }
    return moves;
  }

  [[nodiscard]] std::vector<glm::dmat4> poses(std::size_t node) const { return poses_of(nodes_, node); }

 private:
  static void add(const aiNodeAnim& channel, double ticks_per_second, MovingNode& node) {
    constexpr double kTicks = 25;  // where a file does not say
    const double tick = 1 / (ticks_per_second > 0 ? ticks_per_second : kTicks);
    take(std::span(channel.mPositionKeys, channel.mNumPositionKeys), tick, vector_of, node.translations);
    take(std::span(channel.mScalingKeys, channel.mNumScalingKeys), tick, vector_of, node.scales);
    take(std::span(channel.mRotationKeys, channel.mNumRotationKeys), tick, quaternion_of, node.rotations);
  }

  /// Keys that do not come later than those before them are left out.
  template <class Key, class Convert, class V>
  static void take(std::span<Key> keys, double tick, Convert convert, Track<V>& track) {
    for (const Key& key : keys) {
      const double time = key.mTime * tick;
      if (!std::isfinite(time) || (!track.empty() && time <= track.times.back())) continue;
      track.times.push_back(time);
      track.values.push_back(convert(key.mValue));
    }
  }

  std::vector<MovingNode> nodes_;
  std::map<std::string, std::size_t> numbers_;
};

/// From the coordinates of a camera, which looks along -z, to those of its node.
glm::dmat4 in_node(const aiCamera& camera) {
  const dvec3 back = -glm::normalize(vector_of(camera.mLookAt)), right = glm::cross(vector_of(camera.mUp), back);
  return {glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0),
          glm::dvec4(vector_of(camera.mPosition), 1)};
}

CameraMotion::Lens lens_of(const aiCamera& camera) {
  constexpr double kAspect = 16.0 / 9;  // of pictures, where a file does not say
  const double aspect = camera.mAspect > 0 ? camera.mAspect : kAspect;
  CameraMotion::Lens lens;
  // Where a file has no planes, the library gives 0.
  if (camera.mClipPlaneFar > 0) lens.far = camera.mClipPlaneFar;
  if (camera.mClipPlaneNear > 0) lens.near = camera.mClipPlaneNear;
  lens.is_perspective = !(camera.mOrthographicWidth > 0);
  if (lens.is_perspective) {
    lens.fov_y_deg = 360 / std::numbers::pi * std::atan(std::tan(camera.mHorizontalFOV / 2.0) / aspect);
  } else {
    lens.height = 2 * camera.mOrthographicWidth / aspect;
  }
  return lens;
}

CameraMotion camera_of(const aiScene& scene, const std::string& name) {
  CameraMotion motion;
  const aiCamera* found = nullptr;
  for (const aiCamera* camera : std::span(scene.mCameras, scene.mNumCameras)) {
    if (add_name(motion, camera->mName.C_Str()) == name) found = camera;
  }
  SceneNodes nodes(scene);
  const auto node = found == nullptr ? std::nullopt : nodes.number(found->mName.C_Str());
  if (!node) return motion;
  for (const aiAnimation* animation : std::span(scene.mAnimations, scene.mNumAnimations)) {
    if (nodes.animate(*animation, *node)) break;
  }
  motion.lens = lens_of(*found);
  for (const glm::dmat4& pose : nodes.poses(*node)) motion.poses.push_back(pose * in_node(*found));
  return motion;
}

}  // namespace

CameraMotion import_camera_with_assimp(const std::filesystem::path& file, const std::string& name, CountedFiles& files) {
  return camera_of(ImportedScene(file, files).scene(), name);
}

CameraMotion imported_camera(const std::filesystem::path& file, const std::string& name) {
  return import_in_child(file, kImportLibrary,
                         [&](CountedFiles& files) { return import_camera_with_assimp(file, name, files); });
}

}  // namespace occlude::render
