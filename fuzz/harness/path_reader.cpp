// SPDX-License-Identifier: MIT
// Reads a camera path. It must be refused with a message, or have a legal camera in every frame and read back as it is
// written.
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include "finding.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/errors.h"
#include "scratch_file.h"

namespace occlude::harness {
namespace {

using render::CameraPath;

std::string written(const CameraPath& path, const std::filesystem::path& file) {
  render::OutputFile output(file);
  render::write_camera_path(output, path);
  output.commit();
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void read(const ScratchFile& file) {
  const CameraPath path = render::read_camera_path(file.path());
  for (const std::size_t frame : {std::size_t{0}, path.frames / 2, path.frames - 1}) {
    if (const std::string fault = culler::fault(path.camera(frame, 1)); !fault.empty()) finding("a frame in which " + fault);
  }
  const std::string text = written(path, file.path());
  try {
    if (written(render::read_camera_path(file.path()), file.path()) != text) finding("a path reads back as another");
  } catch (const render::InputError& error) {
    finding(std::string("a path that is written does not read back: ") + error.what());
  }
}

}  // namespace
}  // namespace occlude::harness

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  const harness::ScratchFile file({data, size}, ".json");
  try {
    harness::read(file);
  } catch (const render::InputError&) {
    // This is the only way to refuse a file.
  }
  return 0;
}
