// SPDX-License-Identifier: MIT
// How often each polygon was drawn though it is hidden.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "occlude/culler/cull_result.h"
#include "page_model.h"

namespace occlude::render {

class PageVain {
 public:
  /// `model` must stay as long as this object.
  explicit PageVain(const PageModel& model) : model_(model), frames_(model.polygons()) {}

  /// `visible` are polygons of the tree, ascending.
  void add(const culler::CullResult& frame, std::span<const std::uint32_t> visible);

  /// For each polygon of the page the number of frames that drew it in vain.
  [[nodiscard]] const std::vector<std::uint32_t>& frames() const { return frames_; }
  [[nodiscard]] std::string packed() const;

 private:
  const PageModel& model_;
  std::vector<std::uint32_t> frames_;
};

}  // namespace occlude::render
