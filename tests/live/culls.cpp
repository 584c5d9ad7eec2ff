// SPDX-License-Identifier: MIT
// Culls the frames of a path as the page of `occlude inspect` does, and prints for each what became of the polygons and a
// hash of those drawn. The last line, on standard error, has the mean milliseconds. Usage: live_culls MODEL PATH
// frusta|cover FRAMES
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "hash_of_drawn.h"
#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/model_io.h"
#include "occlude/render/walk.h"

using namespace occlude;

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const render::CameraPath path = render::read_camera_path(argv[2]);
  const std::size_t frames = std::strtoul(argv[4], nullptr, 10);
  culler::CullOptions options;
  options.method = std::string_view(argv[3]) == "cover" ? culler::Method::cover : culler::Method::frusta;
  options.margin = culler::margin_for(360);
  culler::BuildConfig config;
  config.hierarchy.leaf_size = culler::leaf_size_for(culler::Method::cover);
  const culler::Culler culler(render::read_model(argv[1]).soup, config);
  culler::View view;
  std::chrono::duration<double, std::milli> time{};
  for (std::size_t f = 0; f < frames; ++f) {
    const auto start = std::chrono::steady_clock::now();
    const culler::CullResult& frame = culler.cull(path.camera(f, 16.0 / 9), options, view);
    time += std::chrono::steady_clock::now() - start;
    const std::size_t drawn = frame.stats.drawn_polygons;
    const std::size_t in_view =
        culler.cull(path.camera(f, 16.0 / 9), {.method = culler::Method::frusta, .occluders = 0}).stats.drawn_polygons;
    std::printf("%zu: %zu drawn, %zu culled, %u\n", f, drawn, in_view - drawn, hash_of_drawn(culler.hierarchy(), frame));
  }
  std::fprintf(stderr, "native: %.3f ms a frame\n", time.count() / static_cast<double>(frames));
}
