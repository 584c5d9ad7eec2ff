// SPDX-License-Identifier: MIT
// The route of the camera through the model, in plan, and the space kept free along it.
#pragma once

#include <cstddef>
#include <vector>

#include "builder.h"
#include "occlude/render/camera_path.h"
#include "terrain.h"
#include "units.h"

namespace occlude::render::city {

/// The route as a chain of points about a metre apart or closer, z is the height of the ground.
class Route {
 public:
  explicit Route(const Terrain& terrain);

  [[nodiscard]] Length length() const { return at_.back(); }
  /// The ground under the route, `distance` along it (clamped to its ends).
  [[nodiscard]] Point point(Length distance) const;
  /// Whether something standing on `rect` would be within `kClearance` (in plan) of the route.
  [[nodiscard]] bool crosses(const Rect& rect) const;
  /// The same with another margin.
  [[nodiscard]] bool crosses(const Rect& rect, Length margin) const;

  static constexpr Length kClearance = m(1.5);

 private:
  std::vector<Point> points_;
  std::vector<Length> at_;  ///< distance of each point from the start
  /// Bounds of runs of kChunk points, for `crosses`.
  static constexpr std::size_t kChunk = 64;
  std::vector<Rect> chunks_;
};

/// Level ground in pieces of about `cell`, each cut into `parts` x `parts` where the camera passes within 9 m. Large pieces
/// near the camera would be chosen as occluders instead of walls.
void build_pavement(Builder& b, const Route& route, const Rect& rect, Length z, Length cell, Length parts);

/// The camera path of 2748 frames (as many as the paper's) along `route`.
[[nodiscard]] CameraPath film(const Route& route, const Terrain& terrain);

/// The middle line of the lane through the hills, west to east; the route follows it.
[[nodiscard]] const std::vector<Point>& lane();

}  // namespace occlude::render::city
