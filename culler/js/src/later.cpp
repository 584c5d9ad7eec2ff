// SPDX-License-Identifier: MIT
// Tasks of held culls, which JavaScript keeps until it has time. It cannot pass a function of its own to C, nor call one by
// its pointer, so both are functions with names.
#include "occlude.h"

extern "C" {

// occlude_held_options.later, of the module's surroundings.
__attribute__((import_module("occlude"), import_name("later"))) void occlude_js_later(void* context, occlude_task task,
                                                                                      void* work);

/// Where the function is that leaves tasks to JavaScript.
OCCLUDE_API void (*occlude_js_later_function())(void*, occlude_task, void*) { return occlude_js_later; }

/// Calls a task that was left.
OCCLUDE_API void occlude_js_run(occlude_task task, void* work) { task(work); }

// In place of the runtime's, which prints, and for that brings all of printf.
[[noreturn]] void abort_message(const char*, ...) { __builtin_trap(); }

}  // extern "C"
