// SPDX-License-Identifier: MIT
// What is worth drawing into the coarse picture: what closes enough of it. This decides how much is culled, never whether it
// may be.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace occlude::culler {

/// What closes fewer pixels is not worth drawing. The limits below are shares and multiples of this one. As a limit for
/// sheets it leaves undrawn, and what is left undrawn would have brought nearer, of all pixels that are brought nearer:
///
///   pixels   triangles of the castle   of Utrecht and Sponza
///        8   a third, 0.2 %            an eighth, 0.03 to 0.1 %
///       16   two fifths, 0.5 %         a seventh, 0.06 to 0.3 %
inline constexpr int kWorthPixels = 8;

/// A leaf that is seen through fewer pixels shows through slits that nothing closes. With half of this, frames of models
/// would draw 50 % more triangles and cull only a few thousandths more. An occluder of a scene costs more, because it is
/// found in two trees: with the limit of a leaf, a cull takes 8 % longer and draws 1 % fewer objects.
inline constexpr int kWorthOfLeaf = kWorthPixels, kWorthOfOccluder = kWorthPixels * 3 / 2;

/// The more a frame has drawn, the less another leaf is worth: the limit is the number of its triangles over 512, but at
/// least the limit above and at most three times kWorthPixels. Frames of up to 4,096 triangles stay as they are. The castle
/// and Sponza, of 18,000 to 28,000, draw half to two thirds of that, take 0.7 to 0.8 of the time, and cull less: of what is
/// hidden 0.2 to 0.8 % in the castle, 1 to 5 % in Sponza.
inline constexpr std::size_t kTrianglesOfPixel = 512, kMostWorth = std::size_t{3} * kWorthPixels;

/// Through how many pixels a leaf must be seen to be worth drawing, at least so many, once so many triangles are drawn.
[[nodiscard]] inline int worth_closing(int least, std::size_t triangles) {
  return std::max(least, static_cast<int>(std::min(triangles / kTrianglesOfPixel, kMostWorth)));
}

/// How many pixels the picture of a frame with a budget for so many triangles may have. A smaller picture finds less, in
/// less time. With a quarter of a millisecond, frames of 20,000 pixels cull twice as much of the models tried as those of
/// 200,000, with half of one 34,000 cull a fifth more, with one 57,000 a twentieth, and with two 95,000 as much. This power
/// of the triangles goes through these, which were the best of 10,000 to 200,000 pixels. It is taken by square roots, which
/// are the same on every machine.
[[nodiscard]] inline double pixels_of_budget(double triangles) {
  constexpr double kPixels = 160;
  return kPixels * std::sqrt(triangles * std::sqrt(triangles));
}

/// With a budget for so many triangles, a leaf must be seen through twice as many pixels as the picture of so many pixels
/// has for each of them: large leaves are drawn first, wherever they are. Frames of a quarter of a millisecond to two cull a
/// tenth to a half more of Utrecht and the castle with it. From half to ten times as many pixels were tried. A budget for
/// more than kAmple is nearly enough for everything. Then what hides best is what is nearest, and the pixels fall with the
/// square.
inline constexpr double kAmple = 5000;
[[nodiscard]] inline int worth_of_budget(int pixels, double triangles) {
  const double share = 2.0 * pixels / std::max(triangles, 1.0);
  return static_cast<int>(std::min({share, share * kAmple / std::max(triangles, 1.0), static_cast<double>(pixels)}));
}

/// The polygons of a leaf that cover fewer pixels together are not worth drawing, in how many pixels ever the box of the
/// leaf is seen: half of kWorthPixels, because with other leaves they may close more. With this limit the models tried draw
/// 15 to 45 % fewer triangles, and of what is hidden they cull 0.13 % less to 1.5 % more. With three quarters of
/// kWorthPixels, they cull up to 7 % less.
inline constexpr double kWorthOfPolygons = kWorthPixels / 2.0;

}  // namespace occlude::culler
