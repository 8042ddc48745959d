// `new` takes memory from malloc, and tells the system what of it is new. Small blocks are parts of the heap, which
// grows by 32 MiB and never shrinks, so that it is told once of each part. Threads have heaps of their own, and it is
// told of all of such a heap. What is larger than 4 MiB is mapped alone.
//
// glibc does the same, if GLIBC_TUNABLES has glibc.malloc.hugetlb=1 before the program begins; no call asks for it.
// jemalloc has a setting. But version 5.3 dies of a signal where an address space of 32 MiB is too small for it, which
// is too little for nothing else, and small inputs took half as much memory again.
#include "cli/huge_pages.h"

#include <new>

// Address and thread sanitizer want `new` for themselves.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <climits>
#include <cstdint>
#include <cstdlib>

#include "geometry/take_as_new_does.h"

namespace {

constexpr std::size_t kMappedAlone = std::size_t{4} << 20;
constexpr int kHeapGrowth = 32 << 20;
// Where glibc has heaps for threads, each begins at a multiple of this.
constexpr std::uintptr_t kHeapOfThread = std::uintptr_t{64} << 20;
constexpr std::uintptr_t kPage = 4096;
// Fewer addresses are not taken ahead of their use.
constexpr rlim_t kManyAddresses = rlim_t{1} << 30;

// Addresses of the heap below this one were told of. Until the program begins nothing is told of.
std::atomic<std::uintptr_t> told_of = ~std::uintptr_t{0};

std::uintptr_t heap_end() { return reinterpret_cast<std::uintptr_t>(::sbrk(0)); }

// The system may refuse; then pages are small.
void ask_for_huge_pages(std::uintptr_t begin, std::uintptr_t end) {
  begin &= ~(kPage - 1);
  ::madvise(reinterpret_cast<void*>(begin), (end - begin + kPage - 1) & ~(kPage - 1), MADV_HUGEPAGE);
}

[[gnu::noinline]] void tell_of(std::uintptr_t block, std::size_t size) {
  const std::uintptr_t end = heap_end();
  if (block < end) {
    const std::uintptr_t begin = told_of.exchange(end, std::memory_order_relaxed);
    if (begin < end) ask_for_huge_pages(begin, end);
  } else if (size >= kMappedAlone) {
    ask_for_huge_pages(block, block + size);
  } else if (thread_local std::uintptr_t told = 0; told != (block & ~(kHeapOfThread - 1))) {
    told = block & ~(kHeapOfThread - 1);
    ask_for_huge_pages(told, told + kHeapOfThread);
  }
}

void* taken(std::size_t size, const auto& take) {
  void* const memory = flowcert::geometry::take_as_new_does(take);
  const auto block = reinterpret_cast<std::uintptr_t>(memory);
  if (block + size > told_of.load(std::memory_order_relaxed)) tell_of(block, size);
  return memory;
}

}  // namespace

// glibc has a block for a size of 0, too, and any size for an alignment.
void* operator new(std::size_t size) {
  return taken(size, [size] { return std::malloc(size); });
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return taken(size, [=] { return std::aligned_alloc(static_cast<std::size_t>(alignment), size); });
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

void flowcert::cli::prepare_for_huge_pages() {
  rlimit addresses{};
  if (::getrlimit(RLIMIT_AS, &addresses) != 0 || addresses.rlim_cur < kManyAddresses) return;
  ::mallopt(M_TOP_PAD, kHeapGrowth);
  ::mallopt(M_TRIM_THRESHOLD, INT_MAX);
  ::mallopt(M_MMAP_THRESHOLD, static_cast<int>(kMappedAlone));
  told_of = heap_end();
}
#else
void flowcert::cli::prepare_for_huge_pages() {}
#endif
