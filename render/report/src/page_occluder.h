// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "frusta/occluder_set.h"
#include "page_model.h"

namespace occlude::render {

/// A potential occluder as a page has it.
struct PageOccluder {
  PageOccluder(const culler::OccluderSet& occluders, std::uint32_t index, const PageModel& model)
      : is_shell(occluders.is_shell(index)) {
    for (const std::uint32_t part : occluders.parts(index)) {
      if (model.place(part) != PageModel::kNone) places.push_back(model.place(part));
    }
  }

  std::vector<std::uint32_t> places;  ///< of its polygons that the page has
  bool is_shell;
};

}  // namespace occlude::render
