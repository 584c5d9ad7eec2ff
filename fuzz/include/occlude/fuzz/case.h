// SPDX-License-Identifier: MIT
// The fuzzer makes cases, so it uses the names of oracle/cases as its own.
#pragma once

#include "cases/case.h"

namespace occlude::fuzz {

using namespace cases;

}  // namespace occlude::fuzz
