// How far work is that takes long.
#pragma once

#include <cstddef>
#include <functional>

namespace flowcert {

// Called by one thread at a time; `done` ascends. It may be empty, and it may throw to end the work.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace flowcert
