// SPDX-License-Identifier: MIT
#include "frusta/frusta_memory.h"

#include <algorithm>
#include <utility>

namespace occlude::culler {

void FrustaMemory::take_casters(const CullResult& frame, const OccluderSet* occluders, kernel::Near near) {
  frusta.clear();
  casters.clear();
  for (const std::vector<Occluder>* used : {&frame.occluders, &std::as_const(probes)}) {
    for (const auto& [index, frustum, hidden] : *used) {
      frusta.push_back(&frustum);
      const bool is_flat = !frustum.support_plane() && !occluders->is_shell(index);
      casters.push_back({occluders->parts(index), near == kernel::Near::surface && is_flat});
    }
  }
}

void FrustaMemory::shrink_shadows(const Frame& frame) {
  const std::vector<Occluder>& occluders = frame.result.occluders;
  shrunk.resize(std::max(shrunk.size(), occluders.size()));
  for (std::size_t i = 0; i < occluders.size(); ++i) shrunk[i].assign(frame.margin, occluders[i].frustum);
}

void FrustaMemory::keep_spare(CullResult& frame) {
  for (Occluder& occluder : frame.occluders) spare.push_back(std::move(occluder.frustum));
  for (Occluder& occluder : probes) spare.push_back(std::move(occluder.frustum));
  frame.occluders.clear();
  probes.clear();
}

}  // namespace occlude::culler
