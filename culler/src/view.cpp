// SPDX-License-Identifier: MIT
#include "occlude/culler/view.h"

#include <utility>

#include "view_memory.h"

namespace occlude::culler {

View::View() : memory_(std::make_unique<Memory>()) {}
View::~View() = default;
View::View(View&&) noexcept = default;
View& View::operator=(View&&) noexcept = default;

const CullResult& View::result() const { return memory_->result; }

void View::Memory::begin_frame() {
  for (Occluder& occluder : result.occluders) spare.push_back(std::move(occluder.frustum));
  for (Occluder& occluder : probes) spare.push_back(std::move(occluder.frustum));
  probes.clear();
  result.drawn.clear();
  result.culled.clear();
  result.view.clear();
  result.occluders.clear();
  result.stats = {};
  pairs.clear();
}

}  // namespace occlude::culler
