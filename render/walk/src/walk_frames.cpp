// SPDX-License-Identifier: MIT
#include "occlude/render/walk_frames.h"

#include <algorithm>

#include "comparison.h"
#include "model/append_range.h"
#include "occlude/render/progress.h"
#include "occlude/render/stopwatch.h"
#include "occlude/render/view_along_path.h"

namespace occlude::render {
namespace {

class Walker {
 public:
  Walker(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options, SceneRenderer* renderer)
      : culler_(culler), path_(path), options_(options), renderer_(renderer) {
    view_only_.occluders = 0;
    view_only_.arithmetic = options.cull.arithmetic;
  }

  /// Culls, draws and compares one frame; `view` is the one of the previous frames.
  FrameRecord frame(std::size_t frame, bool reference, culler::View& view) {
    FrameRecord record;
    record.frame = frame;
    const culler::Camera camera = path_.camera(frame, aspect(options_));
    Picture full, picture;
    const auto with_view_frustum = [&] {
      const Timing timing = timed(camera, view_only_, view_without_, full);
      record.view_frustum_cull_ms = timing.cull_ms;
      record.view_frustum_frame_ms = timing.frame_ms;
    };
    const auto with_occlusion = [&] {
      const Timing timing = timed(camera, options_.cull, view, picture);
      record.cull_ms = timing.cull_ms;
      record.witness_ms = timing.witness_ms;
      record.frame_ms = timing.frame_ms;
    };
    // The order alternates from one drawn frame to the next, whatever their numbers: the second method finds the caches
    // warm.
    record.is_occlusion_first = is_occlusion_first_;
    if (is_occlusion_first_) with_occlusion();
    with_view_frustum();
    if (!is_occlusion_first_) with_occlusion();
    is_occlusion_first_ = !is_occlusion_first_;
    const culler::CullResult& culled = view.result();
    record.view_frustum_polygons = view_without_.result().stats.drawn_polygons;
    record.rendered_polygons = culled.stats.drawn_polygons;
    record.occluders = culled.occluders.size();
    record.stats = culled.stats;
    if (!renderer_) return record;
    if (reference) {
      const PolygonRange all = culler_.hierarchy().soup().all();
      full = draw(camera, std::span(&all, 1));
    }
    visible_ = compare(full, picture, culler_, camera, culled, record);
    record.visible_frame_ms = draw_only(camera, visible_);
    return record;
  }

  /// The polygons that the last frame showed, ascending; null if nothing is drawn.
  [[nodiscard]] const std::vector<std::uint32_t>* visible() const { return renderer_ ? &visible_ : nullptr; }

 private:
  struct Timing {
    double cull_ms = 0, witness_ms = 0, frame_ms = 0;
  };

  /// Also collects the witnesses, outside the frame time.
  Timing timed(const culler::Camera& camera, const culler::CullOptions& options, culler::View& view, Picture& picture) {
    check_interrupt();
    Timing timing;
    const Stopwatch culling;
    const culler::CullResult& result = culler_.cull(camera, options, view);
    timing.cull_ms = culling.milliseconds();
    witnesses_.clear();
    const Stopwatch proving;
    culler_.append_witnesses(result, witnesses_);
    timing.witness_ms = proving.milliseconds();
    if (renderer_) {
      const Stopwatch drawing;
      renderer_->draw(camera, result.drawn);
      timing.frame_ms = timing.cull_ms + drawing.milliseconds();
      picture = {renderer_->image(), renderer_->item_buffer(camera, result.drawn)};
    }
    return timing;
  }

  /// Draws these polygons; returns the time in milliseconds.
  double draw_only(const culler::Camera& camera, const std::vector<std::uint32_t>& polygons) const {
    std::vector<PolygonRange> ranges;
    for (const std::uint32_t p : polygons) culler::append_range(ranges, {p, 1});
    const Stopwatch drawing;
    renderer_->draw(camera, ranges);
    return drawing.milliseconds();
  }

  Picture draw(const culler::Camera& camera, std::span<const PolygonRange> ranges) const {
    renderer_->draw(camera, ranges);
    return {renderer_->image(), renderer_->item_buffer(camera, ranges)};
  }

  const culler::Culler& culler_;
  const CameraPath& path_;
  const WalkOptions& options_;
  SceneRenderer* renderer_;
  culler::CullOptions view_only_;
  culler::View view_without_;  ///< with view-frustum culling alone
  bool is_occlusion_first_ = false;
  std::vector<culler::Witness> witnesses_;  ///< of the last frame
  std::vector<std::uint32_t> visible_;      ///< in the last frame
};

}  // namespace

Drawing::Drawing(const culler::Culler& culler, const WalkOptions& options) {
  if (!options.render) return;
  context = make_offscreen_context();
  renderer = std::make_unique<SceneRenderer>(culler.hierarchy().soup(), options.width, options.height);
}

WalkResult walk_frames(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options,
                       const Drawing& drawing, const OnFrame& on_frame) {
  const std::vector<std::size_t> frames = frames_of(path, options);
  const std::size_t step = reference_step(frames.size());
  const culler::SoupView soup = culler.hierarchy().soup();
  WalkResult result;
  result.polygons = soup.size();
  result.see_through_polygons = static_cast<std::size_t>(std::ranges::count(soup.see_through, 1));
  result.triangles = soup.indices.size() - 2 * soup.size();
  result.build = culler.config();
  result.renderer = drawing.description();
  Walker walker(culler, path, options, drawing.renderer.get());
  {
    culler::View warm_up;  // the first picture includes one-time work of the renderer
    static_cast<void>(walker.frame(frames.front(), false, warm_up));
  }
  ViewAlongPath along(culler, path, options, options.cull);
  Progress progress("frame", frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const bool is_reference = i % step == 0;
    culler::View& view = along.before(frames[i]);
    result.frames.push_back(walker.frame(frames[i], is_reference, view));
    if (is_reference && options.render) ++result.reference_frames;
    if (on_frame) on_frame({result.frames.back(), view.result(), walker.visible(), is_reference});
    progress.update(i + 1);
  }
  return result;
}

}  // namespace occlude::render
