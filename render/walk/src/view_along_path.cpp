// SPDX-License-Identifier: MIT
#include "occlude/render/view_along_path.h"

#include "occlude/render/progress.h"

namespace occlude::render {

culler::View& ViewAlongPath::before(std::size_t frame) {
  for (; has_past() && next_ < frame; ++next_) {
    check_interrupt();
    culler_.cull(path_.camera(next_, aspect(walk_)), cull_, view_);
  }
  next_ = frame + 1;
  return view_;
}

}  // namespace occlude::render
