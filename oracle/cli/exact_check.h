// SPDX-License-Identifier: MIT
// The culled triangles of small models held against exact visibility.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "occlude/culler/hierarchy.h"
#include "occlude/render/camera_path.h"
#include "proof.h"

namespace occlude::cli {

class ExactCheck {
 public:
  /// `hierarchy` gives the order in which a witness counts triangles; `aspect` is the picture's width over height.
  ExactCheck(const culler::Hierarchy& hierarchy, const render::CameraPath& path, double aspect);

  /// Adds what a witness says is culled.
  void add(const Proof& proof);

  struct Result {
    std::size_t frames = 0;          ///< in which something was culled
    std::size_t culled_showing = 0;  ///< triangles that are culled and show, over all frames
    std::string first;               ///< of these the first
  };
  /// On all processors, with progress.
  [[nodiscard]] Result result() const;

 private:
  const culler::Hierarchy& hierarchy_;
  const render::CameraPath& path_;
  double aspect_;
  std::size_t triangles_;
  std::map<std::size_t, std::vector<bool>> culled_;  ///< of each frame, triangle by triangle
};

}  // namespace occlude::cli
