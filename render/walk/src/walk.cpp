// SPDX-License-Identifier: MIT
#include "occlude/render/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "frame/culler_access.h"
#include "occlude/kernel/overlap.h"
#include "occlude/render/errors.h"
#include "occlude/render/model_io.h"
#include "occlude/render/plates.h"
#include "occlude/render/progress.h"
#include "occlude/render/store.h"
#include "occlude/render/walk_frames.h"
#include "occlude/render/witness.h"

namespace occlude::render {
namespace {

/// Counts the operations of the frame's shadow tests and passes the tests to on_shadow_test.
kernel::Operations visit_shadow_tests(const culler::Culler& culler, std::size_t frame, const CulledFor& source,
                                      const WalkOptions& options) {
  kernel::Operations total;
  culler::visit_shadow_tests(
      culler, source.result, source.camera, source.options, [&](const culler::Occluder& occluder, const culler::Box& box) {
        check_interrupt();
        total += std::visit(
            [&](const auto& kind) {
              return kernel::count_operations(occluder.frustum, kind, options.cull.arithmetic, options.cull.test);
            },
            box);
        if (!options.on_shadow_test) return;
        options.on_shadow_test({frame, occluder.frustum.viewpoint(), occluders_of(culler).geometry(occluder.index),
                                options.cull.shadow_near, box});
      });
  return total;
}

/// The reasons of a frame take a quarter of a second of one processor at most. Nearly always they take a tenth of that, and
/// none is left unknown.
constexpr std::size_t kMostWork = culler::MissedReasons::kMostWork / 4;

/// Why the frame drew what it does not show; nothing if that is not known. Of a frame that is held, why its region drew it.
std::optional<culler::MissedReasons::Answers> missed_by(const FinishedFrame& frame, const culler::Culler& culler) {
  if (!frame.visible) return std::nullopt;
  // What the frame does not draw is not asked.
  std::vector<bool> shows(culler.hierarchy().soup().size(), true);
  for (const auto& [first, count] : frame.culled.drawn) std::fill_n(shows.begin() + first, count, false);
  for (const std::uint32_t p : *frame.visible) shows[p] = true;
  const auto& [camera, options, result] = frame.source;
  return culler::MissedReasons(culler, camera, options, result).answers(shows, check_interrupt, kMostWork);
}

/// What hides what the frame culls by cover. `of_source` hides what its source does.
std::vector<culler::CoverWitness> covers_in(const FinishedFrame& frame, const culler::Culler& culler,
                                            const std::vector<culler::CoverWitness>& of_source) {
  std::vector<culler::CoverWitness> covers;
  std::ranges::copy_if(of_source, std::back_inserter(covers), [&](const culler::CoverWitness& cover) {
    const culler::Culled* const cull = culler.cull_of(frame.culled, cover.range.first);
    return cull && cull->by == culler::Culled::By::cover;
  });
  return covers;
}

}  // namespace

std::size_t reference_step(std::size_t frames) {
  // Enough to reach every part of a path, and few enough to be cheap.
  constexpr std::size_t kReferenceFrames = 48;
  return std::max<std::size_t>(1, frames / kReferenceFrames);
}

std::vector<std::size_t> frames_of(const CameraPath& path, const WalkOptions& options) {
  std::vector<std::size_t> frames;
  const std::size_t end = std::min(options.end, path.frames);
  for (std::size_t f = options.begin; f < end; f += std::min(options.step, end - f)) frames.push_back(f);
  if (frames.empty()) {
    throw InputError(
        fmt::format("--frames: no frame selected: the path has {} frames, 0 to {}", path.frames, path.frames - 1));
  }
  return frames;
}

namespace {

void prepare(const culler::Culler& culler, const WalkOptions& options) {
  // A frame that is held asks for the axis-aligned box of each leaf, and no proof is of two kinds of box.
  if (options.hold > 0 && culler.config().hierarchy.bounds == culler::Bounds::obb) {
    throw InputError("--hold: frames are held with axis-aligned boxes alone: not with --bounds obb");
  }
  culler.prepare(options.cull.method, check_interrupt);
  // The first frame by the view frustum alone makes what the others need.
  static_cast<void>(culler.cull(culler::Camera{}, {.method = culler::Method::frusta, .occluders = 0}));
}

}  // namespace

culler::Culler make_culler(culler::PolygonSoup soup, const WalkOptions& options) {
  culler::Culler culler = [&] {
    if (options.preprocess.empty()) return culler::Culler(std::move(soup), options.build, check_interrupt);
    culler::Culler stored = read_store(options.preprocess, options.cull.method);
    if (is_model_of(soup, stored)) return stored;
    throw InputError(options.preprocess.string() + ": made from another model: preprocess this one");
  }();
  prepare(culler, options);
  return culler;
}

ModelFile::ModelFile(std::filesystem::path file, const ReadOptions& options) : path(std::move(file)) {
  if (is_store(path)) return;
  Model model = read_model(path, options);
  soup = std::move(model.soup);
  notes = std::move(model.notes);
}

culler::Culler make_culler(ModelFile model, const WalkOptions& options) {
  if (model.soup) return make_culler(std::move(*model.soup), options);
  culler::Culler culler = read_store(model.path, options.cull.method);
  prepare(culler, options);
  return culler;
}

void require_walkable(std::size_t polygons, const std::string& model_name) {
  if (polygons < 2) throw InputError(fmt::format("{}: only one polygon; a walk needs at least two", model_name));
}

WalkResult walk(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options,
                const std::string& model_name, WalkOutput& output) {
  require_walkable(culler.hierarchy().soup().size(), model_name);
  output.add_model(culler);
  Drawing drawing(culler, options);
  kernel::Operations operations;
  std::vector<culler::MissedReasons::Counts> missed;
  std::size_t witnesses = 0;
  std::vector<std::string> lines;
  std::vector<culler::CoverWitness> of_source;  // of the region, or of the frame itself
  std::size_t region = 0;
  const auto on_frame = [&](const FinishedFrame& finished) {
    const std::size_t frame = finished.record.frame;
    const auto& [source_camera, source_options, source] = finished.source;
    if (finished.record.region == 0 || finished.record.region != region) {
      of_source = covers_of(culler, source_camera, source, source_options);
      region = finished.record.region;
    }
    const std::vector<culler::CoverWitness> covers = covers_in(finished, culler, of_source);
    const culler::Camera camera = path.camera(frame, aspect(options));
    const auto reasons = missed_by(finished, culler);
    output.add_frame({finished.record, camera, finished.culled, covers, finished.visible, reasons ? &*reasons : nullptr});
    if (reasons) missed.push_back(culler::MissedReasons::count(*reasons));
    if (finished.is_reference) operations += visit_shadow_tests(culler, frame, finished.source, options);
    if (!options.witness) return;
    lines.clear();
    const bool is_held = finished.record.region != 0;
    append_witnesses(lines, frame, camera, culler, finished.culled, options.cull, covers,
                     is_held ? &source_camera : nullptr);
    for (const std::string& line : lines) output.add_witness(line);
    witnesses += lines.size();
  };
  WalkResult result = walk_frames(culler, path, options, drawing, on_frame);
  result.operations = operations;
  result.missed = std::move(missed);
  result.witnesses = witnesses;

  if (!options.render || !options.plates) return result;
  const ShownStage stage("drawing plates");
  drawing.renderer.reset();
  for (const DrawnPlate& drawn : draw_plates(culler, path, result.frames, options)) {
    output.add_plate(drawn.plate, drawn.image);
  }
  return result;
}

}  // namespace occlude::render
