// SPDX-License-Identifier: MIT
// The header in C++ without exceptions and RTTI: what C tests do with it, compiled as C++.
#include "scene_test.c"

static_assert(noexcept(occlude_version()), "programs without exceptions");
