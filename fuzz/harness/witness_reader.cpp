// SPDX-License-Identifier: MIT
// Reads a line of a witness file of a small model, of a walk or of what is hidden from boxes. It must be refused with a
// message, proved or disproved.
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "hidden_proof.h"
#include "occlude/culler/hierarchy.h"
#include "proof.h"

namespace occlude::harness {
namespace {

/// A wall of one polygon and a wall of two, and behind them a row of triangles.
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

const culler::Hierarchy& tree() {
  static const auto instance = culler::Hierarchy::build(small_model(), {2});
  return instance;
}

const proof::HiddenProver& hidden_prover() {
  static const proof::HiddenProver instance(tree());
  return instance;
}

const proof::Prover& prover() {
  static const proof::Prover instance(tree(), {2, [](std::size_t frame) {
                                                 culler::Camera camera;
                                                 camera.eye = {0, 0, static_cast<double>(frame)};
                                                 camera.aspect = 1;
                                                 camera.far_plane = 100;
                                                 return camera;
                                               }});
  return instance;
}

}  // namespace
}  // namespace occlude::harness

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  const std::string_view line(reinterpret_cast<const char*>(data), size);
  const auto try_by = [&](const auto& prover) {
    try {
      static_cast<void>(prover.prove(line));
    } catch (const cases::LineError&) {
      // This is the only way to refuse a line.
    }
  };
  try_by(harness::prover());
  try_by(harness::hidden_prover());
  return 0;
}
