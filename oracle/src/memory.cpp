// SPDX-License-Identifier: MIT
#include "occlude/oracle/memory.h"

#include <gmp.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace occlude::oracle {
namespace {

void* checked(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// The libraries are C. They are compiled so that exceptions pass through them, and the functions that ask for memory hold
// nothing that must be given back.

void* allocate(std::size_t bytes) { return checked(std::malloc(bytes)); }
void* reallocate(void* memory, std::size_t, std::size_t bytes) { return checked(std::realloc(memory, bytes)); }
void release(void* memory, std::size_t) { std::free(memory); }

}  // namespace

// MPFR takes its memory from GMP.
void throw_when_memory_is_out() { mp_set_memory_functions(allocate, reallocate, release); }

}  // namespace occlude::oracle
