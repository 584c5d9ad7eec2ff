// SPDX-License-Identifier: MIT
// Whether any box would be visible in the last frame of a view.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>

#include "base/each_bit.h"
#include "camera/frame_view.h"
#include "cover/cover_buffer.h"
#include "cover/projected_boxes.h"
#include "model/bounds.h"
#include "model/legal_soup.h"
#include "model/outer_box.h"
#include "occlude/culler/box.h"
#include "occlude/culler/cull_result.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// The half-spaces have a margin for what reaches as far as the model. For a box that reaches farther they are moved
/// outwards by the margin of that box. This also covers the rounding of the sum, because the offset has room for more
/// roundings than it took. Normals are no longer than 1.
template <class AnyBox>
[[nodiscard]] bool is_out_of_view(const FrameView& view, std::span<const HalfSpace> half_spaces, const AnyBox& box) {
  const double own_reach = depth(outer_box(box), view.eye);
  const double farther = own_reach > view.depth ? own_reach : 0;
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    const HalfSpace& h = half_spaces[i];
    const double offset = h.offset + view.half_space_margins[i] * farther;
    if (kernel::check(offset) != kernel::Refusal::none) continue;
    const kernel::Relation relation = kernel::relation({to_kernel(h.normal), offset}, box, kernel::Arithmetic::certified);
    if (relation == kernel::Relation::outside) return true;
  }
  return false;
}

/// The error bounds of the cover hold within its depth. A cover without a picture, before the first frame, hides nothing.
[[nodiscard]] inline bool hides_any(const CoverBuffer& cover, const Box& box) {
  const kernel::Aabb outer = outer_box(box);
  const ConservativeViewport& picture = cover.picture();
  return picture.width() > 0 && depth(outer, picture.eye()) <= picture.depth() && cover.hides(outer);
}

/// Calls hide(i) for those of the asked boxes that the cover hides as hides_any() says, eight at a time. `asked` are numbers
/// of boxes.
template <class Hide>
void for_each_hidden(const CoverBuffer& cover, std::span<const kernel::Aabb> boxes, std::span<const std::uint32_t> asked,
                     const Hide& hide) {
  const ConservativeViewport& picture = cover.picture();
  std::array<std::uint32_t, ProjectedBoxes::kMost> numbers{};
  ProjectedBoxes several;
  const auto ask = [&] {
    several.project(cover.box_picture());
    for_each_bit(cover.hidden(several, several.all()), [&](std::uint32_t i) { hide(numbers[i]); });
    several.size = 0;
  };
  for (const std::uint32_t i : asked) {
    if (depth(boxes[i], picture.eye()) > picture.depth()) continue;
    numbers[several.size] = i;
    several.add(cover.box_picture(), boxes[i]);
    if (several.size == ProjectedBoxes::kMost) ask();
  }
  if (several.size > 0) ask();
}

/// is_hidden(box) is asked of a box in view. Throws as View::visibility().
template <class IsHidden>
[[nodiscard]] Visibility visibility_of(const Box& box, const FrameView& view, std::span<const HalfSpace> half_spaces,
                                       const IsHidden& is_hidden) {
  require_rounding();
  return std::visit(
      [&](const auto& b) {
        if (const kernel::Refusal refusal = kernel::check(b); refusal != kernel::Refusal::none) {
          throw std::invalid_argument(std::string(kernel::to_string(refusal)));
        }
        return is_out_of_view(view, half_spaces, b) ? Visibility::out_of_view
               : is_hidden(b)                       ? Visibility::occluded
                                                    : Visibility::visible;
      },
      box);
}

}  // namespace occlude::culler
