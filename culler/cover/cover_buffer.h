// SPDX-License-Identifier: MIT
// Joined shadows in a coarse picture: for each pixel, how near something is that all its rays meet.
//
// A pixel is a convex cone of rays. Where all of them meet a mesh, everything farther than the mesh is hidden there. A box
// is hidden when this holds in every pixel that it touches. The answer is never wrong: all rounding errors of positions and
// depths are bounded and accounted for (conservative_viewport.h, sheet_rasteriser.h, projected_boxes.h).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "cover/conservative_viewport.h"
#include "cover/cover_mesh.h"
#include "cover/layer_erosion.h"
#include "cover/projected_boxes.h"
#include "cover/sheet_rasteriser.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

class CoverBuffer {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// Starts a picture of this size in which all pixels are open. It is the camera's picture and a border around it, a
  /// sixth of the shorter side wide. `margin` is a share of the height of the camera's picture. With a margin above 0, a box
  /// counts as hidden only if it stays hidden however it is moved by the margin in the picture, and however a renderer in
  /// single precision moves it and what hides it. REQUIRES: width and height are multiples of kTile; margin >= 0.
  void begin(const FrameView& view, int width, int height, double margin);

  /// Reserves memory for meshes of this many triangles.
  void reserve(std::size_t triangles) { rasteriser_.reserve(triangles); }

  /// Whether it is of several eyes. Then it has several layers, and each box asks two of them.
  [[nodiscard]] bool is_of_region() const { return picture_.is_of_region(); }

  /// Whether all the work that a picture may take is done. From then on add() closes nothing.
  [[nodiscard]] bool is_spent() const { return work_ > kMostWork * boxes_.layers.count; }

  /// From now on, keeps for each pixel the mesh that last brought it nearer.
  void keep_owners();

  /// Pixels of a tile that a mesh brought nearer.
  struct Closing {
    std::uint32_t tile, id;
    std::uint64_t pixels;  ///< as cover_tile.h has them
  };
  /// From now on, keeps what each mesh brings nearer. REQUIRES: the picture is of one eye.
  void keep_closings();
  /// In the order in which it was added.
  [[nodiscard]] std::span<Closing> closings() { return closings_; }

  /// Closes the pixels that the mesh closes as far as it is beyond the near plane. `id` identifies it in owners(). Layers
  /// that are much farther than the mesh are left to join_layers().
  void add(const CoverMesh& mesh, std::uint32_t id = 0);

  /// In a picture of several eyes, closes pixels through which only closed pixels of a nearer layer are seen, of what was
  /// added so far.
  void join_layers();

  /// Where a box is in the picture.
  struct Footprint {
    PixelRectangle pixels;  ///< those that it touches, with the margin
    float most;             ///< no point of it is nearer
    bool is_in_picture;     ///< all of it is, and beyond the near plane
    int first_tile = 0;     ///< of the layer

    /// How many pixels it has.
    [[nodiscard]] int size() const { return std::max(pixels.x1 - pixels.x0, 0) * std::max(pixels.y1 - pixels.y0, 0); }
  };
  [[nodiscard]] Footprint footprint(const kernel::Aabb& box) const { return footprint(seen(box), 0); }
  /// The footprint of box i of those that were seen in box_picture().
  [[nodiscard]] Footprint footprint(const BoxPixels& boxes, std::size_t i) const;
  [[nodiscard]] const BoxPicture& box_picture() const { return boxes_; }
  /// No less than the width and the height of box i in the picture, as a share of the height of the camera's picture;
  /// infinity if its position is unknown, or the picture is of several eyes.
  [[nodiscard]] float seen_size(const ProjectedBoxes& boxes, std::size_t i) const;

  /// True only if each point of the box has a point of one of the meshes, beyond the near plane, strictly between it and the
  /// viewpoint. False for a box that reaches beyond the picture or before the near plane. REQUIRES: the box is no farther
  /// from the eye than the depth of the view.
  [[nodiscard]] bool hides(const kernel::Aabb& box) const { return hidden(seen(box), 1) != 0; }
  [[nodiscard]] bool hides(const Footprint& box) const;
  /// Those of the asked boxes that are hidden.
  [[nodiscard]] kernel::BoxBits hidden(const BoxPixels& boxes, kernel::BoxBits asked) const {
    return culler::hidden(tile_picture(), boxes, asked);
  }
  [[nodiscard]] kernel::BoxBits hidden(const ProjectedBoxes& boxes, kernel::BoxBits asked) const {
    const kernel::BoxBits found = hidden(static_cast<const BoxPixels&>(boxes), asked);
    if (!is_of_region() || found == asked) return found;
    return static_cast<kernel::BoxBits>(found | hidden(boxes.nearer_layer, static_cast<kernel::BoxBits>(asked & ~found)));
  }
  /// Why the box is not hidden; `none` if it is.
  enum class Gap { none, beyond_picture, open, not_behind };
  [[nodiscard]] Gap gap(const kernel::Aabb& box) const;

  /// How many of the pixels that the box touches do not hide it. Counting stops at `enough`. A box in the picture is hidden
  /// if the result is 0.
  [[nodiscard]] int open(const Footprint& box, int enough) const {
    return open_pixels(tile_picture().from(box.first_tile), box.pixels, box.most, enough);
  }

  /// A mesh that closes pixels of a box, and the rectangle of positions that holds these pixels as far as the box may reach.
  struct Owner {
    std::uint32_t id;
    PixelBounds places;
  };
  /// In ascending order of ids. REQUIRES: keep_owners() was called before what hides the box was added; hides(box); the
  /// picture is of one eye.
  [[nodiscard]] std::vector<Owner> owners(const kernel::Aabb& box) const;

  /// A sheet that was drawn into a picture of several eyes: triangles of a mesh.
  struct DrawnSheet {
    std::uint32_t id;  ///< of the mesh
    std::vector<std::uint32_t> triangles;
  };
  /// Pixels of a layer that are closed by one sheet, or through the next nearer layer.
  struct Window {
    PixelRectangle pixels;
    std::uint32_t sheet;  ///< kNone: through the nearer layer

    [[nodiscard]] bool is_of_nearer_layer() const { return sheet == kNone; }
  };
  struct Windows {
    double focus;  ///< of the layer
    std::vector<Window> windows;
  };
  /// Where a box is hidden, in a picture of several eyes. REQUIRES: hides(box).
  [[nodiscard]] Footprint hidden_at(const kernel::Aabb& box) const;
  /// The footprint, in the same layer, of a box that lies in one of this footprint.
  [[nodiscard]] Footprint within(const Footprint& whole, const kernel::Aabb& box) const;
  /// Windows that have all pixels of a footprint in which a box is hidden. REQUIRES: keep_owners() was called before what
  /// hides it was added; the picture is of several eyes.
  [[nodiscard]] Windows windows(const Footprint& at) const;
  /// The pixels of the next nearer layer through which a window of the footprint is closed. REQUIRES: it
  /// is_of_nearer_layer().
  [[nodiscard]] Footprint through(const Footprint& at, const Window& window) const;
  [[nodiscard]] const DrawnSheet& sheet(std::uint32_t i) const { return sheets_[i]; }

  [[nodiscard]] const ConservativeViewport& picture() const { return picture_; }
  /// The mesh that was added last, as it was drawn.
  [[nodiscard]] const SheetRasteriser& piece() const { return rasteriser_; }

 private:
  /// The tiles of sheets and triangles that a layer of a picture may take. A tile takes some nanoseconds, so this is about a
  /// tenth of a second. The models tried take a tenth of it.
  static constexpr std::size_t kMostWork = std::size_t{1} << 24U;

  /// In the layer that is being drawn.
  [[nodiscard]] std::size_t tile_at(int x, int y) const {
    return first_tile_ + static_cast<std::size_t>(y * tiles_across_ + x);
  }
  template <class NearnessFrom>
  [[nodiscard]] std::optional<PixelRectangle> tiles_nearer(const PixelRectangle& r, const NearnessFrom& nearness_from) const;
  [[nodiscard]] std::size_t first_layer_of_mesh() const;
  void add_layer(std::uint32_t id);
  void add_sheet(const PixelRectangle& tiles, std::uint32_t id);
  void note_nearest(std::size_t first, std::size_t count);
  void own(std::size_t first, std::size_t count, std::uint32_t id);
  void note_closings(std::size_t first, std::size_t count, std::uint32_t id);
  [[nodiscard]] TilePicture tile_picture() const {
    return {nearness_.data(), farthest_.data(), tiles_across_, picture_.height() / kTile};
  }

  class WindowFinder;

  [[nodiscard]] ProjectedBoxes seen(const kernel::Aabb& box) const;
  [[nodiscard]] std::size_t pixel_number(int first_tile, int x, int y) const;
  [[nodiscard]] std::size_t layer_of(const Footprint& box) const {
    return static_cast<std::size_t>(box.first_tile / boxes_.tiles_of_layer);
  }

  ConservativeViewport picture_;
  PixelPosition share_of_pixel_;  ///< the width and the height of a pixel, as shares of the height of the camera's picture
  BoxPicture boxes_;              ///< with the margin
  SheetRasteriser rasteriser_;
  LayerErosion erosion_;
  int tiles_across_ = 0;
  std::size_t first_tile_ = 0;
  std::size_t work_ = 0;
  std::vector<float> nearness_;            ///< of each pixel, layer after layer, tile after tile; -infinity while it is open
  std::vector<float> farthest_;            ///< of each tile, the least nearness of its pixels
  std::vector<float> nearest_;             ///< the same, the most; empty in a picture of one eye
  std::vector<std::uint8_t> has_changed_;  ///< of each tile of several eyes, as LayerErosion::Layers has it
  std::vector<std::uint32_t> owners_;  ///< ids, or numbers of sheets, in the order of nearness_; empty unless they are kept
  std::vector<float> owned_;           ///< how near the owners are: less than nearness_ where join_layers() found more
  std::vector<DrawnSheet> sheets_;     ///< of several eyes, as owners_
  bool keeps_closings_ = false;
  std::vector<Closing> closings_;
};

}  // namespace occlude::culler
