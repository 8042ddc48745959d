#include "io/out_of_memory.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <new>

#include "geometry/gmp_memory.h"
#include "io/diagnostic.h"
#include "io/output_file.h"

namespace flowcert::io {

namespace {

const char* program_name = "";
std::atomic<bool> is_ending = false;
thread_local int throwing = 0;

void find_no_memory() {
  if (throwing > 0) throw std::bad_alloc();
  end_out_of_memory();
}

}  // namespace

void prepare_for_out_of_memory(const char* program) {
  program_name = program;
#ifdef M_ARENA_MAX
  // glibc gives each thread 64 MB of addresses. Where they cannot be had it maps pages for each number, which takes ten
  // times as long.
  rlimit addresses{};
  if (::getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY) ::mallopt(M_ARENA_MAX, 1);
#endif
  std::set_new_handler(find_no_memory);
  let_gmp_fail_as_new_does();
}

void end_out_of_memory() {
  // Another thread that finds no memory, too, waits for the end.
  while (is_ending.exchange(true)) ::pause();
  remove_temporaries();
  tell(program_name);
  tell(": out of memory\n");
  ::_exit(kOutOfMemoryStatus);
}

ThrowsOutOfMemory::ThrowsOutOfMemory() { ++throwing; }
ThrowsOutOfMemory::~ThrowsOutOfMemory() { --throwing; }

}  // namespace flowcert::io
