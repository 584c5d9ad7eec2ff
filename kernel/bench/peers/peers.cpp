// SPDX-License-Identifier: MIT
#include "peers.h"

namespace occlude::bench {

// The build defines the version of each library that it found.
std::vector<Peer> peers() {
  std::vector<Peer> installed;
#ifdef OCCLUDE_BENCH_LIBCCD
  installed.push_back({"libccd", OCCLUDE_BENCH_LIBCCD, libccd_subjects()});
#endif
#ifdef OCCLUDE_BENCH_FCL
  installed.push_back({"FCL", OCCLUDE_BENCH_FCL, fcl_subjects()});
#endif
#ifdef OCCLUDE_BENCH_BULLET
  installed.push_back({"Bullet", OCCLUDE_BENCH_BULLET, bullet_subjects()});
#endif
#ifdef OCCLUDE_BENCH_OSG
  installed.push_back({"OpenSceneGraph", OCCLUDE_BENCH_OSG, osg_subjects()});
#endif
  return installed;
}

}  // namespace occlude::bench
