// SPDX-License-Identifier: MIT
// The world of an engine: objects with boxes, and occluders that need not be what is drawn. Both come, go and move. Reading
// order: 14.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/occluder_mesh.h"

namespace occlude::culler {

/// What an id names.
enum class SceneKind : std::uint8_t { object, occluder };

/// Names one object or one occluder of one scene until it is removed; none by default. No two ids that a program ever gets
/// are equal, whatever scenes they are of and whatever they name. So the id of what was removed names nothing any more, and
/// an id names nothing in another scene. What it names, its generation and its scene are all in one number:
/// 28 bits slot, 20 bits generation, 1 bit SceneKind, 15 bits scene, of which none is 0.
template <SceneKind kOf>
class SceneId {
 public:
  static constexpr SceneKind kKind = kOf;
  static constexpr unsigned kSlotBits = 28, kGenerationBits = 20, kSceneBits = 15;

  SceneId() = default;
  /// For scenes. REQUIRES: each has no more than its bits; scene != 0.
  SceneId(std::uint32_t slot, std::uint32_t generation, std::uint32_t scene)
      : number_(std::uint64_t{scene} << kSceneAt | std::uint64_t{static_cast<std::uint8_t>(kKind)} << kKindAt |
                std::uint64_t{generation} << kGenerationAt | slot) {}

  /// For programs that keep numbers, and for other languages; 0 is none. Any other number than those of ids of this type
  /// names nothing.
  [[nodiscard]] static SceneId from_number(std::uint64_t number) {
    SceneId id;
    id.number_ = number;
    return id;
  }
  [[nodiscard]] std::uint64_t number() const { return number_; }

  [[nodiscard]] bool is_none() const { return number_ == 0; }
  /// A small number, unique among the objects, or the occluders, that are in the scene now. What is added takes the slot of
  /// what was removed, so an array of a caller's own that is indexed by slots stays short.
  [[nodiscard]] std::uint32_t slot() const { return field(0, kSlotBits); }
  [[nodiscard]] std::uint32_t generation() const { return field(kGenerationAt, kGenerationBits); }
  [[nodiscard]] std::uint32_t scene() const { return field(kSceneAt, kSceneBits); }
  /// That of the type, unless from_number() was given a number of the other kind.
  [[nodiscard]] SceneKind kind() const { return static_cast<SceneKind>(field(kKindAt, 1)); }

  friend auto operator<=>(const SceneId&, const SceneId&) = default;

 private:
  static constexpr unsigned kGenerationAt = kSlotBits, kKindAt = kGenerationAt + kGenerationBits, kSceneAt = kKindAt + 1;
  static_assert(kSceneAt + kSceneBits == 64);

  [[nodiscard]] std::uint32_t field(unsigned at, unsigned bits) const {
    return static_cast<std::uint32_t>(number_ >> at & ((std::uint64_t{1} << bits) - 1));
  }

  std::uint64_t number_ = 0;
};

using ObjectId = SceneId<SceneKind::object>;
using OccluderId = SceneId<SceneKind::occluder>;

/// How a frame of a scene is culled.
struct SceneOptions {
  CoverOptions cover = {};
  /// As CullOptions::margin: what a renderer rounds, as a share of the picture's height. Nothing is hidden if it is negative
  /// or not a number.
  double margin = 0;
  /// Objects and occluders take part if their mask and this one have a bit in common.
  std::uint32_t mask = ~std::uint32_t{0};
  /// Objects that look smaller are left out (DrawnObject::size). They are counted in SceneStats::too_small, and nothing is
  /// said of their visibility.
  float least_size = 0;
  /// Whether the objects to draw are listed from front to back. This takes time n log n.
  bool is_front_to_back = false;
  /// Whether only occluders hide that stand still (OccluderOptions::moves), for a frame that later ones are held against.
  /// With a `least_size` those that an object draws hide nothing either: seen from elsewhere it may be too small.
  bool is_to_be_held = false;
  /// Whether the frames of a view save work where it does not pay. One in six looks at everything, and the others leave out
  /// the occluders that hid nothing then, unless they have changed since. Where less than a quarter of the objects in view
  /// was hidden, or in frames of little work less in proportion, later frames hide nothing, and one in 48 looks. A view that
  /// turns or moves far looks at once. Nothing is saved in frames that take less than about 0.3 ms, are of several eyes or
  /// are to be held. Otherwise a frame does not depend on those before it.
  bool is_adaptive = true;
  /// On which threads the objects are tested; nullptr: on the calling thread. Occluders are drawn on the calling thread. The
  /// result is the same, and so is the order of the list. What it throws is thrown on, and all objects that take part are
  /// drawn then.
  const Executor* executor = nullptr;
};

/// An object to draw, and how it looks.
struct DrawnObject {
  ObjectId id;
  /// No less than the height and the width of its box in the picture, as a share of the picture's height: what a level of
  /// detail depends on. Infinity for a box that reaches before the near plane, and for one that is always drawn.
  float size;
  /// About the square of the distance from the eye to its box, or how far along the line of sight the box begins if rays
  /// are parallel. -infinity for what is always drawn.
  float distance;
};

struct SceneStats {
  std::size_t drawn = 0;        ///< objects to draw
  std::size_t out_of_view = 0;  ///< beyond a plane of the view
  std::size_t hidden = 0;       ///< behind occluders
  std::size_t too_small = 0;    ///< smaller than SceneOptions::least_size
  std::size_t occluders = 0;    ///< of which at least a part was drawn into the coarse picture; a weld counts as one
  CullStats work;               ///< what the descents did
};

/// The result of one frame. Each object whose mask has a bit of SceneOptions::mask is in `drawn` exactly once, or is counted
/// in exactly one of the three numbers that follow it in SceneStats.
struct SceneResult {
  std::vector<DrawnObject> drawn;  ///< in an order that means nothing, unless SceneOptions::is_front_to_back
  std::vector<HalfSpace> view;     ///< as append_view_frustum() has them
  SceneStats stats;
  /// With SceneOptions::is_adaptive: occluders that hid nothing when a frame of the view last looked at everything, though
  /// their polygons were looked at. They cost more than they hide. In ascending order of slots. After the first frame of a
  /// view, only where there is work to save.
  std::vector<OccluderId> idle_occluders;
};

/// What became of an object in a frame, and why.
struct ObjectFate {
  enum class Reason {
    drawn,
    always_drawn,  ///< it has no place, or ObjectOptions::is_always_drawn
    out_of_view,   ///< its box is beyond SceneResult::view[plane]
    hidden,        ///< `by` hide its box
    too_small,     ///< it looks smaller than SceneOptions::least_size
    in_no_layer,   ///< it is disabled, or has no bit of SceneOptions::mask
    not_in_scene,  ///< there was no such object at the last update
  };
  /// A polygon that hides.
  struct Hiding {
    OccluderId occluder;                ///< that has it, whether it is welded to others or not
    std::uint32_t polygon = 0;          ///< its number in the soup of the occluder's mesh
    std::vector<kernel::Vec3> corners;  ///< where they are in the scene
  };

  Reason reason = Reason::not_in_scene;
  std::uint32_t plane = 0;
  std::vector<Hiding> by = {};  ///< each once; together they hide the box, beyond the near plane of the camera
};

/// The proof of a cull.
struct ObjectWitness {
  ObjectId object;
  /// All of it is hidden, or out of view. Holds the box of the object: it is the one that the scene keeps, the axis-aligned
  /// one around it, or, in frames of several eyes, one around several objects that were found to be hidden together.
  Box box;
  ObjectFate fate;  ///< hidden or out_of_view
};

/// One camera, and its last frame.
/// 1. One thread at a time may cull with it. Different views may be culled at once.
/// 2. It may be used with any scene at any time. A frame does not depend on those before it, but for
///    SceneOptions::is_adaptive.
/// 3. After its first frame nothing more is allocated. Exceptions: culler/README.md, Budgets.
/// 4. A view that was moved from may only be destroyed or assigned to.
class SceneView {
 public:
  SceneView();
  ~SceneView();
  SceneView(SceneView&&) noexcept;
  SceneView& operator=(SceneView&&) noexcept;

  /// The last frame; empty before the first. Valid until the next frame of this view.
  [[nodiscard]] const SceneResult& result() const;
  /// Whether any box would be visible in the last frame, as View::visibility().
  [[nodiscard]] Visibility visibility(const Box& box) const;
  /// As View::holds_for(), of the scene as it was in the last frame.
  [[nodiscard]] bool holds_for(const Camera& camera) const;
  [[nodiscard]] bool holds_for(const MatrixCamera& camera) const;

  struct Memory;  ///< scene/scene_frame.h

 private:
  friend Memory& memory_of(const SceneView& view);

  std::unique_ptr<Memory> memory_;
};

struct ObjectOptions {
  /// Whether it is moved often: those that are cost time in each update(), the others only when they are moved.
  bool moves = false;
  /// Whether it is in every frame whose mask it has, wherever it is.
  bool is_always_drawn = false;
  /// Layers: see SceneOptions::mask.
  std::uint32_t mask = ~std::uint32_t{0};
};

struct OccluderOptions {
  /// As ObjectOptions::moves.
  bool moves = false;
  /// Whether it hides only with the polygons that look counter-clockwise from the eye, for renderers that cull back faces.
  /// An eye inside a solid whose polygons turn their fronts outwards then sees out. A mirrored placement turns no polygon
  /// over.
  bool is_one_sided = false;
  /// Layers: see SceneOptions::mask.
  std::uint32_t mask = ~std::uint32_t{0};
  /// The object that draws it, if any, which is in the scene. It hides nothing in frames without that object: once the
  /// object is removed, and while it is disabled, in no layer of the frame or too small.
  ObjectId object = {};
  /// A number of the caller's, 0: none. Occluders with the same weld, and all other options the same, hide as one mesh does:
  /// where corners of theirs are at the same place, to the bit, their polygons share edges, and no seam is left between
  /// occluders that only touch. Each update() in which one of them changed prepares a mesh of all that are enabled, about 2
  /// microseconds for each triangle, and allocates. So a weld is for what stands and changes together, such as the walls of
  /// a building or a few tiles of terrain.
  std::uint32_t weld = 0;
};

/// **What culling promises.** An object is left out only if one of these holds of its box:
/// 1. it is exactly beyond a plane of the view, which is no tighter than the renderer's;
/// 2. it is wholly behind polygons of the occluders: each straight line from the eye to a point of the box meets one of them
///    strictly before that point, and beyond the near plane;
/// 3. it is too small, disabled or in no layer of the frame, as the caller asked.
/// So nothing visible is left out if
/// 1. each box holds everything that is drawn of its object, and
/// 2. every point of an occluder is on or inside something opaque that is drawn unless this scene hides it.
/// Vertices of occluders are where placed, in doubles: a few roundings beside the exact place. For a renderer that rounds
/// more there is SceneOptions::margin.
///
/// **Changes** show at the next update(); until then views see the scene as it was.
///
/// **Boxes** may have any numbers but NaN. A box that reaches beyond 2^100 has no place, and its object is always drawn.
/// Numbers nearer to zero than 2^-100 are rounded so that the box becomes no smaller. Of an oriented box the scene keeps one
/// that holds it, exactly, and is wider by a few 500ths of the axis-aligned box around both. Boxes of usual shape become
/// half a hundredth wider; what is thinner than that, such as a wall, has its thickness from these 500ths.
///
/// **Threads.** Const calls may run on several threads at once, each with a view of its own. Changes may be made while
/// others cull, one change at a time; but move() of different objects that have ObjectOptions::moves may run on several
/// threads at once. update() must run alone.
///
/// **Errors.** std::invalid_argument, with the place and the reason, for an id of nothing that is in the scene, such as one
/// of another scene, for a box with a NaN or with min > max, for a placement with a number that is not finite or one that
/// takes its mesh beyond 2^100, and for a null mesh. What throws changes nothing. While the processor does not round to
/// nearest, cull(), why(), SceneView::visibility() and making an OccluderMesh throw std::runtime_error. Changes and update()
/// do not check it: a program that changes the mode must restore it before them. But an update() that prepares a weld throws
/// it, and std::length_error for a weld of more than 2^31 sides of triangles; views then see the scene as it was.
/// std::runtime_error is also thrown where ids are used up: by 32,767 scenes at once, and by 2^28 objects or occluders in
/// one.
///
/// A scene that was moved from may only be destroyed or assigned to.
class Scene {
 public:
  Scene();
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  ObjectId add(const Box& box, const ObjectOptions& options = {});
  /// Adds an object for each box, and writes their ids to `ids`. Objects that are near each other are best added together.
  /// REQUIRES: as many ids as boxes.
  void add(std::span<const Box> boxes, const ObjectOptions& options, std::span<ObjectId> ids);
  void remove(ObjectId object);
  /// One that is named twice counts once.
  void remove(std::span<const ObjectId> objects);
  void move(ObjectId object, const Box& box);
  /// REQUIRES: as many boxes as objects.
  void move(std::span<const ObjectId> objects, std::span<const Box> boxes);
  void set_enabled(ObjectId object, bool is_enabled);
  void set_mask(ObjectId object, std::uint32_t mask);
  [[nodiscard]] bool contains(ObjectId object) const;
  /// Why the scene refuses the id; empty if it has the object.
  [[nodiscard]] std::string fault(ObjectId object) const;

  /// The mesh is shared, and kept for as long as an occluder has it.
  OccluderId add(std::shared_ptr<const OccluderMesh> mesh, const Placement& placement = {},
                 const OccluderOptions& options = {});
  /// Adds an occluder for each placement, and writes their ids to `ids`. REQUIRES: as many ids as placements.
  void add(const std::shared_ptr<const OccluderMesh>& mesh, std::span<const Placement> placements,
           const OccluderOptions& options, std::span<OccluderId> ids);
  void remove(OccluderId occluder);
  /// One that is named twice counts once.
  void remove(std::span<const OccluderId> occluders);
  void move(OccluderId occluder, const Placement& placement);
  /// REQUIRES: as many placements as occluders.
  void move(std::span<const OccluderId> occluders, std::span<const Placement> placements);
  void replace(OccluderId occluder, std::shared_ptr<const OccluderMesh> mesh);
  void set_enabled(OccluderId occluder, bool is_enabled);
  void set_mask(OccluderId occluder, std::uint32_t mask);
  [[nodiscard]] bool contains(OccluderId occluder) const;
  [[nodiscard]] std::string fault(OccluderId occluder) const;

  /// Makes all changes since the last update. Takes time in proportion to what changed, and to the number of objects with
  /// ObjectOptions::moves if one of them moved; likewise for occluders. Large tiles, of thousands of objects that stand
  /// still, and meshes of welds are built by the executor. After the scene has had its largest size, nothing more is
  /// allocated: culler/README.md, Budgets. If memory runs out, std::bad_alloc is thrown, and the scene may only be
  /// destroyed.
  void update(const Executor& executor = {});

  /// What to draw for the next frame of this view. Returns view.result(). Throws std::invalid_argument for a camera with a
  /// fault(); the view then keeps its last frame.
  const SceneResult& cull(const Camera& camera, const SceneOptions& options, SceneView& view) const;
  const SceneResult& cull(const MatrixCamera& camera, const SceneOptions& options, SceneView& view) const;

  /// Whether frames of this camera can be held against the last frame of `held`:
  /// 1. that frame holds for the camera (SceneView::holds_for()), and SceneOptions::is_to_be_held was set;
  /// 2. `options` have its mask and least_size;
  /// 3. no update() since then has removed, moved, replaced, disabled or masked anew an occluder that stands still, or
  ///    removed, disabled or masked anew an object that draws an occluder;
  /// 4. the scene reaches no farther from its eye than twice as far as then.
  /// Throws as cull().
  [[nodiscard]] bool holds(const SceneView& held, const Camera& camera, const SceneOptions& options) const;
  [[nodiscard]] bool holds(const SceneView& held, const MatrixCamera& camera, const SceneOptions& options) const;
  /// A frame in which nothing is drawn into a coarse picture: what hid in the last frame of `held` hides. Each object is
  /// asked where it is now, so that objects may come, go and move. Occluders that move hide nothing, and new ones not yet.
  /// Otherwise as cull(), but nothing is known of why() and no witness appended for such a frame, and in it
  /// SceneView::visibility() knows of no occluder. Throws std::invalid_argument unless holds(), and if `held` is `view`.
  const SceneResult& cull(const Camera& camera, const SceneOptions& options, const SceneView& held, SceneView& view) const;
  const SceneResult& cull(const MatrixCamera& camera, const SceneOptions& options, const SceneView& held,
                          SceneView& view) const;

  /// What became of these objects, all of them in the scene, in the last frame of the view. REQUIRES, not checked: `camera`
  /// and `options` are those of that frame. Takes the time of some frames, and allocates. Throws as cull(), and
  /// std::invalid_argument for an object that is not in the scene, and if the frame is not of this scene or the scene was
  /// updated since.
  [[nodiscard]] std::vector<ObjectFate> why(const Camera& camera, const SceneOptions& options, const SceneView& view,
                                            std::span<const ObjectId> objects) const;
  [[nodiscard]] std::vector<ObjectFate> why(const MatrixCamera& camera, const SceneOptions& options, const SceneView& view,
                                            std::span<const ObjectId> objects) const;

  /// Appends the proof of every cull of that frame: an element for each object that SceneStats counts as hidden or out of
  /// view. One that is both is proved to be out of view. Of a camera with several eyes, the same polygons hide an object
  /// from each of them. `camera`, `options`, the time it takes and what it throws: as why().
  void append_witnesses(const Camera& camera, const SceneOptions& options, const SceneView& view,
                        std::vector<ObjectWitness>& witnesses) const;
  void append_witnesses(const MatrixCamera& camera, const SceneOptions& options, const SceneView& view,
                        std::vector<ObjectWitness>& witnesses) const;

  /// Objects and occluders that are in the scene, disabled ones included.
  [[nodiscard]] std::size_t objects() const;
  [[nodiscard]] std::size_t occluders() const;
  /// Bytes of memory that the scene holds for objects, without its occluders. Beside 180 kB for all, an object
  /// takes at most 122 bytes if it stands still, and 240 if it moves, whether its box is axis-aligned or oriented. Room of
  /// what is gone waits for what comes; where tiles of many sizes come and go, it may be half as much again.
  [[nodiscard]] std::size_t object_bytes() const;

 private:
  friend struct SceneAccess;  // scene/scene_access.h

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace occlude::culler
