// SPDX-License-Identifier: MIT
// What a frame draws, what it does not draw and why, and how it is asked for. Reading order: 9.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/culler/shadow_margin.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The objective of section 4.2, by which occluders are chosen: the product of its criteria, each to the power of its
/// weight. A weight of 0 switches a criterion off.
struct Objective {
  enum class Angle {
    area,   ///< the area-angle of Coorg and Teller
    exact,  ///< the solid angle itself
  };
  Angle angle = Angle::area;
  double solid_angle = 1;
  /// Of what an occluder hides as sampled by a preprocess; without one all are alike.
  double depth_complexity = 1;
  /// Of what it hid in the last frames of the view; where it was not tried then, of what good occluders are near it in the
  /// picture. Without it no frame depends on another, and nothing is probed.
  double coherence = 1;
};

/// What hides.
enum class Method {
  frusta,  ///< the shadows of a few chosen occluders, one by one: the paper's
  cover,   ///< all that is found visible, front to back, joined in a coarse picture
};

/// The most polygons of a leaf that a tree does best with. By cover leaves are small: what is hidden but for a corner of its
/// leaf is drawn.
[[nodiscard]] inline constexpr std::uint32_t leaf_size_for(Method method) { return method == Method::cover ? 4 : 16; }

/// Sides of the coarse picture of a cover, pixels.
inline constexpr int kLeastCoverSide = 64, kMostCoverSide = 4096;

struct CullOptions {
  Method method = Method::frusta;
  /// The size of the coarse picture, rounded up to multiples of 8 and taken into the limits above. A larger one hides more
  /// and costs more. Cover alone.
  int cover_width = 512, cover_height = 288;
  /// Once so many triangles were drawn into it, no more are: the nearest hide what is behind them. Those drawn last may be
  /// some hundred too many. Cover alone.
  std::size_t cover_triangles = std::numeric_limits<std::size_t>::max();
  /// The same once the frame has taken so many milliseconds. What it culls then depends on the machine; nothing visible is
  /// culled all the same. Cover alone.
  double cover_ms = std::numeric_limits<double>::infinity();
  /// Frusta alone, as all that is below but the margin and `arithmetic`, which is then that of the half-spaces.
  /// n_occ, how many occluders a frame uses; 0 is view-frustum culling alone. The paper finds 5 to 10 worth their cost.
  std::size_t occluders = 8;
  /// Candidates a frame that hide nothing yet: what they would hide of what is drawn is counted, and the best of them are
  /// occluders in the next frame of the view. Each costs less than an occluder.
  std::size_t probes = 8;
  Objective objective = {};
  kernel::Near near = kernel::Near::surface;
  kernel::Arithmetic arithmetic = kernel::Arithmetic::certified;
  kernel::Test test = kernel::Test::conservative;
  /// By how much of the picture's height shadows are taken smaller than they are (ShadowMargin). 0 culls all that is exactly
  /// hidden; for a rasteriser to draw the same picture with and without culling, it has to be what it rounds by.
  double margin = 0;
  /// Whether pairs of the occluders that share an edge hide together what neither hides alone. Certified, always exact.
  bool unions = false;
};

/// An occluder in use: one of the potential occluders, and its shadow.
struct Occluder {
  std::uint32_t index = 0;  ///< in the OccluderSet
  kernel::ShadowFrustum frustum;
  std::uint32_t hidden = 0;  ///< polygons of the subtrees that its shadow took, alone or with another
};

/// Two occluders of a frame that are also asked together, as one union: places in CullResult::occluders.
struct ShadowPair {
  /// Pairs a frame asks, for each of its occluders: the best together first. Eight occluders have all their 28; in the
  /// models tried they have 8 at most, and 64 have 67.
  static constexpr std::size_t kMostOfEach = 4;

  std::uint32_t first, second;
};

/// A subtree that was not drawn, and why.
struct Culled {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  enum class By { view, shadow, cover };
  std::uint32_t node = 0;
  By by = By::view;
  std::uint32_t index = 0;       ///< of the half-space in CullResult::view, or of the occluder
  std::uint32_t second = kNone;  ///< by shadow: of the occluder that hides it together with the first, if any
};

/// The proof of a cull, to be kept: the frame has the planes that it is about.
struct Witness {
  Culled cull;
  /// No corner of the subtree's box is nearer to a plane of the shadow, or to the half-space, on the side that culls: units
  /// of the scene, rounded down; 0 where nothing more is known, as of a cull by two shadows together.
  double margin = 0;
};

/// What hides a subtree that was culled by cover, or a part of one.
struct CoverWitness {
  PolygonRange range;
  kernel::Aabb box;                     ///< about the range: hidden
  std::vector<std::uint32_t> polygons;  ///< of Hierarchy::soup(), ascending
};

struct CullStats {
  std::size_t nodes_visited = 0;
  std::size_t view_tests = 0;                         ///< box against half-space
  std::size_t shadow_tests = 0;                       ///< box against shadow frustum
  std::size_t union_tests = 0;                        ///< box against two of them together
  std::size_t probe_tests = 0;                        ///< box against the shadow of a probe
  std::size_t cover_tests = 0;                        ///< box against the coarse picture
  std::size_t cover_groups = 0, cover_triangles = 0;  ///< drawn into it: joined meshes, and their triangles
  std::size_t cover_groups_left = 0;                  ///< not drawn into it, for a budget was spent
  std::size_t exact_shadow_tests = 0;                 ///< of these, decided by the kernel's exact stage
  std::size_t potential_occluders = 0, occluders_in_view = 0;
  std::size_t sort_kept = 0;    ///< candidates that the frame before had as well
  std::size_t sort_moves = 0;   ///< by how many places the insertion sort moved them, all together
  std::size_t choice_work = 0;  ///< of choosing among the sorted, in planes of shadows: bounded (README.md, Budgets)
  std::size_t silhouette_faces = 0, silhouette_faces_asked = 0;  ///< of polytopes: all, and those asked for their side
  /// `shadow`: of one occluder, of two together, or of a cover.
  std::size_t drawn_polygons = 0, view_culled_polygons = 0, shadow_culled_polygons = 0;
};

struct CullResult {
  Method method = Method::frusta;
  std::vector<PolygonRange> drawn;  ///< in the order of the leaves, neighbours merged
  std::vector<Culled> culled;       ///< in the order of the tree
  std::vector<HalfSpace> view;
  ShadowMargin margin;
  std::vector<Occluder> occluders;
  std::vector<ShadowPair> pairs;  ///< none unless CullOptions::unions
  CullStats stats;
};

/// Options by which a frame by cover comes about again as it was, whatever time that takes.
[[nodiscard]] inline CullOptions repeated(const CullResult& frame, CullOptions options) {
  options.cover_triangles = frame.stats.cover_triangles;
  options.cover_ms = std::numeric_limits<double>::infinity();
  return options;
}

}  // namespace occlude::culler
