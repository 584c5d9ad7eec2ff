// SPDX-License-Identifier: MIT
// Culls the frames of a path by cover, and writes the model, the cameras and a hash of what each frame draws, as
// native.test.mjs reads it. Prints the mean milliseconds of a frame. Usage: js_model MODEL PATH FRAMES OUT
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "hash_of_drawn.h"
#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/model_io.h"

namespace {

using namespace occlude;

/// At multiples of eight bytes.
template <class Number>
void write(const std::vector<Number>& numbers, std::ofstream& out) {
  const std::size_t bytes = numbers.size() * sizeof(Number);
  out.write(reinterpret_cast<const char*>(numbers.data()), static_cast<std::streamsize>(bytes));
  const char zeros[8] = {};
  out.write(zeros, static_cast<std::streamsize>((8 - bytes % 8) % 8));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const render::CameraPath path = render::read_camera_path(argv[2]);
  const std::size_t frames = std::strtoul(argv[3], nullptr, 10);
  const culler::PolygonSoup soup = render::read_model(argv[1]).soup;

  std::vector<double> vertices;
  for (const auto& v : soup.vertices) vertices.insert(vertices.end(), {v.x, v.y, v.z});
  std::vector<std::uint32_t> sizes;
  for (std::size_t p = 0; p < soup.size(); ++p)
    sizes.push_back(static_cast<std::uint32_t>(soup.first[p + 1] - soup.first[p]));
  const std::vector<std::uint32_t> indices(soup.indices.begin(), soup.indices.end());
  const std::vector<std::uint8_t> marks(soup.see_through.begin(), soup.see_through.end());

  culler::CullOptions options;
  options.method = culler::Method::cover;
  options.margin = culler::margin_for(360);
  const culler::Culler culler(soup, {});
  culler.prepare(options.method);
  culler::View view;
  std::vector<double> cameras;
  std::vector<std::uint32_t> hashes;
  std::chrono::duration<double, std::milli> time{};
  for (std::size_t f = 0; f < frames; ++f) {
    const culler::Camera c = path.camera(f, 16.0 / 9);
    cameras.insert(cameras.end(), {c.eye.x, c.eye.y, c.eye.z, c.target.x, c.target.y, c.target.z, c.fov_y_deg, c.aspect,
                                   c.near_plane, c.far_plane});
    const auto start = std::chrono::steady_clock::now();
    const culler::CullResult& frame = culler.cull(c, options, view);
    time += std::chrono::steady_clock::now() - start;
    hashes.push_back(hash_of_drawn(culler.hierarchy(), frame));
  }

  std::ofstream out(argv[4], std::ios::binary);
  write(
      std::vector<double>{static_cast<double>(soup.vertices.size()), static_cast<double>(indices.size()),
                          static_cast<double>(sizes.size()), static_cast<double>(marks.size()), static_cast<double>(frames)},
      out);
  write(vertices, out);
  write(indices, out);
  write(sizes, out);
  write(marks, out);
  write(cameras, out);
  write(hashes, out);
  if (!out.flush()) return 1;
  std::printf("%.4f\n", time.count() / static_cast<double>(frames));
}
