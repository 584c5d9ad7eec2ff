// SPDX-License-Identifier: MIT
// An engine that logs what its culler culls. It draws a wall and a row of squares behind it, walks towards the wall, and
// culls the squares. Run `occlude audit wall.ply --log culled.log` then.
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "cull_log.h"

namespace {

/// The wall is polygon 0; the squares are behind it.
constexpr std::uint32_t kSquares = 63;

void write_model(const std::string& file) {
  std::ofstream ply(file);
  ply << "ply\nformat ascii 1.0\nelement vertex " << 4 * (kSquares + 1)
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << kSquares + 1
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::uint32_t i = 0; i <= kSquares; ++i) {
    const std::uint32_t x = 2 + i;
    ply << x << " -1 -1\n" << x << " 1 -1\n" << x << " 1 1\n" << x << " -1 1\n";
  }
  for (std::uint32_t i = 0; i <= kSquares; ++i) {
    ply << "4 " << 4 * i << ' ' << 4 * i + 1 << ' ' << 4 * i + 2 << ' ' << 4 * i + 3 << '\n';
  }
}

}  // namespace

int main() {
  write_model("wall.ply");
  cull_log::Writer log("culled.log");
  const std::vector<cull_log::Range> squares{{1, kSquares}}, wall{{0, 1}};

  // By the matrix with which the frame is drawn: here along x, z up, 60 degrees, 16:9, near plane at .1, none far.
  for (std::uint32_t i = 0; i < 4; ++i) {
    const double x = 0.1 * i, f = std::sqrt(3.0), z_near = 0.1;
    const double columns[4][4] = {{0, 0, 1, 1}, {-f * 9 / 16, 0, 0, 0}, {0, f, 0, 0}, {0, 0, -x - 2 * z_near, -x}};
    log.frame({i, 1280, 720}, columns[0], cull_log::minus_w_to_w, cull_log::culled, squares);
  }

  // By eye and target, and by what is drawn.
  const double eye[] = {0.5, 0, 0}, target[] = {1.5, 0, 0}, up[] = {0, 0, 1};
  const double endless = std::numeric_limits<double>::infinity();
  log.frame({4, 1280, 720}, eye, target, up, 60, 0.1, endless, cull_log::drawn, wall);

  // By objects.
  log.object(7, wall);
  log.object(8, squares);
  log.frame({5, 1280, 720}, eye, target, up, 60, 0.1, endless, cull_log::culled, std::vector<std::uint32_t>{8});
  return log.close() ? 0 : 1;
}
