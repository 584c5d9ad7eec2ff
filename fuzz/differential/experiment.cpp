// SPDX-License-Identifier: MIT
#include "experiment.h"

#include <utility>

#include "overlap.h"
#include "rows.h"

namespace occlude::fuzz {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all = [] {
    std::vector<Experiment> list;
    for (const Family family : families()) {
      list.push_back(
          {std::string(name(family)), [=](std::uint64_t seed, Report& report) { run_overlap(family, seed, report); }});
    }
    list.push_back({"spoiled", run_refusals});
    list.push_back({"frustum_batch", run_frustum_batch});
    list.push_back({"union", run_unions});
    list.push_back({"view_frustum", run_view_frusta});
    list.push_back({"cones", run_cones});
    list.push_back({"occludees", run_occludees});
    for (const auto& [name, kind] :
         {std::pair{"umbra", kernel::ShadowKind::umbra}, {"penumbra", kernel::ShadowKind::penumbra}}) {
      list.push_back({name, [kind](std::uint64_t seed, Report& report) { run_region_shadows(kind, seed, report); }});
    }
    list.push_back({"cover", run_covers});
    list.push_back({"culler", run_culling});
    list.push_back({"forgery", run_forgeries});
    list.push_back({"region_forgery", run_region_forgeries});
    list.push_back({"joined", run_joined});
    list.push_back({"region", run_regions});
    list.push_back({"world", run_worlds});
    list.push_back({"simplified", run_simplified});
    return list;
  }();
  return all;
}

}  // namespace occlude::fuzz
