// SPDX-License-Identifier: MIT
// Ranks of a program that was built without MPI: there is one, and it has no helpers.
#include "helpers.h"
#include "occlude/render/errors.h"
#include "occlude/render/ranks.h"

namespace occlude::render {
namespace {

void require_one_rank() {
  if (ranks() > 1) throw InputError("mpirun: this program was built without MPI, and works in one process only");
}

}  // namespace

Helpers::Helpers(Dealer&, StageKey) { require_one_rank(); }

void help(StageKey, const std::function<std::string(const std::string&)>&) { require_one_rank(); }

void tell_first_rank(const std::string&) {}

void leave_ranks() {}

}  // namespace occlude::render
