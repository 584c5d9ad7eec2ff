// SPDX-License-Identifier: MIT
// What is kept of a view from frame to frame: the last frame, and a memory for each method.
#pragma once

#include <memory>

#include "cover/cover_frame.h"
#include "cover/cover_painter.h"
#include "cover/idle_nodes.h"
#include "cover/worth_of_hiding.h"
#include "descent/frame.h"
#include "frusta/frusta_memory.h"
#include "occlude/culler/culler.h"

namespace occlude::culler {

struct View::Memory {
  std::weak_ptr<const void> owner;  ///< the culler of the last frame
  Frame frame;
  FrustaMemory frusta;
  CoverMemory cover;
  CoverLeaves leaves;
  WorthOfHiding worth;
  IdleNodes idle;
};

/// What is kept of the view. Not protected by `const`.
[[nodiscard]] View::Memory& memory_of(const View& view);
/// The same for the next frame with a culler, of which all copies share `owner`, and no other culler does. Emptied unless
/// the frame before was with the same one.
[[nodiscard]] View::Memory& memory_for(const View& view, const std::shared_ptr<const void>& owner);

}  // namespace occlude::culler
