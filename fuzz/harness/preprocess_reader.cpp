// SPDX-License-Identifier: MIT
// Reads a preprocess file. It must be refused with a message, or give a culler that breaks no promise.
#include <zlib.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "differential/cull_judge.h"
#include "finding.h"
#include "occlude/render/errors.h"
#include "occlude/render/preprocess_file.h"
#include "occlude/render/walk.h"
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
  const ScratchFile file({}, ".pre");
  {
    render::OutputFile output(file.path());
    write_preprocess(output, soup, culler::preprocess(soup, {.lists = {.threshold = 0.1, .regions = 8}}, {}));
    output.commit();
  }
  std::ifstream in(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The sound file with changes. The lowest bit of the first input byte says whether the checksum is left wrong, the other
/// bits say how many bytes the end loses. Then follow changes, each an offset of two bytes and a value. Bytes that are not
/// made from a sound file would hardly ever get past the first checks of the reader.
std::vector<std::uint8_t> edited(std::vector<std::uint8_t> bytes, std::span<const std::uint8_t> input) {
  if (input.empty()) return bytes;
  const std::uint8_t flags = input[0];
  for (input = input.subspan(1); input.size() >= 3; input = input.subspan(3)) {
    bytes[(input[0] + 256U * input[1]) % bytes.size()] = input[2];
  }
  bytes.resize(bytes.size() - flags / 2);
  if (flags % 2 == 0) {
    const auto crc = static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size() - sizeof(std::uint32_t)));
    std::memcpy(bytes.data() + bytes.size() - sizeof crc, &crc, sizeof crc);
  }
  return bytes;
}

void judge(const culler::Culler& culler) {
  culler::Camera camera;
  camera.eye = {0, 0.25, 0.5};
  camera.target = {8, 0, 0};
  culler::View view;
  for (int frame = 0; frame < 3; ++frame) {
    const culler::CullResult& result = culler.cull(camera, {}, view);
    if (const std::string fault = fuzz::fault_of(culler, camera, {}, result); !fault.empty()) finding(fault);
  }
}

}  // namespace
}  // namespace occlude::harness

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  static const culler::PolygonSoup soup = harness::some_soup();
  static const std::vector<std::uint8_t> sound = harness::sound_file(soup);
  const harness::ScratchFile file(harness::edited(sound, {data, size}), ".pre");
  render::WalkOptions options;
  options.preprocess = file.path();
  try {
    harness::judge(render::make_culler(soup, options));
  } catch (const render::InputError&) {
    // This is the only way to refuse a file.
  }
  return 0;
}
