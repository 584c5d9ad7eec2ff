// SPDX-License-Identifier: MIT
// A frame of a scene from the camera to the list of what to draw.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "base/work_runner.h"
#include "camera/frame_view.h"
#include "cover/cover_painter.h"
#include "cover/hiding_meshes.h"
#include "cover/worth_of_hiding.h"
#include "occlude/culler/scene.h"
#include "occlude/kernel/half_space.h"
#include "scene/object_listing.h"
#include "scene/occluder_descent.h"
#include "scene/scene_occluders.h"
#include "scene/scene_things.h"

namespace occlude::culler {

/// What is kept of a view, and memory that its frames reuse.
struct SceneView::Memory {
  /// A group of objects that is neither hidden nor out of view.
  struct SeenGroup {
    std::uint32_t group;             ///< an item of SceneObjects::groups()
    std::uint32_t straddled_planes;  ///< a bit for each plane that may cross it
  };

  /// Some of the groups, and what one thread lists of them.
  struct Part {
    std::span<const SeenGroup> groups;
    ObjectListing listing;
  };

  SceneResult result;
  FrameView view;             ///< of the last frame
  std::uint64_t edition = 0;  ///< of the scene that it shows; 0 before the first
  /// Of a frame that others may be held against: Scene::Parts::standing, and what decides which occluders took part.
  std::uint64_t standing = 0;
  std::uint32_t mask = 0;
  float least_size = 0;
  CoverMemory cover;
  WorthOfHiding worth;
  OccluderMemory occluders;
  HidingMeshes hiding;
  std::vector<kernel::HalfSpace> planes;
  std::vector<SeenGroup> groups;
  std::vector<Part> parts;
  WorkRunner runner;
  std::unique_ptr<DrawnObject[]> room;  ///< where the parts list; memory that is never written to takes only addresses
  std::size_t room_size = 0;
};

/// What is kept of the view. Not protected by `const`.
[[nodiscard]] SceneView::Memory& memory_of(const SceneView& view);

/// How far the scene reaches from the eye, in the sum of the axes.
[[nodiscard]] double reach(const SceneObjects& objects, const SceneOccluders& occluders, const glm::dvec3& eye);

/// Fills memory.result for memory.view. REQUIRES: the view reaches as far as the scene.
void cull_scene(const SceneObjects& objects, const SceneOccluders& occluders, const SceneOptions& options,
                SceneView::Memory& memory);

/// The same with what hides in the buffer. REQUIRES: also, the buffer's view reaches as far as the scene.
void cull_scene_held(const SceneObjects& objects, const SceneOccluders& occluders, const SceneOptions& options,
                     const CoverBuffer& held, SceneView::Memory& memory);

/// What becomes of these objects in a frame. REQUIRES: as above; no budget of time.
[[nodiscard]] std::vector<ObjectFate> fates_of(const SceneObjects& objects, const SceneOccluders& occluders,
                                               const FrameView& view, const SceneOptions& options,
                                               std::span<const ObjectId> ids);
/// The proofs of all that a frame culls. REQUIRES: as above.
void append_witnesses_of(const SceneObjects& objects, const SceneOccluders& occluders, const FrameView& view,
                         const SceneOptions& options, std::vector<ObjectWitness>& witnesses);

}  // namespace occlude::culler
