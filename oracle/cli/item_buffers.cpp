// SPDX-License-Identifier: MIT
#include "item_buffers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <numeric>

#include "command_arguments.h"
#include "marked_picture.h"
#include "model/append_range.h"

namespace occlude::cli {
namespace {

constexpr int kLargest = kLargestSide;

/// Compares polygons corner by corner.
bool is_less(culler::SoupView soup, std::uint32_t a, std::uint32_t b) {
  const auto corner = [&](std::uint32_t index) {
    const glm::dvec3& v = soup.vertices[index];
    return std::array{v.x, v.y, v.z};
  };
  if (soup.is_opaque(a) != soup.is_opaque(b)) return soup.is_opaque(a);
  return std::ranges::lexicographical_compare(soup.loop(a), soup.loop(b), {}, corner, corner);
}

/// All polygons but those with the corners of an earlier one in the same order. These are the same triangles and show
/// nowhere, but each would take as long to draw: a million copies of a wall, as long as a million walls.
std::vector<culler::PolygonRange> without_copies(culler::SoupView soup) {
  std::vector<std::uint32_t> order(soup.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return is_less(soup, a, b); });
  std::vector<bool> is_copy(soup.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    is_copy[order[i]] = soup.is_opaque(order[i]) && !is_less(soup, order[i - 1], order[i]);
  }
  std::vector<culler::PolygonRange> ranges;
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    if (!is_copy[p]) culler::append_range(ranges, {p, 1});
  }
  return ranges;
}

}  // namespace

/// The offsets are the centres of the cells of a 4 by 4 grid over a pixel.
glm::dvec2 ItemBuffers::offset_of(std::size_t turn) {
  const std::size_t cell = turn % kOffsets;
  return {(static_cast<double>(cell % 4) - 1.5) / 4, (static_cast<double>(cell / 4) - 1.5) / 4};
}

/// Every size gets every offset: after each round of offsets the sizes move on by one.
std::size_t ItemBuffers::size_of(std::size_t turn) const { return (turn + turn / kOffsets) % sizes(); }

ItemBuffers::ItemBuffers(culler::SoupView soup, int width, int height)
    : soup_(soup), context_(render::make_offscreen_context()), drawn_(without_copies(soup)) {
  for (const int times : {1, 2, 3}) {
    if (times > 1 && (width * times > kLargest || height * times > kLargest)) break;
    renderers_.push_back(
        {width * times, height * times, std::make_unique<render::SceneRenderer>(soup, width * times, height * times)});
  }
}

render::ItemBuffer ItemBuffers::draw(std::size_t turn, const culler::Camera& camera) {
  return renderers_[size_of(turn)].renderer->item_buffer(camera, drawn_, offset_of(turn));
}

std::string ItemBuffers::describe(std::size_t turn) const {
  const Sized& sized = renderers_[size_of(turn)];
  const glm::dvec2 offset = offset_of(turn);
  return fmt::format("{}x{} pixels, moved by {:g}, {:g}", sized.width, sized.height, offset.x, offset.y);
}

render::Image ItemBuffers::picture(const culler::Camera& camera, const std::vector<culler::PolygonRange>& marked) {
  return marked_picture(soup_, *renderers_[0].renderer, camera, marked);
}

}  // namespace occlude::cli
