// SPDX-License-Identifier: MIT
#include "cover/focus_layers.h"

#include <algorithm>
#include <limits>
#include <span>

namespace occlude::culler {
namespace {

/// What is in focus a little farther away than a box moves by many pixels if it is near, and by hardly any if it is far. But
/// far away its depth is bounded well only where a layer is near it in proportion. So a step from a layer to the next is the
/// less of a share of the nearness and of so many pixels that eyes move by, or their harmonic sum. This many pixels are as
/// far as e times the nearness. With 33 or 50, and half of the next constant with 33, models hide the same up to a point or
/// two.
constexpr double kPixelsOfE = 50;
/// So many times as near as where the model ends, and farther, steps are as long as there. For a box once: a cell of space
/// moves even what is far by many pixels.
constexpr double kShareOfDepth = 8, kShareOfDepthOfBox = 1;

/// How many layers there are, and how many beyond a mesh it is drawn into, where the eyes move what is an eighth of the
/// depth away by up to so many pixels. Each takes time, and the less the eyes move, the less is lost between two of them. In
/// two towns, where balls of 0.25 m move it by 0.05 and 0.35 pixels, these cull as much as eight layers, in three quarters
/// of the time. In a castle, where they move it by 1.6, twelve layers and one more beyond each mesh cull 0.1 to 1.3 % more
/// than eight, and take a fifth longer.
struct Enough {
  double pixels;
  std::size_t layers, beyond;
};
constexpr double kAnyMove = std::numeric_limits<double>::infinity();
/// Where a ball moves it by more than three pixels it is in a room. There a second layer beyond each mesh would cull 0.5 %
/// more and take a seventh longer.
constexpr Enough kEnough[]{
    {0.06, 4, 1}, {0.25, 5, 1}, {1, 6, 1}, {3, FocusLayers::kMost, 2}, {kAnyMove, FocusLayers::kMost, 1}};
/// Of boxes of eyes, meshes are drawn into more layers, so that twelve take too long.
constexpr Enough kEnoughOfBox[]{{0.06, 4, 2}, {0.25, 5, 2}, {1, 6, 2}, {kAnyMove, 8, 2}};

Enough enough_layers(const EyeRegion& eyes, double pixels) {
  const auto up_to = [&](const Enough& enough) { return pixels <= enough.pixels; };
  const std::span<const Enough> table = eyes.radius > 0 ? std::span<const Enough>(kEnough) : kEnoughOfBox;
  const auto found = std::find_if(table.begin(), table.end(), up_to);
  return found == table.end() ? table.back() : *found;  // of a move that is not a number
}

/// The nearness of layers, one after the other.
struct Steps {
  double first, depth_share, pixels;

  [[nodiscard]] double next(double nearness, double step) const {
    return nearness + step / (1 / (nearness + depth_share) + pixels / kPixelsOfE);
  }
  [[nodiscard]] double after(std::size_t count, double step) const {
    double nearness = first;
    for (std::size_t k = 0; k < count; ++k) nearness = next(nearness, step);
    return nearness;
  }
};

/// About how many pixels the eyes move a point of nearness 1 by: aside, and what a move ahead makes of a point halfway from
/// the middle of the picture.
double pixels_of_moves(const ConservativeViewport& picture) {
  const double across = picture.scale().x * picture.reach({1, 0, 0}), up = picture.scale().y * picture.reach({0, 1, 0});
  return std::max(across, up) + picture.scale().x * picture.eyes_forward() / 2;
}

}  // namespace

/// The farthest layer is beyond everything.
FocusLayers::FocusLayers(const ConservativeViewport& picture) {
  if (!picture.is_of_region()) return;
  const double most = picture.most_focus(), least = std::min(1 / (2 * picture.depth()), most / 2);
  const double share = picture.eyes().radius > 0 ? kShareOfDepth : kShareOfDepthOfBox;
  const Steps steps{least, share / picture.depth(), pixels_of_moves(picture)};
  const Enough enough = enough_layers(picture.eyes(), steps.pixels * kShareOfDepth / picture.depth());
  count = enough.layers;
  beyond = enough.beyond;
  // With the longest step the second layer is beyond `most`. Forty halvings leave less than a float can tell.
  double low = 0, high = (most - least) * (1 / (least + steps.depth_share) + steps.pixels / kPixelsOfE);
  for (int halving = 0; halving < 40; ++halving) {
    const double step = (low + high) / 2;
    (steps.after(count - 1, step) < most ? low : high) = step;
  }
  constexpr double kRoundedUp = 1 + 0x1p-23;
  for (std::size_t k = 0; k < count; ++k) focus[k] = static_cast<float>(steps.after(k, low) / kRoundedUp);
}

}  // namespace occlude::culler
