// SPDX-License-Identifier: MIT
// The paper's experiment (section 6.3): a path through a model, with view-frustum culling alone and with occlusion culling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/kernel/operations.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/image.h"

namespace occlude::render {

/// A question that the culler asked the kernel.
struct ShadowTest {
  std::size_t frame = 0;
  kernel::Viewpoint viewpoint;
  culler::OccluderGeometry occluder;
  kernel::Near near = kernel::Near::surface;
  culler::Box box;
};

/// Pixels by which shadows must be taken smaller for a picture to be the same with and without what they hide. The
/// rasteriser moves a border by up to 1/512 pixel on each axis, sqrt(2)/512; those of the occluder and of what it hides may
/// move towards each other, 0.0055 in all. Depths recede by up to 1/256 (scene_renderer.cpp): where the near side of the
/// shadow is, the occluder's are out by sqrt(2)/512 + 1/256 = 0.0067.
inline constexpr double kPixelMargin = 1.0 / 128;

struct WalkOptions {
  int width = 640, height = 360;  ///< of the picture, pixels
  std::size_t begin = 0, end = SIZE_MAX,
              step = 1;  ///< frames drawn, compared and counted: begin, begin + step, ... below end
  culler::CullOptions cull;
  culler::BuildConfig build;
  std::filesystem::path preprocess;                       ///< of `occlude preprocess`, used instead of `build`; or empty
  bool render = true;                                     ///< draw and compare; without it only culling is measured
  std::optional<std::filesystem::path> witness;           ///< where to write the proof of every culled subtree (JSON Lines)
  std::function<void(const ShadowTest&)> on_shadow_test;  ///< called for every one of some 48 frames, if given
};

/// Width over height of the pictures.
[[nodiscard]] inline double aspect(const WalkOptions& options) {
  return static_cast<double>(options.width) / options.height;
}

/// The culler of a walk, with all that its method needs: from the preprocess file if one is named, else built now. Throws
/// InputError as read_preprocess(), also for arrays that cannot be of this model, Interrupted on Ctrl-C.
[[nodiscard]] culler::Culler make_culler(const culler::PolygonSoup& soup, const WalkOptions& options);

/// The frames that a walk of this path counts; those between are culled, for what comes after them. Throws InputError when
/// there are none.
[[nodiscard]] std::vector<std::size_t> frames_of(const CameraPath& path, const WalkOptions& options);

/// Every so many frames of a walk is one of the few of which more is asked: the whole model is drawn for reference, and
/// operations and reasons are counted.
[[nodiscard]] std::size_t reference_step(std::size_t frames);

/// One frame. Times in milliseconds, polygons of the model.
struct FrameRecord {
  std::size_t frame = 0;
  std::size_t view_frustum_polygons = 0;  ///< drawn with view-frustum culling alone
  std::size_t rendered_polygons = 0;      ///< drawn with occlusion culling
  std::size_t visible_polygons = 0;       ///< with a pixel in the item buffer
  double view_frustum_cull_ms = 0, view_frustum_frame_ms = 0;
  double cull_ms = 0, frame_ms = 0;
  double visible_frame_ms = 0;  ///< drawing only the polygons with a pixel in the item buffer, culling aside
  double witness_ms = 0;        ///< that keeping the proof of every cull in memory takes on top of cull_ms
  std::size_t occluders = 0;
  culler::CullStats stats;
  /// Pixels at which the pictures of the two methods differ, and those of them that the renderer's rounding of vertices to
  /// 1/256 pixel explains: the pixel's centre is as near as that to the silhouette of the occluder.
  std::size_t wrong_pixels = 0, snapped_pixels = 0;
  /// Culled polygons with a pixel in the item buffer that snapping does not explain.
  std::size_t false_culls = 0;
};

struct Plate {
  std::string file;  ///< name within plates/
  std::string caption;
};

struct WalkResult {
  std::size_t polygons = 0, triangles = 0;  ///< of the model
  culler::BuildConfig build;                ///< how it was prepared, by the options or the preprocess file
  std::vector<FrameRecord> frames;
  std::size_t reference_frames = 0;  ///< frames whose item buffer was drawn from the whole model, without any culling
  std::size_t witnesses = 0;
  kernel::Operations operations;  ///< of the shadow tests on the reference frames, plain arithmetic
  double preprocess_s = 0;
  std::string renderer;  ///< as the driver names itself
};

/// Takes what a walk makes on its way.
class WalkOutput {
 public:
  virtual ~WalkOutput() = default;
  /// The proof of one cull, a line of JSON without its end. Only where WalkOptions names a witness file.
  virtual void add_witness(std::string_view line) = 0;
  virtual void add_plate(const Plate& plate, const Image& image) = 0;
};

/// Walks the path. Throws InputError for fewer than two polygons or an empty frame range, Interrupted on Ctrl-C.
[[nodiscard]] WalkResult walk(const culler::PolygonSoup& soup, const CameraPath& path, const WalkOptions& options,
                              const std::string& model_name, WalkOutput& output);

}  // namespace occlude::render
