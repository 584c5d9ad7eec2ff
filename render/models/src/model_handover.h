// SPDX-License-Identifier: MIT
// A model on its way from the child process that has read it.
#pragma once

#include "handover.h"
#include "occlude/render/model.h"

namespace occlude::render {

void hand_over(const Model& model, HandoverWriter& writer);

/// Reads what hand_over() wrote: the soup is well formed and its vertices are legal, else it throws ChildFailure.
void take_over(Model& model, HandoverReader& reader);

}  // namespace occlude::render
