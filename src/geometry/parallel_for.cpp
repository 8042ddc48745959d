// oneTBB shares the parts out. Debian's build of it is not instrumented, so that ThreadSanitizer would report races
// that are none. Builds for ThreadSanitizer use std::thread instead, for the same parts.
#include "geometry/parallel_for.h"

#include <algorithm>
#include <thread>

#include "geometry/floating_point.h"

#ifdef FLOWCERT_STD_THREADS
#include <atomic>
#include <exception>
#include <mutex>
#include <vector>
#else
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace flowcert::geometry {

namespace {

#ifdef FLOWCERT_STD_THREADS

void share_out(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex failing;
  std::exception_ptr failure;
  const auto run = [&] {
    for (std::size_t k = next.fetch_add(1); k < count; k = next.fetch_add(1)) {
      try {
        work(k);
      } catch (...) {
        const std::scoped_lock lock(failing);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  for (unsigned k = 1; k < threads; ++k) others.emplace_back(run);
  run();
  for (std::thread& other : others) other.join();
  if (failure) std::rethrow_exception(failure);
}

#else

void share_out(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  // Without it oneTBB prints a warning where more threads than cores are asked for.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::max(threads, all_cores()));
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, work, tbb::simple_partitioner()); });
}

#endif

}  // namespace

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  threads = static_cast<unsigned>(std::min<std::size_t>(threads, count));
  if (threads > 1) {
    // Filters need rounding to nearest, in every thread.
    return share_out(count, threads, [&work](std::size_t k) {
      require_ieee_doubles();
      work(k);
    });
  }
  for (std::size_t k = 0; k < count; ++k) work(k);
}

unsigned all_cores() { return std::max(1u, std::thread::hardware_concurrency()); }

}  // namespace flowcert::geometry
