// SPDX-License-Identifier: MIT
#include "occlude/oracle/memory.h"

#include <CGAL/Gmpzf.h>
#include <gmp.h>

#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <new>

namespace occlude::oracle {
namespace {

void* checked(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

/// The first difference of two numbers on a thread registers a destructor, for which the C library ends the program when it
/// finds no memory. Until then about ten small pieces are taken. Where memory is short, each may take a page of its own from
/// the system. That there is more is found out before, where an exception can say that there is not.
void register_destructors() {
  constexpr std::size_t kPage = 4096, kPages = 32;
  void* volatile enough = checked(std::malloc(kPages * kPage));  // volatile: else compilers may leave both lines out
  std::free(enough);
  CGAL::Gmpzf one(1);
  one -= CGAL::Gmpzf(0.5);
}

void prepare_thread() {
  static thread_local bool is_prepared = false;
  if (is_prepared) return;
  is_prepared = true;  // the numbers ask for memory themselves
  try {
    register_destructors();
  } catch (...) {
    is_prepared = false;
    throw;
  }
}

// The libraries are C. They are compiled so that exceptions pass through them, and the functions that ask for memory hold
// nothing that must be given back.

void* allocate(std::size_t bytes) {
  prepare_thread();
  return checked(std::malloc(bytes));
}
void* reallocate(void* memory, std::size_t, std::size_t bytes) { return checked(std::realloc(memory, bytes)); }
void release(void* memory, std::size_t) { std::free(memory); }

}  // namespace

// MPFR takes its memory from GMP. CGAL computes exact numbers within std::call_once(): the first exception through that
// makes the C library load what it unwinds with, or end the program where there is no memory for it.
void throw_when_memory_is_out() {
  mp_set_memory_functions(allocate, reallocate, release);
  try {
    std::once_flag once;
    std::call_once(once, [] { throw std::bad_alloc(); });
  } catch (const std::bad_alloc&) {  // as was asked
  }
}

}  // namespace occlude::oracle
