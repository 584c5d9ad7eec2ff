// SPDX-License-Identifier: MIT
// What is hidden from everywhere in a box of eyes: pictures in all directions, and closer ones where much is still seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// One for each thread.
class HiddenSearch {
 public:
  struct Options {
    int side = 0;                  ///< of a coarse picture in pixels. A closer one of another shape has as many
    double closer = 1;             ///< a closer picture is worth its time with this share of all polygons that are seen
    std::function<void()> before;  ///< called before each picture
    /// Called, if there is one, after each picture that hides polygons of which it was not known. They are given in
    /// ascending order, and then what hides them, and others: all have the picture's eyes. A subtree has one witness if what
    /// hides it has at most `most_corners`.
    std::function<void(const Camera& picture, std::span<const std::uint32_t> found, std::span<const CoverWitness> covers)>
        found = {};
    std::size_t most_corners = 0;
  };

  /// The boxes are those of the polygons of the culler's tree, and others after them. REQUIRES: kernel::check() refuses none
  /// of them; what is given outlives this.
  HiddenSearch(const Culler& culler, std::span<const kernel::Aabb> boxes, Options options);

  /// What is known of each of the boxes.
  struct Known {
    std::vector<std::uint8_t> is_hidden;
    bool has_looked = false;  ///< in all directions, from somewhere
  };
  /// Nothing.
  [[nodiscard]] Known nothing() const { return {std::vector<std::uint8_t>(boxes_.size()), false}; }

  /// Adds what is hidden from everywhere in the box of eyes.
  /// 1. Each segment from the box of eyes to a box that is added, or to its polygon, meets an opaque polygon strictly
  ///    between.
  /// 2. What is added depends on the model, the boxes, the options and what was known alone.
  /// Throws as Culler::cull(), and what `before` throws. REQUIRES: kernel::check() refuses nothing of `eyes`.
  void look_from(const kernel::Aabb& eyes, Known& known);

 private:
  using Polygons = std::vector<std::uint32_t>;

  /// Where a polygon is in a picture: the tangents of the angles to the right and up of the line of sight.
  struct Place {
    std::uint32_t polygon;
    double low_x, low_y, high_x, high_y;
  };

  void look(const Camera& camera, int width, int height);
  void tell(const Camera& camera, const CullResult& frame, std::span<const std::uint32_t> by_themselves);
  void look_closer(const Camera& camera, std::span<Place> places);
  [[nodiscard]] bool is_hidden(std::uint32_t i) const { return known_->is_hidden[i] != 0; }
  struct Places {
    std::vector<Place> small;
    std::size_t large = 0;  ///< how many others
  };
  [[nodiscard]] Places places_of(const Camera& camera, const Polygons& polygons) const;

  const Culler& culler_;
  std::span<const kernel::Aabb> boxes_;
  Options options_;
  kernel::Aabb eyes_{};
  std::size_t few_ = 0;  ///< fewer polygons are not worth a picture
  Known* known_ = nullptr;
  CullOptions cull_;
  View view_;
  Polygons asked_;
  Polygons found_;  ///< by the last picture; only if that is to be told
};

}  // namespace occlude::culler
