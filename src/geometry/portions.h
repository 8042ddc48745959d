// Hands out the numbers below a count in portions, to threads that ask for the next one when they are done. Numbers
// that follow one another go to one thread, because what they stand for lies together in memory.
//
// Guarantees: each number is handed out once. The progress is reported by one thread at a time, and ascends. Where it
// throws, nothing more is handed out, so that all threads stop soon.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <tuple>
#include <utility>

#include "flowcert/progress.h"
#include "geometry/parallel_for.h"

namespace flowcert::geometry {

// How many numbers a thread takes at a time, where so many are usual. ThreadSanitizer's build takes few, so that
// several threads share small inputs, too.
constexpr std::size_t portion_size(std::size_t usual) {
#ifdef FLOWCERT_SMALL_PORTIONS
  return std::min<std::size_t>(usual, 4);
#else
  return usual;
#endif
}

class Portions {
 public:
  // progress may be empty. It must outlive this.
  Portions(std::size_t count, std::size_t size, const Progress& progress)
      : count_(count), size_(size), progress_(progress) {}

  // First and last + 1; equal at the end.
  [[nodiscard]] std::pair<std::size_t, std::size_t> next() {
    if (!progress_) return take();
    const std::scoped_lock lock(telling_);
    const auto portion = take();
    try {
      if (portion.first < count_) progress_(portion.first, count_);
    } catch (...) {
      stop();
      throw;
    }
    return portion;
  }

  // Nothing more is handed out.
  void stop() { next_ = count_; }

 private:
  [[nodiscard]] std::pair<std::size_t, std::size_t> take() {
    const std::size_t first = std::min(next_.fetch_add(size_, std::memory_order_relaxed), count_);
    return {first, std::min(first + size_, count_)};
  }

  std::size_t count_, size_;
  const Progress& progress_;
  std::atomic<std::size_t> next_{0};
  std::mutex telling_;
};

// Calls use(thread, k) once for each k below the count, on so many threads, which are numbered from 0 on.
void in_portions(unsigned threads, std::size_t count, std::size_t size, const Progress& progress, const auto& use) {
  threads = std::max(threads, 1U);
  Portions portions(count, size, progress);
  parallel_for(threads, threads, [&](std::size_t thread) {
    for (auto [at, end] = portions.next(); at != end; std::tie(at, end) = portions.next()) {
      for (; at != end; ++at) use(thread, at);
    }
  });
}

}  // namespace flowcert::geometry
