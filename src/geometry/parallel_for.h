// A loop over independent parts, on several threads.
//
// Guarantees: work(k) is called once for each k below `count`, on at most `threads` threads, the caller's among them;
// on fewer where the system gives no more. With one thread, all calls come in order on the caller's, and no thread is
// started: a campaign forks after that. An exception of a part is thrown again when all other parts have ended or been
// given up. Every part computes with doubles as IEEE 754 says (IeeeDoubles). All parallel loops of the project are
// calls of this.
#pragma once

#include <cstddef>
#include <functional>

namespace flowcert::geometry {

void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

// The number of threads that the machine has cores for; at least 1.
[[nodiscard]] unsigned all_cores();

}  // namespace flowcert::geometry
