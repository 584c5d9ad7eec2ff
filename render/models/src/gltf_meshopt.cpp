// SPDX-License-Identifier: MIT
#include "gltf_meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <string>

namespace occlude::render::gltf {
namespace {

// The fewest compressed bytes of so many elements, so that a short file cannot ask for much memory. Of vertices each byte of
// 16 is told by 2 bits at least, so 64 by one byte; a triangle has a byte of its own, and so has an index.
constexpr std::uint64_t kVertexBytesPerByte = 64, kTriangleCornersPerByte = 3, kIndicesPerByte = 1;

enum class Mode { attributes, triangles, indices };

struct Coded {
  Mode mode = Mode::attributes;
  std::uint64_t count = 0, stride = 0;
};

Mode mode_of(const json& extension) {
  const std::string mode = text_in(extension, "mode", "");
  if (mode == "ATTRIBUTES") return Mode::attributes;
  if (mode == "TRIANGLES") return Mode::triangles;
  if (mode == "INDICES") return Mode::indices;
  refuse(fmt::format("mode: \"{}\" is not supported", mode));
}

/// Whether elements of the mode can have the stride, and there can be so many in `bytes` bytes.
bool is_possible(const Coded& coded, std::uint64_t bytes) {
  const auto [mode, count, stride] = coded;
  if (mode == Mode::attributes)
    return stride % 4 == 0 && stride > 0 && stride <= 256 && count <= bytes * kVertexBytesPerByte / stride;
  const bool is_triangles = mode == Mode::triangles;
  return (stride == 2 || stride == 4) && count <= bytes * (is_triangles ? kTriangleCornersPerByte : kIndicesPerByte) &&
         !(is_triangles && count % 3 != 0);
}

int decode(const Coded& coded, std::span<const std::byte> from, std::vector<std::byte>& to) {
  const auto* const bytes = reinterpret_cast<const unsigned char*>(from.data());
  switch (coded.mode) {
    case Mode::attributes:
      return meshopt_decodeVertexBuffer(to.data(), coded.count, coded.stride, bytes, from.size());
    case Mode::triangles:
      return meshopt_decodeIndexBuffer(to.data(), coded.count, coded.stride, bytes, from.size());
    case Mode::indices:
      return meshopt_decodeIndexSequence(to.data(), coded.count, coded.stride, bytes, from.size());
  }
  return -1;
}

void apply_filter(const std::string& filter, const Coded& coded, std::vector<std::byte>& bytes) {
  if (filter == "NONE") return;
  const bool is_attributes = coded.mode == Mode::attributes;
  if (filter == "OCTAHEDRAL" && is_attributes && (coded.stride == 4 || coded.stride == 8)) {
    meshopt_decodeFilterOct(bytes.data(), coded.count, coded.stride);
  } else if (filter == "QUATERNION" && is_attributes && coded.stride == 8) {
    meshopt_decodeFilterQuat(bytes.data(), coded.count, coded.stride);
  } else if (filter == "EXPONENTIAL" && is_attributes) {
    meshopt_decodeFilterExp(bytes.data(), coded.count, coded.stride);
  } else {
    refuse(fmt::format("filter: \"{}\" is not supported for elements of {} bytes", filter, coded.stride));
  }
}

}  // namespace

std::vector<std::byte> decode_meshopt(const json& extension, std::span<const std::byte> bytes) {
  const Coded coded{mode_of(extension), whole_in(extension, "count"), whole_in(extension, "byteStride")};
  if (!is_possible(coded, bytes.size()))
    refuse(fmt::format("{} elements of {} bytes cannot be in {} compressed bytes", coded.count, coded.stride, bytes.size()));
  std::vector<std::byte> decoded(coded.count * coded.stride);
  if (decode(coded, bytes, decoded) != 0) refuse("EXT_meshopt_compression: the data is damaged");
  apply_filter(text_in(extension, "filter", "NONE"), coded, decoded);
  return decoded;
}

}  // namespace occlude::render::gltf
