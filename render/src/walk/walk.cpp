// SPDX-License-Identifier: MIT
#include "occlude/render/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>

#include "comparison.h"
#include "occlude/kernel/overlap.h"
#include "occlude/render/errors.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/output_file.h"
#include "occlude/render/preprocess_file.h"
#include "occlude/render/progress.h"
#include "occlude/render/scene_renderer.h"
#include "occlude/render/witness.h"
#include "plates.h"
#include "report.h"
#include "summary.h"

namespace occlude::render {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// On about this many frames of a walk the whole model is drawn for reference and the operations are counted: enough to
/// meet every part of a path, few enough that it costs little.
constexpr std::size_t kReferenceFrames = 48;

/// The context and what draws in it; nothing when the walk does not render.
struct Stage {
  std::unique_ptr<OffscreenContext> context;
  std::unique_ptr<SceneRenderer> renderer;
};

class Walker {
 public:
  Walker(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options, SceneRenderer* renderer)
      : culler_(culler), path_(path), options_(options), renderer_(renderer) {
    view_only_.occluders = 0;
    view_only_.arithmetic = options.cull.arithmetic;
  }

  /// Culls, draws and compares one frame; `view` is that of the frames before.
  FrameRecord frame(std::size_t frame, bool reference, culler::View& view) {
    FrameRecord record;
    record.frame = frame;
    const culler::Camera camera = path_.camera(frame, aspect(options_));
    Picture full, picture;
    const auto with_view_frustum = [&] {
      timed(camera, view_only_, view_without_, record.view_frustum_cull_ms, record.view_frustum_frame_ms, full);
    };
    const auto with_occlusion = [&] { timed(camera, options_.cull, view, record.cull_ms, record.frame_ms, picture); };
    // The order alternates so that neither method always finds the caches as the other left them.
    if (frame % 2 == 0) {
      with_view_frustum();
      with_occlusion();
    } else {
      with_occlusion();
      with_view_frustum();
    }
    const culler::CullResult& culled = view.result();
    record.view_frustum_polygons = view_without_.result().stats.drawn_polygons;
    record.rendered_polygons = culled.stats.drawn_polygons;
    record.occluders = culled.occluders.size();
    record.stats = culled.stats;
    if (!renderer_) return record;
    if (reference) {
      const PolygonRange all{0, static_cast<std::uint32_t>(culler_.hierarchy().soup().size())};
      full = draw(camera, std::span(&all, 1));
    }
    compare(full, picture, culler_, camera, culled, record);
    return record;
  }

 private:
  void timed(const culler::Camera& camera, const culler::CullOptions& options, culler::View& view, double& cull_ms,
             double& frame_ms, Picture& picture) const {
    const Clock::time_point start = Clock::now();
    const culler::CullResult& result = culler_.cull(camera, options, view);
    cull_ms = milliseconds_since(start);
    if (renderer_) {
      const Layer layer{result.drawn, std::nullopt};
      renderer_->draw(camera, std::span(&layer, 1));
      frame_ms = milliseconds_since(start);
      picture = {renderer_->image(), renderer_->item_buffer(camera, result.drawn)};
    }
  }

  Picture draw(const culler::Camera& camera, std::span<const PolygonRange> ranges) const {
    const Layer layer{ranges, std::nullopt};
    renderer_->draw(camera, std::span(&layer, 1));
    return {renderer_->image(), renderer_->item_buffer(camera, ranges)};
  }

  const culler::Culler& culler_;
  const CameraPath& path_;
  const WalkOptions& options_;
  SceneRenderer* renderer_;
  culler::CullOptions view_only_;
  culler::View view_without_;  ///< with view-frustum culling alone
};

/// Counts the operations of the frame's shadow tests and shows these tests to whoever asked for them.
kernel::Operations visit_shadow_tests(const culler::Culler& culler, std::size_t frame, const culler::CullResult& culled,
                                      const WalkOptions& options) {
  const culler::PolygonSoup& soup = culler.hierarchy().soup();
  kernel::Operations total;
  culler.visit_shadow_tests(culled, options.cull, [&](const culler::Occluder& occluder, const culler::Box& box) {
    total += std::visit(
        [&](const auto& kind) {
          return kernel::count_operations(occluder.frustum, kind, options.cull.arithmetic, options.cull.test);
        },
        box);
    if (!options.on_shadow_test) return;
    options.on_shadow_test(
        {frame, occluder.frustum.viewpoint(), culler.occluders().geometry(soup, occluder.index), options.cull.near, box});
  });
  return total;
}

/// A folder that exists from now on; if it is new and nothing has come into it, it goes again.
class Folder {
 public:
  explicit Folder(std::filesystem::path path) : path_(std::move(path)) {
    if (path_.empty()) throw InputError("no folder named to write to");
    std::error_code error;
    is_new_ = std::filesystem::create_directories(path_, error);
    if (error) throw InputError(fmt::format("{}: cannot create the folder: {}", path_.string(), error.message()));
  }
  ~Folder() {
    std::error_code not_empty;
    if (is_new_) std::filesystem::remove(path_, not_empty);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

 private:
  std::filesystem::path path_;
  bool is_new_ = false;
};

/// Plates of an earlier walk would be taken for this one's.
void remove_old_plates(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("frame_") && (name.ends_with("_view.png") || name.ends_with("_outside.png"))) {
      std::filesystem::remove(entry.path());
    }
  }
}

}  // namespace

std::vector<std::size_t> frames_of(const CameraPath& path, const WalkOptions& options) {
  std::vector<std::size_t> frames;
  const std::size_t end = std::min(options.end, path.frames);
  for (std::size_t f = options.begin; f < end; f += std::min(options.step, end - f)) frames.push_back(f);
  if (frames.empty()) {
    throw InputError(fmt::format("no frame to walk: the path has frames 0 to {}", path.frames - 1));
  }
  return frames;
}

WalkResult walk(const culler::PolygonSoup& soup, const CameraPath& path, const WalkOptions& options,
                const std::string& model_name, const std::filesystem::path& directory) {
  if (soup.size() < 2) {
    throw InputError(fmt::format("{}: one polygon only: nothing can hide behind another", model_name));
  }
  const std::vector<std::size_t> frames = frames_of(path, options);
  const Folder folder(directory), plates_folder(directory / "plates");
  // All files are opened before the work and committed after it: what cannot be written is known at once.
  OutputFile csv(directory / "frames.csv"), report(directory / "report.html"), summary_file(directory / "summary.json");
  std::optional<OutputFile> witness;
  if (options.witness) witness.emplace(*options.witness);

  WalkResult result;
  result.polygons = soup.size();
  result.triangles = soup.indices.size() - 2 * soup.size();
  const Clock::time_point start = Clock::now();
  const culler::Culler culler = make_culler(soup, options.build, options.preprocess);
  result.preprocess_s = milliseconds_since(start) / 1000;
  result.build = culler.config();

  Stage stage;
  if (options.render) {
    stage.context = make_offscreen_context();
    stage.renderer = std::make_unique<SceneRenderer>(culler.hierarchy().soup(), options.width, options.height);
    result.renderer = stage.context->description();
  }
  Walker walker(culler, path, options, stage.renderer.get());
  const std::size_t reference_step = std::max<std::size_t>(1, frames.size() / kReferenceFrames);
  {
    culler::View warm_up;  // the first picture pays for what the renderer prepares once
    static_cast<void>(walker.frame(frames.front(), false, warm_up));
  }
  culler::View view;
  std::vector<std::string> lines;
  {
    Progress progress("frame", frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      check_interrupt();
      const bool reference = i % reference_step == 0;
      result.frames.push_back(walker.frame(frames[i], reference, view));
      const culler::CullResult& culled = view.result();
      const culler::Camera camera = path.camera(frames[i], aspect(options));
      if (reference) result.operations += visit_shadow_tests(culler, frames[i], culled, options);
      if (reference && options.render) ++result.reference_frames;
      if (witness) {
        lines.clear();
        append_witnesses(lines, frames[i], camera, culler, culled, options.cull.near);
        for (const std::string& line : lines) witness->stream() << line << '\n';
        result.witnesses += lines.size();
      }
      progress.update(i + 1);
    }
  }

  std::vector<DrawnPlate> plates;
  if (options.render) {
    stage.renderer.reset();
    plates = draw_plates(culler, path, result.frames, options.cull);
  }
  check_interrupt();
  remove_old_plates(directory / "plates");
  for (const DrawnPlate& drawn : plates) {
    write_png(directory / "plates" / drawn.plate.file, drawn.image);
    result.plates.push_back(drawn.plate);
  }
  const nlohmann::ordered_json summary = summarise(result, options, model_name);
  csv.write(frames_csv(result));
  report.write(report_html(result, summary));
  summary_file.write(summary.dump(2) + "\n");
  if (witness) witness->commit();
  csv.commit();
  report.commit();
  summary_file.commit();
  return result;
}

}  // namespace occlude::render
