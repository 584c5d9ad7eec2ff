// SPDX-License-Identifier: MIT
// Reads model files: the first byte chooses the format, the rest is the file.
#include <array>
#include <cstddef>
#include <cstdint>

#include "finding.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/errors.h"
#include "occlude/render/model_io.h"
#include "scratch_file.h"

namespace occlude::harness {
namespace {

constexpr std::array kExtensions = {".ply", ".obj", ".ply", ".obj", ".gltf", ".glb", ".dae", ".stl", ".off"};

void read(const ScratchFile& file) {
  const auto [soup, notes, colours] = render::read_model(file.path(), {.with_colours = true});
  if (soup.empty()) finding("a model without polygons");
  for (std::size_t p = 0; p < soup.size(); ++p) {
    if (soup.first[p + 1] < soup.first[p] + 3) finding("a polygon of fewer than three vertices");
    for (const std::uint32_t index : soup.loop(p)) {
      if (index >= soup.vertices.size()) finding("an index without vertex");
    }
    if (soup.is_opaque(p) && !culler::fan_is_face(soup.vertices, soup.loop(p))) {
      finding("an opaque polygon whose fan is not a face");
    }
  }
  if (!colours.empty() && colours.size() != soup.size()) finding("not a colour for each polygon");
  if (soup.first.back() != soup.indices.size()) finding("indices of no polygon");
}

}  // namespace
}  // namespace occlude::harness

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  if (size == 0) return 0;
  const harness::ScratchFile file({data + 1, size - 1}, harness::kExtensions[data[0] % harness::kExtensions.size()]);
  try {
    harness::read(file);
  } catch (const render::InputError&) {
    // This is the only way to refuse a file.
  }
  return 0;
}
