// SPDX-License-Identifier: MIT
// Joined shadows in a coarse picture: of each pixel, how near something is that all its rays meet.
//
// A pixel is a convex cone of rays. Where all of them meet a mesh, all that is farther than the mesh is there is hidden. A
// box is hidden when that is so in every pixel that it touches. What is found is never wrong: numbers are rounded in
// doubles, and by how much is accounted for (beam_picture.h, cover_piece.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "beam_picture.h"
#include "cover_mesh.h"
#include "cover_piece.h"
#include "occlude/kernel/types.h"
#include "seen_boxes.h"

namespace occlude::culler {

class CoverBuffer {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// Opens all pixels of a picture of a size, multiples of kTile. The picture is the camera's, and 16 pixels
  /// more on each side. With a `margin`, a share of the height of the camera's
  /// picture, a box counts as hidden only when it stays so however a renderer in single precision moves it, and what hides
  /// it, and however it is moved by the margin in the picture. REQUIRES: margin >= 0.
  void begin(const FrameView& view, int width, int height, double margin);

  /// Makes room for meshes of so many triangles.
  void reserve(std::size_t triangles) { piece_.reserve(triangles); }

  /// Whether as much was drawn since begin() as may be: from then on nothing is closed.
  [[nodiscard]] bool is_spent() const { return work_ > kMostWork; }

  /// From now on it is kept which mesh was the last to bring a pixel nearer.
  void keep_owners();

  /// Closes what the mesh closes, as far as it is beyond the near plane. `id` is what owners() calls it.
  void add(const CoverMesh& mesh, std::uint32_t id = 0);

  /// Where a box is in the picture.
  struct Footprint {
    PixelRectangle pixels;  ///< that it touches, with the margin
    float most;             ///< nothing of it is nearer
    bool is_in_picture;     ///< all of it, and beyond the near plane
  };
  [[nodiscard]] Footprint footprint(const kernel::Aabb& box) const { return footprint(seen(box), 0); }
  /// Of one of several that were seen in box_picture().
  [[nodiscard]] Footprint footprint(const SeenBoxes& boxes, std::size_t i) const;
  [[nodiscard]] const BoxPicture& box_picture() const { return boxes_; }

  /// True only when every point of the box has one of the meshes, beyond the near plane, strictly between it and the
  /// viewpoint. REQUIRES: a box no farther from the eye than the depth of begin(). False of a box that reaches beyond the
  /// picture, or before the near plane.
  [[nodiscard]] bool hides(const kernel::Aabb& box) const { return hides(footprint(box)); }
  [[nodiscard]] bool hides(const Footprint& box) const;
  /// Why it does not hide the box; none where it does.
  enum class Gap { none, beyond_picture, open, not_behind };
  [[nodiscard]] Gap gap(const kernel::Aabb& box) const;

  /// How many pixels of the picture that the box touches do not hide it: counted until there are enough. 0 of a box in the
  /// picture when it is hidden.
  [[nodiscard]] int open(const Footprint& box, int enough) const { return open(box.pixels, box.most, enough); }

  /// A mesh that closes pixels of a box, and the places between which these are, as far as the box may reach.
  struct Owner {
    std::uint32_t id;
    PlaceRectangle places;
  };
  /// By ascending ids. REQUIRES: keep_owners() before what hides the box was added; hides(box).
  [[nodiscard]] std::vector<Owner> owners(const kernel::Aabb& box) const;

  [[nodiscard]] const BeamPicture& picture() const { return picture_; }
  /// The mesh that was added last, as it was drawn.
  [[nodiscard]] const CoverPiece& piece() const { return piece_; }

 private:
  /// Tiles of each sheet, and of each triangle, some nanoseconds each: a tenth of a second or so. The models tried take
  /// a tenth of it.
  static constexpr std::size_t kMostWork = std::size_t{1} << 24U;

  /// Those of the piece's tiles between which all lie that it may close or bring nearer; none where there are none.
  [[nodiscard]] std::optional<PixelRectangle> tiles_to_draw() const;
  void add_sheet(const PixelRectangle& tiles, std::uint32_t id);
  void close(std::size_t tile, std::uint64_t pixels, float nearness, std::uint32_t id);
  /// How many pixels of the rectangle do not hide what is no nearer than `most`: counted until there are enough.
  [[nodiscard]] int open(const PixelRectangle& r, float most, int enough) const {
    return open_pixels({nearness_.data(), farthest_.data(), tiles_across_}, r, most, enough);
  }

  [[nodiscard]] SeenBoxes seen(const kernel::Aabb& box) const;

  BeamPicture picture_;
  BoxPicture boxes_;  ///< with the margin
  CoverPiece piece_;
  int tiles_across_ = 0;
  std::size_t work_ = 0;
  std::vector<float> nearness_;        ///< of each pixel, tile after tile; -infinity while it is open
  std::vector<float> farthest_;        ///< of each tile, the least of it
  std::vector<std::uint32_t> owners_;  ///< as nearness_; empty unless they are kept
};

}  // namespace occlude::culler
