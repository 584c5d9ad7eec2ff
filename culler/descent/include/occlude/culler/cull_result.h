// SPDX-License-Identifier: MIT
// How a model is prepared and a frame is asked for; what the frame draws, what it does not draw, and why. Reading order: 9.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The best Hierarchy::Config::leaf_size for a method. For covers leaves are small: a hidden polygon is drawn if any part of
/// its leaf's box is not hidden.
[[nodiscard]] inline constexpr std::uint32_t leaf_size_for(Method method) { return is_by_cover(method) ? 4 : 16; }

/// The regions of space that list occluders.
enum class RegionKind {
  /// Cubes of one size, in a box that may be larger than the space. The grid is halved across its longest side until each
  /// cell is one cube.
  grid,
  /// Nodes of the hierarchy, so that one structure divides space and holds what is drawn. Boxes of nodes leave gaps and
  /// overlap, so they cannot be regions themselves. Instead a plane between the boxes of its two children divides the
  /// cell of a node: across the axis on which they overlap least, as a share of the node, and in the middle of what they
  /// have in common, or of the gap between them. A plane that misses the cell does not divide it: all of it goes to the
  /// child on its side, and the other child has no cell. The cell with the largest volume is divided first, until there
  /// are as many regions as wanted, or all nodes with a cell are leaves. So regions are small where polygons are many,
  /// and large where there are none.
  tree,
};

/// What may be an occluder of frames by frusta.
struct OccluderConfig {
  /// Whether to look for convex shells. Without them every occluder is flat.
  bool shells = true;
};

/// Which occluders a region lists, for frames by frusta whose eye is in it.
struct ListConfig {
  /// What the regions are. The choice of occluders does not depend on it otherwise.
  RegionKind kind = RegionKind::grid;
  /// An occluder is listed in every region that holds a viewpoint from which its area-angle exceeds this: steradians,
  /// above 0.
  double threshold = 0.01;
  /// About how many regions to make, from 1 to 2^30; of a tree no more.
  double regions = 32768;
  /// The most entries of all lists together. If there would be more, the longest lists are cut to a common length; they
  /// keep the occluders that look largest from their regions. 2^25 entries take 128 MiB. No list of a grid is cut in the
  /// models tried (docs/measured.md).
  std::size_t entries = std::size_t{1} << 25U;
  /// A second limit, so that small models cost less: kEntriesOfEach entries for each occluder, but never less than
  /// kEntriesOfFew in all, so that a few occluders that look large from everywhere are not cut. The lists of real models
  /// have 13 to 116 entries for each polygon, those of a city of 20,010 polygons 560.
  static constexpr std::size_t kEntriesOfEach = 1024, kEntriesOfFew = std::size_t{1} << 22U;
};

/// How a model is prepared.
struct BuildConfig {
  Hierarchy::Config hierarchy = {};
  OccluderConfig occluders = {};
  ListConfig lists = {};
};

/// The objective of section 4.2, by which occluders are chosen: the product of three criteria, each to the power of its
/// weight. A weight of 0 switches a criterion off. It is a heuristic: the choice cannot make a cull wrong.
/// Weights that are negative or not finite make a poor choice and nothing worse.
struct Objective {
  /// How large an occluder looks from the eye. Ignored by orthographic cameras: theirs is its share of the picture's area.
  enum class Angle {
    area,   ///< the area-angle (PotentialOccluder::area_angle)
    exact,  ///< the solid angle
  };
  Angle angle = Angle::area;
  double solid_angle = 1;
  /// Weight of what an occluder hides as sampled by preprocess(). Without samples all occluders are equal.
  double depth_complexity = 1;
  /// Weight of what it hid in the last frames of the view. For a candidate not tried in them: of what the occluders near it
  /// in the picture hid. With 0 the occluders of a frame do not depend on earlier frames, and there are no probes.
  double coherence = 1;
};

/// Limits of the width and of the height of the coarse picture, in pixels.
inline constexpr int kLeastCoverSide = 64, kMostCoverSide = 4096;

/// What a frame by cover did with its budget.
struct CoverWork {
  std::size_t drawing = 0;  ///< work until it drew no more into the picture, as CoverOptions::work counts it
  std::size_t asking = 0;   ///< after that, asking what was left
  /// How many triangles its budget seemed to allow: with few, its picture was smaller, and only large leaves were drawn
  /// first.
  std::size_t triangles = (std::numeric_limits<std::size_t>::max)();

  friend bool operator==(const CoverWork&, const CoverWork&) = default;
};

/// What a frame by cover did, for a frame that does the same.
struct CoverBefore {
  CoverWork work;
  std::span<const std::uint32_t> idle;  ///< CullResult::idle, which must outlive the frame
};

/// The coarse picture of a frame by cover, and the budget of the frame. A frame goes from front to back and draws into the
/// picture what it sees. Once three quarters of the budget are spent, it draws no more, and asks what is left, large
/// subtrees first. Once all is spent, what is left is drawn unasked as far as it is in view. Nothing visible is culled,
/// whatever the budget.
struct CoverOptions {
  /// The work of drawing one triangle, in boxes that are asked. Frames of the models tried take 23 ns for a box and 334 ns
  /// for a triangle, and 0.1 ms beside that.
  static constexpr std::size_t kWorkOfTriangle = 16;

  /// The size in pixels, clamped to the limits above and then rounded up to multiples of 8. A larger picture hides more and
  /// costs more. With a budget of less than about six milliseconds, or as much work, it is smaller than this.
  int width = 576, height = 360;
  /// The most work: boxes that are asked, and kWorkOfTriangle for each triangle that is drawn into the picture. One that is
  /// drawn again with what touches it counts again. On every machine the same frame is the same. In a Scene, objects are all
  /// asked, because each is listed anyway; occluders have three quarters, and how far that goes also depends on the changes
  /// that the scene has had.
  std::size_t work = (std::numeric_limits<std::size_t>::max)();
  /// The most milliseconds, about: frames of the models tried take up to a quarter more, and what the view frustum alone
  /// takes. What is culled then depends on the machine's speed.
  double ms = std::numeric_limits<double>::infinity();
  /// To repeat a frame: what it did (repeated()). The limits above do not matter then.
  std::optional<CoverBefore> as_before = {};
};

/// How a frame is culled. Each option names the method that it is for; the other one ignores it.
struct CullOptions {
  /// By `automatic`, frames are by cover, and those of a view save work where it does not pay. What neither hides anything
  /// nor is hidden is idle in the next five frames: it is drawn unasked. Where frames hide less than a quarter of what is
  /// in view, or of little work less in proportion, later ones hide nothing, but for one in 48, until there is more to hide.
  /// Frames that take less than about 0.3 ms, and those without a view, are as by cover.
  Method method = Method::automatic;
  /// Cover. The coarse picture.
  CoverOptions cover = {};
  /// Frusta. n_occ, the most occluders that a frame uses; 0: view-frustum culling alone. The paper finds 5 to 10 worth their
  /// cost.
  std::size_t occluders = 8;
  /// Frusta. The most probes of a frame: candidates that hide nothing in it. What they would have hidden of the polygons
  /// drawn is counted, and the best become occluders in the next frame of the view. A probe costs less than an occluder.
  std::size_t probes = 8;
  /// Frusta. How occluders are chosen.
  Objective objective = {};
  /// Frusta. Where a shadow begins.
  kernel::Near shadow_near = kernel::Near::surface;
  /// Both methods. The arithmetic of the half-spaces and, with frusta, of the shadows of single occluders. With `plain`
  /// something visible may be culled.
  kernel::Arithmetic arithmetic = kernel::Arithmetic::certified;
  /// Frusta. The test of a box against the shadow of one occluder.
  kernel::Test test = kernel::Test::conservative;
  /// Both methods. By how much shadows are taken smaller than they are (ShadowMargin), as a share of the picture's height.
  /// 0: by nothing. For a rasteriser to draw the same pixels with and without culling, it must be at least the rasteriser's
  /// rounding of positions in the picture. REQUIRES: margin >= 0, which is not checked.
  double margin = 0;
  /// Frusta. Whether two chosen occluders that share an edge also hide together what neither hides alone. Always certified
  /// and exact, whatever `arithmetic` is. Of several eyes, and of an eye that is known up to rounding (most matrices), two
  /// hide no more together than each alone, and none are asked.
  bool unions = false;
  /// Frusta. On which threads candidates are sorted, shadows are made and the tree is traversed; nullptr: on the calling
  /// thread, as the traversal always is where a frame has pairs. The result is the same. The executor must live until the
  /// cull returns, and is not kept. What it throws is thrown on, and the frame draws everything then. Frames take less than
  /// a millisecond, so its threads should wait for work without sleeping; Executor::own_threads() takes longer to start.
  const Executor* executor = nullptr;
};

/// An occluder of a frame: one of the potential occluders, and its shadow.
struct Occluder {
  std::uint32_t index = 0;  ///< in the OccluderSet
  kernel::ShadowFrustum frustum;
  std::uint32_t hidden = 0;  ///< polygons in the subtrees culled by its shadow, alone or in a pair
};

/// Two occluders of a frame whose shadows are also tested as one union. `first` and `second` are indices in
/// CullResult::occluders, first < second.
struct ShadowPair {
  /// A frame has at most kMostOfEach * occluders.size() pairs; pairs of the occluders chosen first are preferred. Eight
  /// occluders may have all their 28 pairs. In the models tried eight have at most 8, and 64 have 67.
  static constexpr std::size_t kMostOfEach = 4;

  std::uint32_t first, second;
};

/// A subtree that is not drawn, and why. `node` is its root in Hierarchy::nodes().
struct Culled {
  static constexpr std::uint32_t kNone = (std::numeric_limits<std::uint32_t>::max)();

  enum class By { view, shadow, cover };
  std::uint32_t node = 0;
  By by = By::view;
  std::uint32_t index = 0;       ///< by view: in CullResult::view; by shadow: in CullResult::occluders; by cover: 0
  std::uint32_t second = kNone;  ///< by a pair of shadows: the other occluder's index in CullResult::occluders
};

/// The proof of a cull, to be stored. The planes that it refers to are in the frame.
struct Witness {
  Culled cull;
  /// A lower bound on the distance from the corners of the subtree's box to the half-space, or to the planes of the shadow,
  /// on the side that culls; model units. 0 if no bound is known: always for a cull by a pair or by a cover.
  double margin = 0;
};

/// A plane on which the lines of sight of several eyes are named by where they cross it: at point + x right + y up, where
/// up = right x normal. `right` and `up` are unit vectors, up to rounding; `normal` points away from the eyes.
struct FocusPlane {
  glm::dvec3 point{}, normal{}, right{};
};

/// A triangle of the fan of a polygon in Hierarchy::soup(): of the corners 0, corner and corner + 1 of its loop.
struct FanTriangle {
  std::uint32_t polygon, corner;

  auto operator<=>(const FanTriangle&) const = default;
};

struct CoverWindow;

/// Windows in a plane.
struct CoverLayer {
  FocusPlane focus{};
  std::vector<CoverWindow> windows;
};

/// The lines of sight that cross a FocusPlane at x0 <= x <= x1 and y0 <= y <= y1, and a sheet that all these lines meet:
/// triangles, modulo 2. Or they all cross a nearer plane in windows; then the sheet is empty.
struct CoverWindow : CoverLayer {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::vector<std::uint32_t> polygons;  ///< of which all triangles are in the sheet, ascending
  std::vector<FanTriangle> triangles;   ///< those of other polygons, ascending
};

/// What hides a subtree that was culled by cover, or a part of the subtree. Of a perspective camera with several eyes, the
/// windows say which of the polygons hide it together, and in which lines of sight: all those to the box cross the plane in
/// windows. A picture whose axes are not perpendicular has no such plane.
struct CoverWitness : CoverLayer {
  PolygonRange range;                   ///< what is hidden, in Hierarchy::soup()
  kernel::Aabb box;                     ///< holds the range; all of it is hidden
  std::vector<std::uint32_t> polygons;  ///< what hides it, in Hierarchy::soup(), ascending
};

struct CullStats {
  std::size_t nodes_visited = 0;                      ///< in a Scene: of the trees of occluders as well
  std::size_t view_tests = 0;                         ///< box against half-space
  std::size_t shadow_tests = 0;                       ///< box against shadow frustum
  std::size_t union_tests = 0;                        ///< box against two shadows as one union
  std::size_t probe_tests = 0;                        ///< box against the shadow of a probe
  std::size_t cover_tests = 0;                        ///< box against the coarse picture
  std::size_t cover_groups = 0, cover_triangles = 0;  ///< drawn into it: joined meshes, and their triangles
  std::size_t cover_groups_left = 0;                  ///< not drawn into it, because the budget was spent
  CoverWork cover_work;
  std::size_t unasked_polygons = 0;  ///< drawn unasked: the budget was spent, or they were idle; in no Scene
  /// Of shadow_tests and union_tests: decided by the exact stage. The number depends slightly on the instruction set,
  /// because the filters before that stage round differently. Neither any answer nor any other number does.
  std::size_t exact_shadow_tests = 0;
  std::size_t potential_occluders = 0, occluders_in_view = 0;  ///< of the region's list: all, and those in view
  std::size_t sort_kept = 0;                                   ///< sorted candidates that the frame before had sorted
  std::size_t sort_moves = 0;                                  ///< places that the insertion sort moved them by, summed
  std::size_t sort_comparisons = 0;                            ///< of candidates
  std::size_t choice_work = 0;  ///< of choosing among the sorted, in planes of shadows: bounded (README.md, Budgets)
  std::size_t silhouette_faces = 0, silhouette_faces_asked = 0;  ///< of polytopes: all, and those asked for their side
  /// `shadow_culled` counts culls by one shadow, by a pair and by a cover.
  std::size_t drawn_polygons = 0, view_culled_polygons = 0, shadow_culled_polygons = 0;
};

/// The result of one frame. Polygons and nodes are those of Hierarchy::soup() and Hierarchy::nodes().
/// 1. Every polygon is in exactly one range of `drawn` or in the subtree of exactly one element of `culled`.
/// 2. Both are in ascending order of their polygons.
struct CullResult {
  Method method = Method::frusta;   ///< frusta, or cover
  std::vector<PolygonRange> drawn;  ///< in the order of the leaves, neighbours merged
  std::vector<Culled> culled;       ///< in the order of the tree
  std::vector<HalfSpace> view;      ///< as append_view_frustum() has them
  std::vector<Occluder> occluders;  ///< in the order in which they were chosen; none by cover
  std::vector<ShadowPair> pairs;    ///< none unless CullOptions::unions
  std::vector<std::uint32_t> idle;  ///< by `automatic`: nodes that it took as idle, in the order in which it met them
  CullStats stats;
};

/// How a box would be found in the last frame of a view.
enum class Visibility {
  visible,      ///< neither of the other two could be proved
  occluded,     ///< all of it is in the shadow of one occluder, or of a pair of CullResult::pairs, or behind the cover
  out_of_view,  ///< all of it is beyond one half-space of the view
};

/// Options that repeat a frame by cover: with these, the same camera gives the same frame, however long it takes. `options`
/// are those of the frame, which must outlive their use.
[[nodiscard]] inline CullOptions repeated(const CullResult& frame, CullOptions options) {
  options.cover.as_before = {frame.stats.cover_work, frame.idle};
  return options;
}

}  // namespace occlude::culler
