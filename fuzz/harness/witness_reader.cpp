// SPDX-License-Identifier: MIT
// A line of a witness file, of a small model: refused with a message, proved or disproved.
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "occlude/culler/hierarchy.h"
#include "proof.h"

namespace occlude::harness {
namespace {

/// A wall in one piece and one in two, and behind them a row of triangles.
culler::PolygonSoup small_model() {
  culler::PolygonSoup soup;
  const auto add = [&](std::initializer_list<glm::dvec3> polygon) {
    std::vector<std::uint32_t> loop;
    for (const glm::dvec3& v : polygon) loop.push_back(soup.add_vertex(v));
    soup.add_polygon(loop);
  };
  add({{2, -2, -2}, {2, 2, -2}, {2, 2, 2}, {2, -2, 2}});
  add({{3, -2, -2}, {3, 2, -2}, {3, 2, 2}});
  add({{3, -2, -2}, {3, 2, 2}, {3, -2, 2}});
  for (int i = -4; i <= 4; ++i) add({{4, i, 0}, {5, i, 0}, {4, i, 1}});
  return soup;
}

const cli::Prover& prover() {
  static const auto hierarchy = culler::Hierarchy::build(small_model(), {2});
  static const render::CameraPath path{
      .frames = 2, .keyframes = {{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 0, 0}}}, .far = 100};
  static const cli::Prover instance(hierarchy, path, 1);
  return instance;
}

}  // namespace
}  // namespace occlude::harness

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  try {
    static_cast<void>(harness::prover().prove({reinterpret_cast<const char*>(data), size}));
  } catch (const cli::LineError&) {
    // The one way to refuse a line.
  }
  return 0;
}
