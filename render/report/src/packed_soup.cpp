// SPDX-License-Identifier: MIT
// The format: the number of polygons; for each polygon four times its number of sides, and 1 more if it is see-through, 2
// more if it is another piece of the same face as the polygon before; for each corner the difference of its vertex from that
// of the corner before; then how many colours there are, 0 where all polygons have the same; for each colour, ascending, the
// difference of its number, 65536 red + 256 green + blue, from that of the colour before; for each polygon, if there are
// colours, the difference of the place of its colour among these from that of the polygon before; then for x, y and z of
// each vertex the difference of its 32 bits from those of the vertex before, first the lowest byte of all, then the next
// ones. culler/js/page/src/inside.mts reads it.
#include "packed_soup.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>
#include <vector>

#include "bytes.h"

namespace occlude::render {
namespace {

constexpr std::uint64_t kSeeThrough = 1, kSameFace = 2;
constexpr unsigned kFlagBits = 2;

/// The point nearest to the middle of the model on a grid whose cells are larger than the model, and at most twice as large:
/// coordinates from there are at most one and a half sizes of the model. Cells are powers of two, so that exact coordinates
/// mostly stay so.
glm::dvec3 origin_of(culler::SoupView soup) {
  if (soup.vertices.empty()) return {};
  glm::dvec3 low = soup.vertices.front(), high = low;
  for (const glm::dvec3& vertex : soup.vertices) {
    low = glm::min(low, vertex);
    high = glm::max(high, vertex);
  }
  const glm::dvec3 size = high - low;
  const double most = glm::max(size.x, glm::max(size.y, size.z));
  if (most == 0) return low;
  const double cell = std::exp2(std::ilogb(most) + 1);
  return cell * glm::round((0.5 * low + 0.5 * high) / cell);
}

std::uint32_t number_of(const Rgb& colour) {
  return std::uint32_t{colour[0]} << 16U | std::uint32_t{colour[1]} << 8U | colour[2];
}

void pack_colours(std::span<const Rgb> colours, Bytes& bytes) {
  std::vector<std::uint32_t> palette(colours.size());
  std::ranges::transform(colours, palette.begin(), number_of);
  std::ranges::sort(palette);
  palette.erase(std::unique(palette.begin(), palette.end()), palette.end());
  if (palette.size() < 2) return bytes.number(0);
  bytes.number(palette.size());
  std::uint32_t before = 0;
  for (const std::uint32_t number : palette) bytes.number(number - std::exchange(before, number));
  std::int64_t last = 0;
  for (const Rgb& colour : colours) {
    const std::int64_t place = std::ranges::lower_bound(palette, number_of(colour)) - palette.begin();
    bytes.difference(place - std::exchange(last, place));
  }
}

void pack_axis(culler::SoupView soup, const glm::dvec3& origin, int axis, std::string& text) {
  std::uint32_t before = 0;
  append_planes(text, soup.vertices.size(), sizeof before, [&](std::size_t v) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(soup.vertices[v][axis] - origin[axis]));
    const auto difference = static_cast<std::int32_t>(bits - std::exchange(before, bits));
    return folded(static_cast<std::uint64_t>(std::int64_t{difference}));
  });
}

}  // namespace

PackedSoup packed(culler::SoupView soup, std::span<const Rgb> colours) {
  Bytes bytes;
  bytes.number(soup.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const bool is_same_face = p != 0 && soup.face(p) == soup.face(p - 1);
    bytes.number(soup.loop(p).size() << kFlagBits | (soup.is_opaque(p) ? 0 : kSeeThrough) | (is_same_face ? kSameFace : 0));
  }
  std::int64_t before = 0;
  for (const std::uint32_t index : soup.indices) {
    bytes.difference(index - before);
    before = index;
  }
  pack_colours(colours, bytes);
  PackedSoup packed{origin_of(soup), bytes.text()};
  for (int axis = 0; axis < 3; ++axis) pack_axis(soup, packed.origin, axis, packed.bytes);
  return packed;
}

}  // namespace occlude::render
