// SPDX-License-Identifier: MIT
// The module of the rivals that were installed when it was built.
#include "rivals.h"

using namespace occlude::experiments;

extern "C" __attribute__((visibility("default"))) AppendRivals occlude_append_rivals;

void occlude_append_rivals([[maybe_unused]] const occlude::culler::Hierarchy& tree,
                           [[maybe_unused]] const std::vector<RayPicture>& pictures, std::vector<Rival>& rivals) {
#ifdef OCCLUDE_RIVAL_EMBREE
  rivals.push_back({{"Embree", OCCLUDE_RIVAL_EMBREE}, embree_ways(tree, pictures)});
#endif
#ifdef OCCLUDE_RIVAL_OSG
  rivals.push_back({{"OpenSceneGraph", OCCLUDE_RIVAL_OSG}, osg_ways(tree)});
#endif
}
