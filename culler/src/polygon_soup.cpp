// SPDX-License-Identifier: MIT
#include "occlude/culler/polygon_soup.h"

#include "bounds.h"

namespace occlude::culler {

kernel::Aabb PolygonSoup::box(std::size_t p) const {
  kernel::Aabb box = empty_box();
  for (const std::uint32_t index : loop(p)) grow(box, to_kernel(vertices[index]));
  return box;
}

}  // namespace occlude::culler
