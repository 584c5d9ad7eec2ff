// SPDX-License-Identifier: MIT
// The fuzzer makes cases: their words (oracle/cases) are its own.
#pragma once

#include "cases/case.h"

namespace occlude::fuzz {

using namespace cases;

}  // namespace occlude::fuzz
