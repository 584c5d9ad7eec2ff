// SPDX-License-Identifier: MIT
#include "peers.h"

namespace occlude::bench {

// The build defines the version of each library that it found.
std::vector<Peer> peers() {
  return {
#ifdef OCCLUDE_BENCH_LIBCCD
      {"libccd", OCCLUDE_BENCH_LIBCCD, libccd_subjects()},
#else
      {"libccd", {}, {}},
#endif
#ifdef OCCLUDE_BENCH_FCL
      {"FCL", OCCLUDE_BENCH_FCL, fcl_subjects()},
#else
      {"FCL", {}, {}},
#endif
#ifdef OCCLUDE_BENCH_BULLET
      {"Bullet", OCCLUDE_BENCH_BULLET, bullet_subjects()},
#else
      {"Bullet", {}, {}},
#endif
#ifdef OCCLUDE_BENCH_OSG
      {"OpenSceneGraph", OCCLUDE_BENCH_OSG, osg_subjects()},
#else
      {"OpenSceneGraph", {}, {}},
#endif
  };
}

}  // namespace occlude::bench
