// SPDX-License-Identifier: MIT
// The paper's pipeline behind two calls: build once, cull each frame. Reading order: last.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/convex_regions.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/occluder_grid.h"
#include "occlude/culler/occluder_history.h"
#include "occlude/kernel/shadow_frustum.h"

namespace occlude::culler {

struct CullOptions {
  /// n_occ, how many occluders a frame uses; 0 is view-frustum culling alone. The paper finds 5 to 10 worth their cost.
  std::size_t occluders = 8;
  kernel::Near near = kernel::Near::surface;
  kernel::Arithmetic arithmetic = kernel::Arithmetic::certified;
  kernel::Test test = kernel::Test::conservative;
};

/// An occluder in use: a region of Culler::occluders() and its shadow.
struct Occluder {
  std::uint32_t region = 0;
  kernel::ShadowFrustum frustum;
  std::uint32_t hidden = 0;  ///< polygons of the subtrees that its shadow took
};

/// A subtree that was not drawn, and why.
struct Culled {
  enum class By { view, shadow };
  std::uint32_t node = 0;
  By by = By::view;
  std::uint32_t index = 0;  ///< of the half-space in CullResult::view, or of the occluder
};

struct CullStats {
  std::size_t nodes_visited = 0;
  std::size_t view_tests = 0;          ///< box against half-space
  std::size_t shadow_tests = 0;        ///< box against shadow frustum
  std::size_t exact_shadow_tests = 0;  ///< of these, decided by the kernel's exact stage
  std::size_t potential_occluders = 0, occluders_in_view = 0;
  std::size_t drawn_polygons = 0, view_culled_polygons = 0, shadow_culled_polygons = 0;
};

struct CullResult {
  std::vector<PolygonRange> drawn;  ///< in the order of the soup, neighbours merged
  std::vector<Culled> culled;
  std::vector<HalfSpace> view;
  std::vector<Occluder> occluders;
  CullStats stats;
};

/// Const calls may run on several threads at once.
class Culler {
 public:
  struct Config {
    Hierarchy::Config hierarchy;
    OccluderGrid::Config grid;
  };

  /// Throws std::invalid_argument, with the vertex and the reason, for a soup that is empty or has a coordinate that is not
  /// finite or out of the kernel's legal range.
  explicit Culler(const PolygonSoup& soup, const Config& config = {});

  /// What to draw for this camera: view-frustum culling, shadow culling and drawing in one traversal (section 5). Nothing
  /// visible is culled when options.arithmetic is certified. Throws std::invalid_argument for a camera with a fault().
  [[nodiscard]] CullResult cull(const Camera& camera, const CullOptions& options = {}) const;

  /// The same for the next frame of a camera that moves: occluders are chosen by what they hid in the frames before, which
  /// culls far more. The history is read, and takes this frame down.
  [[nodiscard]] CullResult cull(const Camera& camera, const CullOptions& options, OccluderHistory& history) const;

  /// Calls `visit` for every test of a box against a shadow that `frame` took, in the order of the traversal. `options` are
  /// those of the frame.
  void visit_shadow_tests(const CullResult& frame, const CullOptions& options,
                          const std::function<void(const Occluder& occluder, const Box& box)>& visit) const;

  [[nodiscard]] const Hierarchy& hierarchy() const { return hierarchy_; }
  /// What may be an occluder, of the polygons of hierarchy().soup().
  [[nodiscard]] const ConvexRegions& occluders() const { return occluders_; }
  [[nodiscard]] const OccluderGrid& grid() const { return grid_; }

 private:
  [[nodiscard]] CullResult cull_frame(const Camera& camera, const CullOptions& options,
                                      const OccluderHistory& history) const;
  template <class ShadowTest>
  void traverse(CullResult& frame, const CullOptions& options, ShadowTest&& shadow_test) const;

  Hierarchy hierarchy_;
  ConvexRegions occluders_;
  OccluderGrid grid_;
};

}  // namespace occlude::culler
