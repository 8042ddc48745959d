// Takes memory as `new` does.
//
// Guarantees: where `take` finds none, the handler of std::set_new_handler is called, and it is tried again. Without a
// handler std::bad_alloc is thrown. Never null.
#pragma once

#include <new>

#include "geometry/layer.h"

namespace flowcert::geometry {

template <typename Take>
[[nodiscard]] void* take_as_new_does(const Take& take) {
  while (true) {
    if (void* const memory = take()) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

}  // namespace flowcert::geometry
