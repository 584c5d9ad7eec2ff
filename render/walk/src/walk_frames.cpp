// SPDX-License-Identifier: MIT
#include "occlude/render/walk_frames.h"

#include <algorithm>

#include "comparison.h"
#include "model/append_range.h"
#include "occlude/render/processor_time.h"
#include "occlude/render/progress.h"
#include "occlude/render/stopwatch.h"

namespace occlude::render {
namespace {

class Walker {
 public:
  Walker(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options, SceneRenderer* renderer)
      : culler_(culler), path_(path), options_(options), renderer_(renderer) {
    view_only_.method = culler::Method::frusta;
    view_only_.occluders = 0;
    view_only_.arithmetic = options.cull.arithmetic;
  }

  /// Culls, draws and compares one frame. REQUIRES: `along` has gone to it.
  FrameRecord frame(std::size_t frame, bool reference, FramesAlongPath& along) {
    FrameRecord record;
    record.frame = frame;
    const culler::Camera camera = path_.camera(frame, aspect(options_));
    Picture full, picture;
    const auto with_view_frustum = [&] {
      const Timing timing = timed(
          camera, [&] { culler_.cull(camera, view_only_, view_without_); },
          [&]() -> const culler::CullResult& { return view_without_.result(); }, full);
      record.view_frustum_cull_ms = timing.cull.ms;
      record.view_frustum_frame_ms = timing.frame.ms;
      record.view_frustum_frame_processor_ms = timing.frame.processor_ms;
    };
    const auto with_occlusion = [&] {
      const Timing timing = timed(
          camera, [&] { along.cull(); }, [&]() -> const culler::CullResult& { return along.result(); }, picture);
      record.cull_ms = timing.cull.ms;
      record.cull_processor_ms = timing.cull.processor_ms;
      record.witness_ms = timing.witness_ms;
      record.frame_ms = timing.frame.ms;
      record.frame_processor_ms = timing.frame.processor_ms;
    };
    // The order alternates from one drawn frame to the next, whatever their numbers: the second method finds the caches
    // warm.
    record.is_occlusion_first = is_occlusion_first_;
    if (is_occlusion_first_) with_occlusion();
    with_view_frustum();
    if (!is_occlusion_first_) with_occlusion();
    is_occlusion_first_ = !is_occlusion_first_;
    const culler::CullResult& culled = along.result();
    record.region = along.region();
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
    Took cull, frame;
    double witness_ms = 0;
  };

  /// Times `cull`, and drawing its result. Also collects the witnesses, outside the frame time.
  template <class Cull, class Result>
  Timing timed(const culler::Camera& camera, const Cull& cull, const Result& result_of, Picture& picture) {
    check_interrupt();
    Timing timing;
    timing.cull = took(cull);
    const culler::CullResult& result = result_of();
    witnesses_.clear();
    const Stopwatch proving;
    culler_.append_witnesses(result, witnesses_);
    timing.witness_ms = proving.milliseconds();
    if (renderer_) {
      const Took drawing = took([&] { renderer_->draw(camera, result.drawn); });
      timing.frame = {timing.cull.ms + drawing.ms, timing.cull.processor_ms + drawing.processor_ms};
      picture = {renderer_->image(), renderer_->item_buffer(camera, result.drawn)};
    }
    return timing;
  }

  /// Draws these polygons; returns the time in milliseconds.
  double draw_only(const culler::Camera& camera, const std::vector<std::uint32_t>& polygons) const {
    std::vector<PolygonRange> ranges;
    for (const std::uint32_t p : polygons) culler::append_range(ranges, {p, 1});
    return took([&] { renderer_->draw(camera, ranges); }).ms;
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
  result.region = path.eyes.radius;
  result.renderer = drawing.description();
  Walker walker(culler, path, options, drawing.renderer.get());
  {
    FramesAlongPath warm_up(culler, path, options);  // the first picture includes one-time work of the renderer
    warm_up.go_to(frames.front());
    static_cast<void>(walker.frame(frames.front(), false, warm_up));
  }
  FramesAlongPath along(culler, path, options);
  Progress progress("frame", frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const bool is_reference = i % step == 0;
    along.go_to(frames[i]);
    result.frames.push_back(walker.frame(frames[i], is_reference, along));
    if (is_reference && options.render) ++result.reference_frames;
    if (on_frame) on_frame({result.frames.back(), along.result(), along.source(), walker.visible(), is_reference});
    progress.update(i + 1);
  }
  result.regions.assign(along.regions().begin(), along.regions().end());
  return result;
}

}  // namespace occlude::render
