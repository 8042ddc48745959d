// Workers for an object that several threads share. What flows needs scratch of its own: rings of facets, constructed
// points, stretches of the forest.
//
// Guarantees: no two threads have one worker at once. A worker that throws is given up, because what it was at is half
// done. The pool keeps as many workers as there were threads at one time.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace flowcert::flow {

template <class Worker>
class WorkerPool {
 public:
  // Returns what `use` returns for a free worker, or for a new one from `make`.
  auto with(const auto& make, const auto& use) {
    std::unique_ptr<Worker> worker = take();
    if (!worker) worker = make();
    auto result = use(*worker);
    give(std::move(worker));
    return result;
  }
  void give(std::unique_ptr<Worker> worker) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(std::move(worker));
  }
  // No worker may be at work.
  void clear() { free_.clear(); }

 private:
  std::unique_ptr<Worker> take() {
    const std::scoped_lock lock(mutex_);
    if (free_.empty()) return nullptr;
    std::unique_ptr<Worker> worker = std::move(free_.back());
    free_.pop_back();
    return worker;
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<Worker>> free_;
};

}  // namespace flowcert::flow
