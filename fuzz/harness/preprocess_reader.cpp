// SPDX-License-Identifier: MIT
// Opens a store, the file of `occlude preprocess`. It must be refused with a message, or give a culler that breaks no
// promise.
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "differential/cull_judge.h"
#include "finding.h"
#include "occlude/render/errors.h"
#include "occlude/render/store.h"
#include "occlude/render/walk.h"
#include "rehashed.h"
#include "scratch_file.h"

namespace occlude::harness {
namespace {

/// Five walls, one behind the other, and two more between the last two.
culler::PolygonSoup some_soup() {
  culler::PolygonSoup soup;
  const auto quad = [&](const std::array<glm::dvec3, 4>& corners) {
    std::array<std::uint32_t, 4> loop{};
    for (std::size_t i = 0; i < 4; ++i) loop[i] = soup.add_vertex(corners[i]);
    soup.add_polygon(loop);
  };
  const auto wall = [&](double x, double r) { quad({{{x, -r, -r}, {x, r, -r}, {x, r, r}, {x, -r, r}}}); };
  for (const double x : {2.0, 4.0, 6.0, 8.0, 9.0}) wall(x, x / 2);
  quad({{{8, -1, -1}, {9, -1, -1}, {9, -1, 1}, {8, -1, 1}}});
  quad({{{8, 1, -1}, {9, 1, -1}, {9, 1, 1}, {8, 1, 1}}});
  return soup;
}

std::vector<std::uint8_t> sound_file(const culler::PolygonSoup& soup) {
  const ScratchFile file({}, ".store");
  {
    render::OutputFile output(file.path());
    write_store(output, culler::Culler(soup, {.hierarchy = {.leaf_size = 2}, .lists = {.threshold = 0.1, .regions = 8}}));
    output.commit();
  }
  std::ifstream in(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The sound file with changes. The lowest bit of the first input byte says whether the hashes are left wrong, the other
/// bits say how many bytes the end loses. Then follow changes, each an offset of two bytes and a value. Bytes that are not
/// made from a sound file would hardly ever get past the first checks of the reader.
std::vector<std::uint8_t> edited(std::vector<std::uint8_t> bytes, std::span<const std::uint8_t> input) {
  if (input.empty()) return bytes;
  const std::uint8_t flags = input[0];
  for (input = input.subspan(1); input.size() >= 3; input = input.subspan(3)) {
    bytes[(input[0] + 256U * input[1]) % bytes.size()] = input[2];
  }
  bytes.resize(bytes.size() - flags / 2);
  if (flags % 2 == 0) rehash(std::as_writable_bytes(std::span(bytes)));
  return bytes;
}

void judge(const culler::Culler& culler) {
  culler::Camera camera;
  camera.eye = {0, 0.25, 0.5};
  camera.target = {8, 0, 0};
  for (const auto method : {culler::Method::frusta, culler::Method::cover}) {
    culler::CullOptions options{.method = culler::Method::frusta};
    options.method = method;
    culler::View view;
    for (int frame = 0; frame < 3; ++frame) {
      const culler::CullResult& result = culler.cull(camera, options, view);
      if (const std::string fault = fuzz::fault_of(culler, camera, options, result); !fault.empty()) finding(fault);
    }
  }
}

}  // namespace
}  // namespace occlude::harness

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  static const culler::PolygonSoup soup = harness::some_soup();
  static const std::vector<std::uint8_t> sound = harness::sound_file(soup);
  const harness::ScratchFile file(harness::edited(sound, {data, size}), ".store");
  try {
    for (const auto method : {culler::Method::frusta, culler::Method::cover}) {
      render::WalkOptions options;
      options.cull.method = method;
      harness::judge(render::make_culler(render::ModelFile(file.path()), options));
    }
  } catch (const render::InputError&) {
    // This is the only way to refuse a file.
  }
  return 0;
}
