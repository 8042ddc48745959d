// Threads of the C++ library. oneTBB is not used, because it ends the program where a thread cannot be had.
#include "geometry/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "geometry/floating_point.h"

namespace flowcert::geometry {

namespace {

class SharedOut {
 public:
  SharedOut(std::size_t count, const std::function<void(std::size_t)>& work) : count_(count), work_(work) {}

  void run(unsigned threads) {
    std::vector<std::thread> others;
    while (others.size() + 1 < threads && start_one(others)) {
    }
    take_parts();
    for (std::thread& other : others) other.join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  // Whether there was a thread to be had, and memory for it. Those that run share all parts.
  bool start_one(std::vector<std::thread>& others) {
    try {
      others.emplace_back([this] { take_parts(); });
      return true;
    } catch (const std::system_error&) {
      return false;
    } catch (const std::bad_alloc&) {
      return false;
    }
  }
  void take_parts() {
    try {
      const IeeeDoubles ieee;
      for (std::size_t k = next_.fetch_add(1); k < count_; k = next_.fetch_add(1)) work_(k);
    } catch (...) {
      const std::scoped_lock lock(failing_);
      if (!failure_) failure_ = std::current_exception();
      next_ = count_;
    }
  }

  const std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::mutex failing_;
  std::exception_ptr failure_;
};

}  // namespace

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  threads = static_cast<unsigned>(std::min<std::size_t>(threads, count));
  if (threads > 1) return SharedOut(count, work).run(threads);
  const IeeeDoubles ieee;
  for (std::size_t k = 0; k < count; ++k) work(k);
}

unsigned all_cores() { return std::max(1u, std::thread::hardware_concurrency()); }

}  // namespace flowcert::geometry
