// SPDX-License-Identifier: MIT
// What is kept of a view from frame to frame: the last frame, and a memory for each method.
#pragma once

#include "cover/cover_frame.h"
#include "cover/cover_painter.h"
#include "descent/frame.h"
#include "frusta/frusta_memory.h"
#include "occlude/culler/view.h"

namespace occlude::culler {

struct View::Memory {
  Frame frame;
  FrustaMemory frusta;
  CoverMemory cover;
  CoverLeaves leaves;
};

}  // namespace occlude::culler
