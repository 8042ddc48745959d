#include "oracle/program/out_of_memory.h"

#include <gmp.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>

namespace oracle {

namespace {

void* take(std::size_t bytes) {
  void* const memory = std::malloc(bytes);
  if (memory == nullptr) end_out_of_memory();
  return memory;
}

void* take_more(void* memory, std::size_t, std::size_t bytes) {
  void* const moved = std::realloc(memory, bytes);
  if (moved == nullptr) end_out_of_memory();
  return moved;
}

void give_back(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void prepare_for_out_of_memory() {
  mp_set_memory_functions(take, take_more, give_back);
  std::set_new_handler(end_out_of_memory);
}

void end_out_of_memory() {
  constexpr char kLine[] = "flowcert-oracle: out of memory\n";
  (void)!::write(STDERR_FILENO, kLine, sizeof kLine - 1);
  ::_exit(2);
}

}  // namespace oracle
