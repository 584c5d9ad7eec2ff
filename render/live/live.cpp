// SPDX-License-Identifier: MIT
// The culler as a WebAssembly module, for render/report/page/live_culler.js. A function that returns bytes leaves them in
// `output`; one that can fail leaves the reason there and returns false.
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "bytes.h"
#include "occlude/culler/culler.h"
#include "packed_soup.h"
#include "page_frames.h"
#include "page_model.h"

#define EXPORTED(name) extern "C" __attribute__((export_name(#name), used))

namespace {

using namespace occlude;

struct Live {
  Live(culler::PolygonSoup soup, const culler::BuildConfig& config)
      : culler(std::move(soup), config), model(culler.hierarchy()) {
    for (const auto method : {culler::Method::frusta, culler::Method::cover}) culler.prepare(method);
  }

  culler::Culler culler;
  render::PageModel model;
  culler::View view, unculled;  ///< the second culls by the view frustum alone
};

std::string input, output;
std::unique_ptr<Live> live;
culler::Camera camera;

template <class Work>
bool succeeds(const Work& work) {
  try {
    work();
    return true;
  } catch (const std::exception& error) {
    output = error.what();
    return false;
  }
}

/// The outlines of the occluders of one frame: for each its corners, and the places of its polygons.
std::string packed(const render::PageFrames& frames) {
  render::Bytes bytes;
  const auto outlines = frames.outlines();
  bytes.number(outlines.size());
  for (const auto& [occluder, corners] : outlines) {
    bytes.number(corners.size());
    for (const auto& corner : corners) {
      for (const std::uint32_t c : corner) bytes.number(c);
    }
    const auto& places = frames.occluders().at(occluder).occluder.places;
    bytes.number(places.size());
    for (const std::uint32_t place : places) bytes.number(place);
  }
  return bytes.text();
}

}  // namespace

/// Room for the packed model.
EXPORTED(occlude_input) char* occlude_input(std::size_t size) {
  input.resize(size);
  return input.data();
}

EXPORTED(occlude_output) const char* occlude_output() { return output.data(); }
EXPORTED(occlude_output_size) std::size_t occlude_output_size() { return output.size(); }

/// Prepares the model.
EXPORTED(occlude_open) bool occlude_open(std::uint32_t leaf_size) {
  return succeeds([&] {
    culler::BuildConfig config;
    config.hierarchy.leaf_size = leaf_size;
    live = std::make_unique<Live>(render::unpacked(input), config);
    input = {};
  });
}

/// A part of the model as page/unpack.js reads it: vertices, leaves, sides, corners, numbers.
EXPORTED(occlude_model) void occlude_model(int part) {
  const render::PageModel& model = live->model;
  const std::string* const parts[] = {&model.vertices(), &model.leaf_sizes(), &model.sides(), &model.corners(),
                                      &model.numbers()};
  output = *parts[part];
}

/// The grid of the model: its lowest corner, or the steps from there to the far one.
EXPORTED(occlude_grid_corner) double occlude_grid_corner(bool is_far, int axis) {
  const render::PageGrid& grid = live->model.grid();
  return is_far ? grid.steps[static_cast<std::size_t>(axis)] : grid.low[axis];
}
EXPORTED(occlude_grid_step) double occlude_grid_step() { return live->model.grid().step; }

/// What all cameras share.
EXPORTED(occlude_lens)
void occlude_lens(bool is_perspective, double fov_y_deg, double height, double near, double far, double up_x, double up_y,
                  double up_z) {
  camera.projection = is_perspective ? culler::Projection::perspective : culler::Projection::orthographic;
  camera.fov_y_deg = fov_y_deg;
  camera.height = height;
  camera.near_plane = near;
  camera.far_plane = far;
  camera.up = {up_x, up_y, up_z};
}

/// Culls the next frame. `budget_ms` may be infinite. `margin` is a share of the picture's height.
EXPORTED(occlude_cull)
bool occlude_cull(double eye_x, double eye_y, double eye_z, double target_x, double target_y, double target_z, double aspect,
                  bool is_cover, std::uint32_t occluders, double budget_ms, double margin) {
  return succeeds([&] {
    camera.eye = {eye_x, eye_y, eye_z};
    camera.target = {target_x, target_y, target_z};
    camera.aspect = aspect;
    culler::CullOptions options;
    options.method = is_cover ? culler::Method::cover : culler::Method::frusta;
    options.occluders = occluders;
    options.cover.ms = budget_ms;
    options.margin = margin;
    live->culler.cull(camera, options, live->view);
  });
}

/// The frame as page/unpack.js reads it (page_frames.h), or the outlines of its occluders.
EXPORTED(occlude_frame) void occlude_frame(bool is_outlines) {
  render::PageFrames frames(live->culler, live->model);
  frames.add(live->view.result());
  output = is_outlines ? packed(frames) : frames.packed();
}

/// How many polygons the frame draws.
EXPORTED(occlude_drawn) std::uint32_t occlude_drawn() {
  return static_cast<std::uint32_t>(live->view.result().stats.drawn_polygons);
}

/// How many polygons are in its view, with what is hidden. What occlusion culling finds first is not asked whether it is in
/// view, so this needs a frame of its own.
EXPORTED(occlude_in_view) std::uint32_t occlude_in_view() {
  const culler::CullResult& frame =
      live->culler.cull(camera, {.method = culler::Method::frusta, .occluders = 0}, live->unculled);
  return static_cast<std::uint32_t>(frame.stats.drawn_polygons);
}
