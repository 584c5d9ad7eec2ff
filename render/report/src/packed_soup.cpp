// SPDX-License-Identifier: MIT
// The format: the number of vertices and of polygons; for each polygon four times its number of sides, and 1 more if it is
// see-through, 2 more if it is another piece of the same face as the polygon before; for each corner the difference
// of its vertex from that of the corner before; then for x, y and z of each vertex the difference of its 64 bits from those
// of the vertex before, first the lowest byte of all, then the next ones.
#include "packed_soup.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "bytes.h"

namespace occlude::render {
namespace {

constexpr std::size_t kBytes = sizeof(double);

constexpr unsigned kSeeThrough = 1, kSameFace = 2, kFlagBits = 2;

std::uint64_t unfolded(std::uint64_t number) { return number >> 1 ^ ((number & 1U) == 0 ? 0 : ~std::uint64_t{0}); }

void pack_axis(culler::SoupView soup, int axis, std::string& text) {
  std::uint64_t before = 0;
  append_planes(text, soup.vertices.size(), kBytes, [&](std::size_t v) {
    const auto bits = std::bit_cast<std::uint64_t>(soup.vertices[v][axis]);
    return folded(bits - std::exchange(before, bits));
  });
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint64_t byte = next();
      value |= (byte & 0x7FU) << shift;
      if (byte < 0x80) return value;
    }
    throw std::invalid_argument("a number in the model is too long");
  }
  /// A count of things that take a byte or more each.
  std::size_t count() { return counted(number()); }
  [[nodiscard]] std::size_t counted(std::uint64_t value) const {
    if (value > bytes_.size()) throw std::invalid_argument("the model ends early");
    return static_cast<std::size_t>(value);
  }
  void axis(culler::PolygonSoup& soup, int axis) {
    const std::size_t count = soup.vertices.size();
    if (bytes_.size() - at_ < kBytes * count) throw std::invalid_argument("the model ends early");
    std::uint64_t bits = 0;
    for (std::size_t v = 0; v < count; ++v) {
      std::uint64_t folded = 0;
      for (std::size_t k = 0; k < kBytes; ++k) {
        folded |= std::uint64_t{static_cast<unsigned char>(bytes_[at_ + k * count + v])} << 8 * k;
      }
      bits += unfolded(folded);
      soup.vertices[v][axis] = std::bit_cast<double>(bits);
    }
    at_ += kBytes * count;
  }

 private:
  std::uint64_t next() {
    if (at_ == bytes_.size()) throw std::invalid_argument("the model ends early");
    return static_cast<unsigned char>(bytes_[at_++]);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::string packed(culler::SoupView soup) {
  Bytes bytes;
  bytes.number(soup.vertices.size());
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
  std::string text = bytes.text();
  for (int axis = 0; axis < 3; ++axis) pack_axis(soup, axis, text);
  return text;
}

culler::PolygonSoup unpacked(std::string_view bytes) {
  Reader reader(bytes);
  culler::PolygonSoup soup;
  soup.vertices.resize(reader.count());
  const std::size_t polygons = reader.count();
  soup.first.reserve(polygons + 1);
  for (std::size_t p = 0; p < polygons; ++p) {
    const std::uint64_t sides = reader.number();
    soup.first.push_back(culler::PolygonSoup::narrowed(soup.first.back() + reader.counted(sides >> kFlagBits)));
    const bool is_same_face = (sides & kSameFace) != 0;
    soup.faces.push_back(p == 0 ? 0 : soup.faces.back() + (is_same_face ? 0 : 1));
    soup.see_through.push_back(sides & kSeeThrough);
  }
  if (soup.face_count() == polygons) soup.faces.clear();
  if (std::ranges::count(soup.see_through, 1) == 0) soup.see_through.clear();
  soup.indices.reserve(soup.first.back());
  std::uint64_t index = 0;
  for (std::size_t i = 0; i < soup.first.back(); ++i) {
    index += unfolded(reader.number());
    soup.indices.push_back(static_cast<std::uint32_t>(index));
  }
  for (int axis = 0; axis < 3; ++axis) reader.axis(soup, axis);
  return soup;
}

}  // namespace occlude::render
