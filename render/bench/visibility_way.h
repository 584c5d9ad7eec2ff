// SPDX-License-Identifier: MIT
// A way to tell which leaves of a tree a camera must draw: ours, or one of another project.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::experiments {

class VisibilityWay {
 public:
  virtual ~VisibilityWay() = default;
  /// Called before the first frame of a path.
  virtual void restart() {}
  /// Called before the cull of each frame, in ascending order, and not timed.
  virtual void move_to(std::size_t /*frame*/) {}
  /// What is timed. It ends when what is to be drawn is known, be it in any form.
  virtual void cull(const culler::Camera& camera) = 0;
  /// Whole leaves that the last cull leaves to be drawn, in ascending order.
  [[nodiscard]] virtual std::vector<culler::PolygonRange> drawn() const = 0;
};

/// A way before it is prepared for the model.
struct UnpreparedWay {
  std::string project, name;
  std::function<std::unique_ptr<VisibilityWay>()> prepare;
};

}  // namespace occlude::experiments
