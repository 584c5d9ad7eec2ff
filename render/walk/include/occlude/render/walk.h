// SPDX-License-Identifier: MIT
// The paper's experiment (section 6.3): a path through a model, with view-frustum culling alone and with occlusion culling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frusta/potential_occluders.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/operations.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/image.h"
#include "occlude/render/model.h"

namespace occlude::render {

/// One shadow test that the culler asked of the kernel.
struct ShadowTest {
  std::size_t frame = 0;
  kernel::Viewpoint viewpoint;
  culler::OccluderGeometry occluder;
  kernel::Near near = kernel::Near::surface;
  culler::Box box;
};

struct WalkOptions {
  int width = 640, height = 360;  ///< size of the picture, pixels
  std::size_t begin = 0, end = SIZE_MAX,
              step = 1;  ///< frames drawn, compared and counted: begin, begin + step, ... below end
  ReadOptions read;
  culler::CullOptions cull;
  /// How far ahead of the eye the regions reach that frames are held by, model units; 0: each frame is culled for itself.
  double hold = 0;
  culler::BuildConfig build;
  std::filesystem::path preprocess;                       ///< store of the model, used instead of `build`; or empty
  bool render = true;                                     ///< draw and compare; if false, only culling is measured
  bool plates = true;                                     ///< of some frames, if they are drawn
  std::optional<std::filesystem::path> witness;           ///< file for the proofs of all culls (JSON Lines)
  std::optional<std::filesystem::path> log;               ///< file for what each frame drew, for `occlude audit`
  std::function<void(const ShadowTest&)> on_shadow_test;  ///< called for each test on about 48 frames
};

/// Width over height of the pictures.
[[nodiscard]] inline double aspect(const WalkOptions& options) {
  return static_cast<double>(options.width) / options.height;
}

/// The culler of a walk, prepared for its method: from the store if one is named, else built now. Throws InputError as
/// read_store() does, also for a store of another model, and for oriented boxes in a walk that holds, and Interrupted on
/// Ctrl-C.
[[nodiscard]] culler::Culler make_culler(culler::PolygonSoup soup, const WalkOptions& options);

/// A model's file before it is prepared. A store is opened only by make_culler().
struct ModelFile {
  /// Reads the polygons unless the file is a store. Throws InputError as read_model() and is_store().
  explicit ModelFile(std::filesystem::path file, const ReadOptions& options = {});

  std::filesystem::path path;
  std::optional<culler::PolygonSoup> soup;  ///< none of a store
  ModelNotes notes;
};
/// The culler of a walk through this model; of a store, the culler in it.
[[nodiscard]] culler::Culler make_culler(ModelFile model, const WalkOptions& options);

/// Throws InputError for a model with so few polygons that there is nothing to cull. walk() does so, but only after the
/// model was prepared.
void require_walkable(std::size_t polygons, const std::string& model_name);

/// The frames of the path that a walk counts. Those between are only culled, because later frames depend on them. Throws
/// InputError if there are none.
[[nodiscard]] std::vector<std::size_t> frames_of(const CameraPath& path, const WalkOptions& options);

/// The step between the reference frames in a walk of `frames` frames. On these the whole model is drawn for reference, and
/// operations are counted.
[[nodiscard]] std::size_t reference_step(std::size_t frames);

/// The figures of one frame. Times are in milliseconds.
struct FrameRecord {
  std::size_t frame = 0;
  std::size_t view_frustum_polygons = 0;  ///< drawn with view-frustum culling alone
  std::size_t rendered_polygons = 0;      ///< drawn with occlusion culling
  std::size_t visible_polygons = 0;       ///< with a pixel in the item buffer
  double view_frustum_cull_ms = 0, view_frustum_frame_ms = 0;
  double cull_ms = 0, frame_ms = 0;
  /// The same by the time of the processor, of all threads of the program.
  double view_frustum_frame_processor_ms = 0, cull_processor_ms = 0, frame_processor_ms = 0;
  bool is_occlusion_first = false;  ///< the two methods take turns in going first
  double visible_frame_ms = 0;      ///< time to draw only the visible polygons, without culling
  double witness_ms = 0;            ///< time to keep the proofs of all culls in memory, on top of cull_ms
  /// Of a walk that holds: the number of the region that held for it, from 1; 0: it was culled for itself.
  std::size_t region = 0;
  std::size_t occluders = 0;
  culler::CullStats stats;
  /// Pixels at which the pictures of the two methods differ, and those of them explained by the renderer's rounding of
  /// vertices to 1/256 pixel: the centre of the pixel is that near to the silhouette of the occluder.
  std::size_t wrong_pixels = 0, snapped_pixels = 0;
  /// Culled polygons that have a pixel in the item buffer which this rounding does not explain.
  std::size_t false_culls = 0;
};

/// A region of eyes that was culled for frames of a walk that holds.
struct RegionRecord {
  std::size_t frame = 0;  ///< the first
  double cull_ms = 0;
  glm::dvec3 center{};
  culler::EyeRegion eyes;  ///< relative to the centre
};

struct Plate {
  std::string file;  ///< name within plates/
  std::string caption;
};

struct WalkResult {
  std::size_t polygons = 0, triangles = 0;  ///< of the model; each piece of a face counts
  std::size_t see_through_polygons = 0;     ///< of the model
  culler::BuildConfig build;                ///< how the model was prepared: by the options or in its store
  double region = 0;                        ///< how far from the path eyes may be, for which each frame holds
  std::vector<FrameRecord> frames;
  std::vector<RegionRecord> regions;  ///< in their order; those of frames that are not counted, too
  /// For each frame why it drew what is hidden; empty if the walk does not render.
  std::vector<culler::MissedReasons::Counts> missed;
  std::size_t reference_frames = 0;  ///< frames whose item buffer was drawn from the whole model, without culling
  std::size_t witnesses = 0;
  kernel::Operations operations;  ///< of the shadow tests on the reference frames, in plain arithmetic
  double preprocess_s = 0;
  std::optional<double> load;  ///< of the machine when the walk began (load_of_machine()), if it is known
  std::string renderer;        ///< the driver's own name for itself
};

/// A counted frame.
struct ShownFrame {
  const FrameRecord& record;
  const culler::Camera& camera;
  const culler::CullResult& culled;
  std::span<const culler::CoverWitness> covers;  ///< what hides everything that was culled by cover
  const std::vector<std::uint32_t>* visible;     ///< polygons with a pixel, ascending; null if the walk does not render
  const culler::MissedReasons::Answers* missed;  ///< of what is drawn, but not visible; null if the walk does not render
};

/// Receives what a walk shows and proves while it runs.
class WalkOutput {
 public:
  virtual ~WalkOutput() = default;
  /// The prepared model, before its first frame. It stays as it is until walk() returns.
  virtual void add_model(const culler::Culler& culler) = 0;
  /// In the order of the walk.
  virtual void add_frame(const ShownFrame& frame) = 0;
  /// The proof of one cull, a line of JSON without line break. Called only if WalkOptions names a witness file.
  virtual void add_witness(std::string_view line) = 0;
  virtual void add_plate(const Plate& plate, const Image& image) = 0;
};

/// Walks the path. The result has no preprocess_s. Throws InputError for fewer than two polygons or an empty frame range,
/// Interrupted on Ctrl-C. REQUIRES: the culler is that of make_culler() with these options.
[[nodiscard]] WalkResult walk(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options,
                              const std::string& model_name, WalkOutput& output);

}  // namespace occlude::render
