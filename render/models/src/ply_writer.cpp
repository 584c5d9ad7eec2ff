// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "occlude/render/model_io.h"
#include "occlude/render/progress.h"

namespace occlude::render {
namespace {

using culler::SoupView;

/// Appends the low `bytes` bytes of `value`, lowest first.
void append(std::string& out, std::uint64_t value, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
}

std::string comment_lines(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    lines += fmt::format("comment {}\n", line);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return lines;
}

/// The size of a list's length, bytes: one, or four if a polygon has more than 255 vertices.
std::size_t length_bytes(SoupView soup) {
  for (std::size_t p = 0; p < soup.size(); ++p) {
    if (soup.loop(p).size() > 0xFF) return 4;
  }
  return 1;
}

std::string header(SoupView soup, const std::string& comment) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\n{}element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list {} uint vertex_indices\nend_header\n",
      comment_lines(comment), soup.vertices.size(), soup.size(), length_bytes(soup) == 1 ? "uchar" : "uint");
}

}  // namespace

void write_ply(OutputFile& file, SoupView soup, const std::string& comment) {
  // Written in blocks of about 1 MiB, to save memory and to react to Ctrl-C.
  constexpr std::size_t kPiece = 1U << 20U;
  std::string out = header(soup, comment);
  const std::size_t length = length_bytes(soup);
  Progress progress("write: item", soup.vertices.size() + soup.size());
  std::size_t items = 0;
  const auto flush_when_full = [&] {
    ++items;
    if (out.size() < kPiece) return;
    check_interrupt();
    file.write(out);
    out.clear();
    progress.update(items);
  };
  for (const glm::dvec3& v : soup.vertices) {
    for (const double coordinate : {v.x, v.y, v.z}) append(out, std::bit_cast<std::uint64_t>(coordinate), sizeof(double));
    flush_when_full();
  }
  for (std::size_t p = 0; p < soup.size(); ++p) {
    append(out, soup.loop(p).size(), length);
    for (const std::uint32_t index : soup.loop(p)) append(out, index, sizeof(std::uint32_t));
    flush_when_full();
  }
  file.write(out);
}

}  // namespace occlude::render
