// SPDX-License-Identifier: MIT
// Carries what is closed in a layer of a picture of several eyes into the next farther layer.
//
// Sheets are drawn one by one, and in a layer that is focused beyond them their borders are wide. So where two of them meet,
// a gap stays open, although no eye sees through it. In a layer that is focused near them the gap is as narrow as in a
// picture of one eye. It is closed there if the sheets overlap, and farther layers take that over.
//
// A ray has a position in each layer. Let f be the focus of a layer and g that of a nearer one. The ray of an eye e that has
// the position u in the layer passes the plane in focus at a point of nearness f. So in the nearer layer it has the position
//
//   u + (g - f) (e.xy - e.z u) / (1 - e.z f),
//
// like every such point (eye_moves.h). Because e.z g < 1, it grows with u. So the rays of a pixel pass the nearer layer in a
// rectangle of pixels. If all of these are closed, all rays of the pixel meet something, and it is nowhere less near than
// the least near of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cover/conservative_viewport.h"
#include "cover/focus_layers.h"

namespace occlude::culler {

class LayerErosion {
 public:
  /// For the layers of this picture, of several eyes. REQUIRES: its width and height are multiples of kTile.
  void begin(const ConservativeViewport& picture, const FocusLayers& layers);

  /// The numbers of two layers, one after the other, tile after tile.
  struct Layers {
    float* nearness;            ///< of each pixel
    float *nearest, *farthest;  ///< of each tile, the most and the least of its pixels
    /// Of each tile, not 0 if a pixel may have come nearer since the layer was last the nearer one.
    std::uint8_t* has_changed;
  };
  /// Brings those pixels of a layer nearer that are closed as seen through the next nearer one. Leaves tiles as they are in
  /// which no pixel would come nearer by much. What is not nearer than `never` does not count in the nearer layer. Each call
  /// for a layer takes up what has changed since the last.
  void erode(std::size_t layer, float never, const Layers& layers);

  /// The pixels of the next nearer layer through which the rays of these pixels pass. They may be beyond the picture.
  [[nodiscard]] PixelRectangle through(std::size_t layer, const PixelRectangle& pixels) const;

  /// The rays of pixel i pass the pixels from i + low to i + high of the nearer layer. Neither is on the other side of i.
  struct Reach {
    /// Where rays may pass more pixels beside their own, nothing is taken over.
    static constexpr int kMost = 32;

    int low = -kMost - 1, high = kMost + 1;

    /// Of the pixels. REQUIRES: it is not too far.
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(high - low + 1); }
    [[nodiscard]] bool is_too_far() const { return low < -kMost || high > kMost; }
  };

 private:
  std::size_t tiles_across_ = 0, tiles_up_ = 0;
  std::array<std::vector<Reach>, FocusLayers::kMost> across_, up_;  ///< of each column, and of each row, of tiles
  std::vector<float> strip_, rows_;                                 ///< room for erode()
  std::vector<std::uint8_t> wanted_;
};

}  // namespace occlude::culler
