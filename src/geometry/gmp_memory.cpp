// The C library's functions are what GMP takes by itself, so numbers that are there already can be given back by these.
#include "geometry/gmp_memory.h"

#include <gmp.h>

#include <cstdlib>

#include "geometry/take_as_new_does.h"

// GMP has no public name for what it takes by itself.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" void* __gmp_default_allocate(std::size_t);

namespace flowcert::geometry {

namespace {

void* resize(void* memory, std::size_t bytes) {
  return take_as_new_does([=] { return std::realloc(memory, bytes); });
}

void* take(std::size_t bytes) { return resize(nullptr, bytes); }
void* take_more(void* memory, std::size_t, std::size_t bytes) { return resize(memory, bytes); }
void give_back(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void let_gmp_fail_as_new_does() {
  void* (*current)(std::size_t) = nullptr;
  mp_get_memory_functions(&current, nullptr, nullptr);
  if (current == __gmp_default_allocate) mp_set_memory_functions(take, take_more, give_back);
}

}  // namespace flowcert::geometry
