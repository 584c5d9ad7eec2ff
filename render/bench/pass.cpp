// SPDX-License-Identifier: MIT
#include "pass.h"

#include "occlude/render/processor_time.h"
#include "occlude/render/progress.h"
#include "occlude/render/stopwatch.h"
#include "occlude/render/view_along_path.h"

namespace occlude::experiments {

Pass pass_along(const culler::Culler& culler, const render::CameraPath& path, const render::WalkOptions& walk,
                const culler::CullOptions& cull, const OnCulled& on_culled) {
  Pass sum;
  render::ViewAlongPath along(culler, path, walk, cull);
  const auto frames = frames_of(path, walk);
  for (const std::size_t frame : frames) {
    render::check_interrupt();
    const culler::Camera camera = path.camera(frame, aspect(walk));
    culler::View& view = along.before(frame);
    const render::ProcessorTime time(render::ProcessorTime::Of::thread);  // which takes longer to ask for than the clock
    const render::Stopwatch clock;
    const culler::CullResult& culled = culler.cull(camera, cull, view);
    sum.clock_ms += clock.milliseconds();
    sum.cull_ms += time.milliseconds();
    sum.drawn += static_cast<double>(culled.stats.drawn_polygons);
    sum.listed += static_cast<double>(culled.stats.potential_occluders);
    if (on_culled) on_culled(camera, culled);
  }
  const auto count = static_cast<double>(frames.size());
  return {sum.drawn / count, sum.listed / count, sum.cull_ms / count, sum.clock_ms / count};
}

double polygons_in_view(const culler::Culler& culler, const render::CameraPath& path, const render::WalkOptions& walk) {
  culler::CullOptions view_only = walk.cull;
  view_only.method = culler::Method::frusta;
  view_only.occluders = 0;
  return pass_along(culler, path, walk, view_only).drawn;
}

}  // namespace occlude::experiments
